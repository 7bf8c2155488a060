// SPDX-License-Identifier: MIT
//
// One frame of a capture, read and brought to the conventions of reprise.h.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "lab/capture/description.h"
#include "lab/capture/exr_file.h"
#include "lab/float_image.h"

namespace reprise::lab {

// Texels that were no numbers and what they were replaced by: colour by the mean of its finite
// neighbours in 3x3 (0 without one), depth by the background, motion by 0.
struct Repairs {
  uint64_t color = 0;
  uint64_t depth = 0;
  uint64_t motion = 0;

  uint64_t total() const { return color + depth + motion; }
  void add(const Repairs& other);
};

struct CaptureFrame {
  ExrImage file;  // as read: other layers and metadata with it
  bool color_is_half = true;
  std::vector<uint8_t> color;   // RGBA texels, half or float as the file has them, alpha 1
  std::vector<float> depth;     // of description.depthKind()
  std::vector<float> motion;    // interleaved, px: prev_px = px + motion
  std::vector<float> reactive;  // empty: none
  std::vector<uint32_t> id;     // empty: none
  Repairs repairs;
};

// Whether all of R, G and B are stored as half.
bool colorIsHalf(const ExrImage& file, const CaptureDescription& description);

// Throws CaptureError, naming file, frame and field: absent or damaged file, another extent, absent
// channel, motion larger than the image.
CaptureFrame readCaptureFrame(const std::filesystem::path& directory,
                              const CaptureDescription& description, size_t index);

// The reference of frame `index` as linear RGB. Throws as readCaptureFrame does.
FloatImage readCaptureReference(const std::filesystem::path& directory,
                                const CaptureDescription& description, size_t index);

}  // namespace reprise::lab
