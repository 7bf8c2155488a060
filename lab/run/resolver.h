// SPDX-License-Identifier: MIT
//
// A library context in the lab's hands: plans a frame, records its resolve, owns the output image.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lab/frame_inputs.h"
#include "lab/run/technique_choice.h"
#include "lab/vk/device.h"
#include "lab/vk/image.h"
#include "lab/vk/timestamps.h"
#include "reprise/reprise.hpp"

namespace reprise::lab {

class Resolver {
 public:
  // `output_extent` {0, 0}: the source's. Throws UsageError when the technique cannot work on this
  // source, ApiError when the library fails.
  Resolver(Device& device, const TechniqueChoice& choice, const SourceInfo& source,
           VkExtent2D output_extent = {});

  const TechniqueChoice& choice() const { return choice_; }
  Device& device() const { return device_; }
  // For what the lab does not do itself: resets, resizes, other settings. output() keeps its
  // extent.
  OwnedContext& context() { return context_; }
  // The plan's request, if the technique makes any, is timed as record's passes are.
  SamplePlan plan(uint32_t frame_index, Timestamps* timestamps = nullptr);
  // Records the resolve of `inputs` into output(). With `timestamps`, its passes are timed by name.
  void record(VkCommandBuffer commands, const FrameInputs& inputs, Timestamps* timestamps);
  // RGBA32F: what is measured is the technique, not the rounding of its output.
  const Image& output() const { return output_; }

  std::vector<RepriseMemoryItem> memory() const { return context_.memory(); }
  uint64_t historyBytes() const;
  const std::vector<std::string>& passNames() const { return pass_names_; }
  // Every setting as it stands, in the table's order.
  std::vector<std::pair<const RepriseSettingInfo*, double>> settings() const;

 private:
  Device& device_;
  TechniqueChoice choice_;
  OwnedContext context_;
  Image output_;
  RepriseFrame frameOf(const FrameInputs& inputs, Timestamps* timestamps);

  std::vector<std::string> pass_names_;
  std::array<RepriseImage, REPRISE_MAX_MOTION_BACK> motion_back_{};
  // Queries reserved by this frame's request, for its record to share.
  std::optional<uint32_t> reserved_;
};

}  // namespace reprise::lab
