// SPDX-License-Identifier: MIT
//
// Live frames as a capture: the formats of the live images, so that filtering from disk gives bit
// for bit what the live run gives.
#pragma once

#include <filesystem>
#include <string>

#include "lab/capture/description.h"
#include "lab/float_image.h"
#include "lab/frame_inputs.h"
#include "lab/vk/device.h"

namespace reprise::lab {

class CaptureWriter {
 public:
  // `plan` is the technique, with its settings, that the frames are sampled for. With `resume`,
  // files that are there and whole stay. Throws CaptureError.
  CaptureWriter(std::filesystem::path directory, const SourceInfo& source, std::string plan,
                bool resume);

  // After the work of the frame has finished. Frames come in order from index 0.
  void add(Device& device, const FrameInputs& inputs);
  // Of the frame added last.
  void addReference(const FloatImage& reference);
  // Writes capture.json: until then the directory is no capture.
  void finish();

  uint32_t kept() const { return kept_; }

 private:
  bool isWhole(const std::filesystem::path& path) const;

  std::filesystem::path directory_;
  CaptureDescription description_;
  bool resume_;
  uint32_t kept_ = 0;
};

}  // namespace reprise::lab
