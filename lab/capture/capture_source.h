// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <future>
#include <optional>
#include <string>
#include <vector>

#include "lab/capture/capture_frame.h"
#include "lab/capture/layouts.h"
#include "lab/frame_inputs.h"
#include "lab/vk/buffer.h"
#include "lab/vk/image.h"

namespace reprise::lab {

// A sequence from disk as a sequence of frames. The plan is not honoured: the frames were sampled
// when they were written, and their jitter is the file's. The next frame is read while one is
// worked on.
class CaptureSource final : public FrameSource {
 public:
  // Throws CaptureError. Every frame's file is looked for before the first is read.
  CaptureSource(Device& device, std::filesystem::path directory,
                CaptureLayout layout = CaptureLayout::kAuto);

  const SourceInfo& info() const override { return info_; }
  FrameInputs frame(VkCommandBuffer commands, uint32_t index, const SamplePlan& plan) override;
  std::optional<FloatImage> reference(uint32_t index) override;
  FrameGeometry geometry(uint32_t index) override;

  const CaptureDescription& description() const { return description_; }
  // The frame that frame() gave last.
  const CaptureFrame& current() const { return frame_; }
  // What had to be assumed or was read around, a line each; what was repaired is in repairs().
  const std::vector<std::string>& warnings() const { return warnings_; }
  const Repairs& repairs() const { return repairs_; }

 private:
  CaptureFrame take(uint32_t index);

  Device& device_;
  std::filesystem::path directory_;
  CaptureDescription description_;
  SourceInfo info_;
  std::vector<std::string> warnings_;
  CaptureFrame frame_;
  Repairs repairs_;
  std::optional<uint32_t> ahead_index_;
  std::future<CaptureFrame> ahead_;
  bool color_is_half_ = true;
  Image color_, depth_, motion_, reactive_, id_;
  Buffer staging_;
};

}  // namespace reprise::lab
