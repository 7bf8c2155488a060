// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
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
  bool depth_write = true;
  // Pixels a side that a fragment is shaded for at once; above 1 where Device::hasFragmentSize.
  uint32_t fragment_size = 1;
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
  // What was bound before stays.
  template <typename Constants>
  void pushConstants(VkCommandBuffer commands, const Constants& constants) const {
    layout_.pushConstants(commands, &constants, sizeof(Constants));
  }

 private:
  Device* device_ = nullptr;
  ProgramLayout layout_;
  VkPipeline pipeline_ = VK_NULL_HANDLE;
};

// What is rendered to: whole images.
struct RenderTargets {
  const Image* color = nullptr;  // null: depth only
  const Image* depth = nullptr;
  VkClearColorValue clear_color{};
  std::optional<float> clear_depth;  // none: depth is what it was
  VkRect2D viewport{};               // {}: the whole images
};
void beginRendering(VkCommandBuffer commands, const RenderTargets& targets);
// Cleared: colour to 0, depth to `clear_depth`. `color` may be null.
void beginRendering(VkCommandBuffer commands, const Image* color, const Image& depth,
                    float clear_depth);
void endRendering(VkCommandBuffer commands);

}  // namespace reprise::lab
