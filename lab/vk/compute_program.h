// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lab/vk/bindings.h"

namespace reprise::lab {

struct ComputeProgramInfo {
  const char* name = "";
  std::span<const uint32_t> spirv;
  std::vector<VkDescriptorType> bindings;
  uint32_t push_bytes = 0;               // at most 128
  std::vector<uint32_t> specialization;  // constant_id i = element i
};

// A compute shader of 8 x 8 invocations a group.
class ComputeProgram {
 public:
  ComputeProgram() = default;
  ComputeProgram(Device& device, const ComputeProgramInfo& info);
  ~ComputeProgram();
  ComputeProgram(ComputeProgram&& other) noexcept { *this = std::move(other); }
  ComputeProgram& operator=(ComputeProgram&& other) noexcept;

  // One invocation a pixel of `extent`, no barrier.
  template <typename Constants>
  void dispatch(VkCommandBuffer commands, VkExtent2D extent, const std::vector<Bound>& bound,
                const Constants& constants) const {
    record(commands, extent, bound, &constants, sizeof(Constants));
  }
  void dispatch(VkCommandBuffer commands, VkExtent2D extent,
                const std::vector<Bound>& bound) const {
    record(commands, extent, bound, nullptr, 0);
  }
  // As many groups as the first words of `arguments` say, of the size that the shader has.
  template <typename Constants>
  void dispatchIndirect(VkCommandBuffer commands, VkBuffer arguments,
                        const std::vector<Bound>& bound, const Constants& constants) const {
    recordIndirect(commands, arguments, bound, &constants, sizeof(Constants));
  }

 private:
  void record(VkCommandBuffer commands, VkExtent2D extent, const std::vector<Bound>& bound,
              const void* constants, uint32_t constant_bytes) const;

  void recordIndirect(VkCommandBuffer commands, VkBuffer arguments, const std::vector<Bound>& bound,
                      const void* constants, uint32_t constant_bytes) const;

  Device* device_ = nullptr;
  ProgramLayout layout_;
  VkPipeline pipeline_ = VK_NULL_HANDLE;
};

// Shared by programs of every kind.
VkShaderModule createShaderModule(Device& device, std::span<const uint32_t> spirv);

}  // namespace reprise::lab
