// SPDX-License-Identifier: MIT
#pragma once

#include <vulkan/vulkan_core.h>

namespace reprise {

// Every device-level call that the library makes. Nothing else of Vulkan is linked.
#define REPRISE_DEVICE_FUNCTIONS(X) \
  X(AllocateDescriptorSets)         \
  X(AllocateMemory)                 \
  X(BindBufferMemory)               \
  X(BindImageMemory)                \
  X(CmdBindDescriptorSets)          \
  X(CmdBindPipeline)                \
  X(CmdClearColorImage)             \
  X(CmdDispatch)                    \
  X(CmdFillBuffer)                  \
  X(CmdPipelineBarrier)             \
  X(CmdUpdateBuffer)                \
  X(CmdWriteTimestamp)              \
  X(CreateBuffer)                   \
  X(CreateComputePipelines)         \
  X(CreateDescriptorPool)           \
  X(CreateDescriptorSetLayout)      \
  X(CreateImage)                    \
  X(CreateImageView)                \
  X(CreatePipelineLayout)           \
  X(CreateSampler)                  \
  X(CreateShaderModule)             \
  X(DestroyBuffer)                  \
  X(DestroyDescriptorPool)          \
  X(DestroyDescriptorSetLayout)     \
  X(DestroyImage)                   \
  X(DestroyImageView)               \
  X(DestroyPipeline)                \
  X(DestroyPipelineLayout)          \
  X(DestroySampler)                 \
  X(DestroyShaderModule)            \
  X(FreeMemory)                     \
  X(GetBufferMemoryRequirements)    \
  X(GetImageMemoryRequirements)     \
  X(MapMemory)                      \
  X(UpdateDescriptorSets)

struct VulkanFunctions {
#define REPRISE_MEMBER(name) PFN_vk##name name = nullptr;
  REPRISE_DEVICE_FUNCTIONS(REPRISE_MEMBER)
#undef REPRISE_MEMBER
  PFN_vkGetPhysicalDeviceMemoryProperties GetPhysicalDeviceMemoryProperties = nullptr;
  PFN_vkGetPhysicalDeviceProperties GetPhysicalDeviceProperties = nullptr;
  PFN_vkGetPhysicalDeviceFormatProperties GetPhysicalDeviceFormatProperties = nullptr;

  // The name of a function that the host's loader does not give, or nullptr when all were found.
  const char* load(VkInstance instance, VkDevice device,
                   PFN_vkGetInstanceProcAddr get_instance_proc_addr);
};

}  // namespace reprise
