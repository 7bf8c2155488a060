// SPDX-License-Identifier: MIT
#include "core/vulkan_functions.h"

namespace reprise {

const char* VulkanFunctions::load(VkInstance instance, VkDevice device,
                                  PFN_vkGetInstanceProcAddr get_instance_proc_addr) {
  const auto get_device_proc_addr = reinterpret_cast<PFN_vkGetDeviceProcAddr>(
      get_instance_proc_addr(instance, "vkGetDeviceProcAddr"));
  if (get_device_proc_addr == nullptr) return "vkGetDeviceProcAddr";

#define REPRISE_LOAD_INSTANCE(name)                                                    \
  name = reinterpret_cast<PFN_vk##name>(get_instance_proc_addr(instance, "vk" #name)); \
  if (name == nullptr) return "vk" #name;
  REPRISE_LOAD_INSTANCE(GetPhysicalDeviceMemoryProperties)
  REPRISE_LOAD_INSTANCE(GetPhysicalDeviceProperties)
  REPRISE_LOAD_INSTANCE(GetPhysicalDeviceFormatProperties)
#undef REPRISE_LOAD_INSTANCE

#define REPRISE_LOAD(name)                                                         \
  name = reinterpret_cast<PFN_vk##name>(get_device_proc_addr(device, "vk" #name)); \
  if (name == nullptr) return "vk" #name;
  REPRISE_DEVICE_FUNCTIONS(REPRISE_LOAD)
#undef REPRISE_LOAD
  return nullptr;
}

}  // namespace reprise
