// SPDX-License-Identifier: MIT
//
// Frames and references in, figures out: per frame, and their means over all counted frames, the
// still and the moving ones.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "lab/float_image.h"

namespace reprise::lab {

// Frames at the start that do not count, where there are more: histories have not settled.
constexpr uint32_t kWarmUpFrames = 8;
// A frame is still when its median |motion| is below this.
constexpr float kStillMotion_px = 0.05f;

struct FrameFigures {
  uint32_t frame = 0;
  bool counted = false;
  bool still = false;
  double psnr = 0.0;
  double ssim = 0.0;    // NaN below 11 px
  double flip = 0.0;    // at kFlipPixelsPerDegree
  double flip30 = 0.0;  // at kFlipNearPixelsPerDegree
  double tpsnr = 0.0;   // NaN for the first frame
  double sharpness = 0.0;
  double temporal_squared_error = 0.0;  // what tpsnr is made of
};

struct MeanFigures {
  uint32_t frames = 0;
  double psnr = 0.0;          // mean of the frames' dB
  double psnr_of_mean = 0.0;  // dB of the frames' mean squared error
  double ssim = 0.0;
  double flip = 0.0;
  double flip30 = 0.0;
  double tpsnr = 0.0;  // dB of the mean squared temporal difference
  double sharpness = 0.0;
};

struct SequenceFigures {
  std::vector<FrameFigures> frames;
  std::optional<MeanFigures> mean, still, moving;  // absent without a counted frame of the kind
};

// `references` and `images` linear, RGB or RGBA, a frame each; median_motion_px likewise. Works on
// all threads of the machine. `on_error_map`, where given, gets each frame's FLIP error map at
// kFlipNearPixelsPerDegree, from any thread.
using ErrorMapHandler = std::function<void(size_t frame, const FloatImage& error)>;
SequenceFigures measureSequence(const std::vector<FloatImage>& references,
                                const std::vector<FloatImage>& images,
                                const std::vector<float>& median_motion_px,
                                const ErrorMapHandler& on_error_map = {});

}  // namespace reprise::lab
