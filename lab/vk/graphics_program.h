// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lab/vk/bindings.h"

namespace reprise::lab {

struct GraphicsProgramInfo {
  const char* name = "";
  std::span<const uint32_t> vertex_spirv;
  std::span<const uint32_t> fragment_spirv;  // empty: depth only
  std::vector<VkDescriptorType> bindings;  // seen by both stages; vertices are pulled from buffers
  uint32_t push_bytes = 0;
  VkFormat color_format = VK_FORMAT_UNDEFINED;  // UNDEFINED: depth only
  VkFormat depth_format = VK_FORMAT_D32_SFLOAT;
  VkCompareOp depth_compare = VK_COMPARE_OP_GREATER;  // reversed depth
  VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_1_BIT;
  float depth_bias_slope = 0.0f;         // added: this times the depth's slope a texel
  std::vector<uint32_t> specialization;  // constant_id i = element i, both stages
};

// Triangles without vertex input, rendered dynamically into one colour and one depth image.
class GraphicsProgram {
 public:
  GraphicsProgram() = default;
  GraphicsProgram(Device& device, const GraphicsProgramInfo& info);
  ~GraphicsProgram();
  GraphicsProgram(GraphicsProgram&& other) noexcept { *this = std::move(other); }
  GraphicsProgram& operator=(GraphicsProgram&& other) noexcept;

  void bind(VkCommandBuffer commands) const;
  template <typename Constants>
  void push(VkCommandBuffer commands, const std::vector<Bound>& bound,
            const Constants& constants) const {
    layout_.push(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, bound, &constants, sizeof(Constants));
  }

 private:
  Device* device_ = nullptr;
  ProgramLayout layout_;
  VkPipeline pipeline_ = VK_NULL_HANDLE;
};

// Begins rendering to whole images, cleared: colour to 0, depth to `clear_depth`. `color` may be
// null.
void beginRendering(VkCommandBuffer commands, const Image* color, const Image& depth,
                    float clear_depth);
void endRendering(VkCommandBuffer commands);

}  // namespace reprise::lab
