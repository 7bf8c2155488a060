// SPDX-License-Identifier: MIT
//
// What a renderer does between the antialiased picture and the display, one chain for every
// technique and for the reference: luminance adaptation, bloom, exposure, tone curve.
#pragma once

#include <cstdint>
#include <vector>

#include "lab/float_image.h"
#include "lab/vk/buffer.h"
#include "lab/vk/compute_program.h"
#include "lab/vk/image.h"
#include "lab/vk/timestamps.h"

namespace reprise::lab {

// A look, not a measurement: what a picture gets where nothing else is asked for.
struct PostSettings {
  // Share that the blurred picture has in the shown one, [0, 1]; light is spread, not added.
  float bloom = 0.04f;
  // Share that the coarser levels have in each level of the blur, [0, 1]: how far light goes.
  float bloom_spread = 0.7f;
  // Time constant of adaptation (s), above 0. Krawczyk et al. 2005: 0.4 for rods, 0.1 for cones.
  float adaptation_s = 0.4f;
};

class PostChain {
 public:
  PostChain(Device& device, VkExtent2D extent, const PostSettings& settings = {});

  // `color`: linear RGB of `extent`, readable by compute shaders. NaN and infinities are read as
  // black. With `reset` the eye has looked at this picture for long. Passes: "meter", "adapt",
  // "bloom", "show".
  void record(VkCommandBuffer commands, const Image& color, float frame_time_s, bool reset,
              Timestamps* timestamps) const;

  // RGBA32F, in the space of displayFromLinear, [0, 1).
  const Image& shown() const { return shown_; }
  uint32_t bloomLevels() const { return static_cast<uint32_t>(levels_.size()); }

 private:
  void bloom(VkCommandBuffer commands, const Image& color) const;

  PostSettings settings_;
  VkExtent2D groups_;
  Image shown_;
  std::vector<Image> levels_;  // half the extent, a quarter, ...
  Buffer sums_;
  Buffer eye_;
  ComputeProgram meter_;
  ComputeProgram adapt_;
  ComputeProgram down_;
  ComputeProgram up_;
  ComputeProgram show_;
};

}  // namespace reprise::lab
