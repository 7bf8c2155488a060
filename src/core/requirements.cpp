// SPDX-License-Identifier: MIT
#include "core/requirements.h"

#include "core/error.h"

namespace reprise {

// Vulkan 1.2 is what the shaders are compiled for. Writing a storage image without naming its
// format lets the host choose the output's format; every desktop driver and lavapipe offer it.
void describeRequirements(RepriseRequirements& requirements) {
  requirements.vulkan_version = VK_API_VERSION_1_2;
  requirements.device_extension_count = 0;
  requirements.device_extensions = nullptr;
  requirements.features = {};
  requirements.features.shaderStorageImageWriteWithoutFormat = VK_TRUE;
}

void checkDevice(VkInstance instance, VkPhysicalDevice physical_device,
                 PFN_vkGetInstanceProcAddr get_instance_proc_addr,
                 const RepriseRequirements& requirements) {
  const auto get_features = reinterpret_cast<PFN_vkGetPhysicalDeviceFeatures>(
      get_instance_proc_addr(instance, "vkGetPhysicalDeviceFeatures"));
  const auto get_properties = reinterpret_cast<PFN_vkGetPhysicalDeviceProperties>(
      get_instance_proc_addr(instance, "vkGetPhysicalDeviceProperties"));
  if (get_features == nullptr || get_properties == nullptr) {
    fail(REPRISE_ERROR_DEVICE, "get_instance_proc_addr does not give the device queries");
  }
  VkPhysicalDeviceProperties properties{};
  get_properties(physical_device, &properties);
  if (properties.apiVersion < requirements.vulkan_version) {
    fail(REPRISE_ERROR_UNSUPPORTED, "the device does not offer Vulkan 1.2");
  }
  VkPhysicalDeviceFeatures features{};
  get_features(physical_device, &features);
  if (features.shaderStorageImageWriteWithoutFormat == VK_FALSE) {
    fail(REPRISE_ERROR_UNSUPPORTED, "the device lacks shaderStorageImageWriteWithoutFormat");
  }
}

}  // namespace reprise
