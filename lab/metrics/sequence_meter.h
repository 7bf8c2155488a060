// SPDX-License-Identifier: MIT
//
// Frames and their truth in, figures out: per frame, their means over all counted frames, the still
// and the moving ones, and what only a sequence has.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lab/float_image.h"
#include "lab/metrics/convergence.h"
#include "lab/metrics/cvvdp/color_video_vdp.h"
#include "lab/metrics/jitter_residue.h"
#include "lab/metrics/metric_set.h"
#include "lab/metrics/sequence_truth.h"

namespace reprise::lab {

// Frames at the start that do not count, where there are more: histories have not settled.
constexpr uint32_t kWarmUpFrames = 8;
// A frame is still when its median |motion| is below this.
constexpr float kStillMotion_px = 0.05f;
// Ages that are reported one by one, and the oldest that `disoccluded` takes.
constexpr std::array<uint8_t, 5> kReportedAges = {1, 2, 4, 8, 16};
constexpr uint8_t kRecoveryFrames = 8;

// Of a figure that was not measured or is not defined here.
constexpr double kNoFigure = std::numeric_limits<double>::quiet_NaN();

struct FrameFigures {
  uint32_t frame = 0;
  bool counted = false;
  bool still = false;
  double psnr = kNoFigure;
  double ssim = kNoFigure;         // not below 11 px
  double flip = kNoFigure;         // at kFlipPixelsPerDegree
  double flip30 = kNoFigure;       // at kFlipNearPixelsPerDegree
  double tpsnr = kNoFigure;        // not in the first frame
  double flicker = kNoFigure;      // warpedFlicker
  double disoccluded = kNoFigure;  // PSNR of pixels of age 1 to kRecoveryFrames
  double sharpness = kNoFigure;
  double jod = kNoFigure;  // ColorVideoVDP
  // What figures are pooled from.
  double temporal_squared_error = kNoFigure;
  double cvvdp_quality = kNoFigure;
  AgeError disocclusion;
  std::array<AgeError, kReportedAges.size()> ages;
};

struct MeanFigures {
  uint32_t frames = 0;
  double psnr = kNoFigure;          // mean of the frames' dB
  double psnr_of_mean = kNoFigure;  // dB of the frames' mean squared error
  double ssim = kNoFigure;
  double flip = kNoFigure;
  double flip30 = kNoFigure;
  double tpsnr = kNoFigure;  // dB of the mean squared temporal difference
  double flicker = kNoFigure;
  double disoccluded = kNoFigure;  // dB of the mean squared error over the frames' pixels
  double sharpness = kNoFigure;
  double jod = kNoFigure;  // of the root of the frames' mean squared quality loss
};

// Every figure that frames and means share, by its name in results.json.
struct FigureInfo {
  const char* key;
  double FrameFigures::*frame;
  double MeanFigures::*mean;
};
constexpr std::array<FigureInfo, 9> kFigures = {{
    {"psnr", &FrameFigures::psnr, &MeanFigures::psnr},
    {"ssim", &FrameFigures::ssim, &MeanFigures::ssim},
    {"flip", &FrameFigures::flip, &MeanFigures::flip},
    {"flip30", &FrameFigures::flip30, &MeanFigures::flip30},
    {"tpsnr", &FrameFigures::tpsnr, &MeanFigures::tpsnr},
    {"flicker", &FrameFigures::flicker, &MeanFigures::flicker},
    {"disoccluded", &FrameFigures::disoccluded, &MeanFigures::disoccluded},
    {"sharpness", &FrameFigures::sharpness, &MeanFigures::sharpness},
    {"jod", &FrameFigures::jod, &MeanFigures::jod},
}};

struct AgeFigures {
  uint8_t age = 0;      // frames since something in front moved away; 1: the first in view
  uint64_t pixels = 0;  // of all counted frames
  double psnr = kNoFigure;
};

struct SequenceFigures {
  std::vector<FrameFigures> frames;
  std::optional<MeanFigures> mean, still, moving;  // absent without a counted frame of the kind
  std::vector<AgeFigures> ages;                    // kReportedAges, those that have pixels
  std::optional<Convergence> convergence;          // of the frames from the first to the next reset
  std::optional<JitterResidue> residue;            // of the last counted still frames in a row
  std::vector<std::pair<std::string, double>> cpu_s;  // by metric: thread time that it took
};

// Gets each frame's FLIP error map at kFlipNearPixelsPerDegree, from any thread.
using ErrorMapHandler = std::function<void(size_t frame, const FloatImage& error)>;

struct MeterOptions {
  MetricSet metrics = MetricSet::usual();
  // What Metric::kColorVideoVdp needs; without it `jod` stays no number.
  const ColorVideoVdp* color_video_vdp = nullptr;
  ErrorMapHandler on_error_map = {};  // called where Metric::kFlip30 is measured
};

// `images` linear, RGB or RGBA, a frame each, at most as many as `truth` has. Works on all threads
// of the machine. Throws std::invalid_argument where images and truth do not match.
SequenceFigures measureSequence(const SequenceTruth& truth, const std::vector<FloatImage>& images,
                                const MeterOptions& options = {});

}  // namespace reprise::lab
