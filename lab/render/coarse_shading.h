// SPDX-License-Identifier: MIT
//
// Shading below the pixels' rate: a coarse pixel and triangle at a time, or half the pixels.
#pragma once

#include <cstdint>
#include <vector>

#include "lab/render/frame_data.h"
#include "lab/vk/bindings.h"
#include "lab/vk/buffer.h"
#include "lab/vk/compute_program.h"
#include "lab/vk/image.h"

namespace reprise::lab {

class CoarseShading {
 public:
  CoarseShading() = default;
  // `size`: pixels a side of a coarse pixel; 1: a checkerboard. `types` and `specialization`: what
  // passes that shade have in common.
  CoarseShading(Device& device, uint32_t size, VkExtent2D extent,
                const std::vector<VkDescriptorType>& types,
                const std::vector<uint32_t>& specialization);

  bool ready() const { return size_ > 0; }
  // `bound` as `types`. Writes all of `color`; ends with a barrier.
  void record(VkCommandBuffer commands, const std::vector<Bound>& bound, const Image& color,
              const CoarseConstants& constants) const;

 private:
  uint32_t size_ = 0;
  VkExtent2D extent_{};
  Buffer items_;
  ComputeProgram list_program_;
  ComputeProgram shade_program_;  // of the list's items, or the checkerboard
};

}  // namespace reprise::lab
