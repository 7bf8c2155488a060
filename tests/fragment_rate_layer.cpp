// SPDX-License-Identifier: MIT
//
// A Vulkan layer that says of any device that it has VK_KHR_fragment_shading_rate with fragments of
// 2 x 2 pixels, and takes the wish for them out before the driver sees it: the driver shades every
// pixel. So the validation layer above sees what would reach such a device, and a shader that
// rounds to coarse pixels itself makes the image that such a device would make.
#include <vulkan/vk_layer.h>
#include <vulkan/vulkan.h>

#include <cstdio>
#include <cstring>
#include <map>
#include <string>
#include <vector>

namespace {

constexpr VkExtent2D kCoarse{2, 2};

// Looked up while the instance is made: afterwards the loader answers with the first layer's.
struct Instance {
  VkInstance handle = VK_NULL_HANDLE;
  PFN_vkGetInstanceProcAddr get = nullptr;
  PFN_vkDestroyInstance destroy = nullptr;
  PFN_vkEnumerateDeviceExtensionProperties enumerate_extensions = nullptr;
  PFN_vkGetPhysicalDeviceFeatures2 get_features = nullptr;
  PFN_vkGetPhysicalDeviceProperties2 get_properties = nullptr;
};

// By the loader's dispatch table, to which all handles of an instance, or of a device, begin by
// pointing. One thread uses this layer.
std::map<void*, Instance> instances;
std::map<void*, PFN_vkGetDeviceProcAddr> devices;

template <typename Handle>
void* keyOf(Handle handle) {
  return *reinterpret_cast<void**>(handle);
}

template <typename Function>
void lookUp(const Instance& instance, const char* name, Function& function) {
  function = reinterpret_cast<Function>(instance.get(instance.handle, name));
}

template <typename Function>
Function nextOfDevice(VkDevice device, const char* name) {
  return reinterpret_cast<Function>(devices.at(keyOf(device))(device, name));
}

// The loader's link to the next layer, in the chain of a create info.
template <typename Link>
Link* linkIn(const void* chain, VkStructureType type) {
  for (auto* link = static_cast<const Link*>(chain); link != nullptr;
       link = static_cast<const Link*>(link->pNext)) {
    if (link->sType == type && link->function == VK_LAYER_LINK_INFO) {
      return const_cast<Link*>(link);  // the loader expects layers to move it on
    }
  }
  return nullptr;
}

VkBaseOutStructure* findIn(const void* chain, VkStructureType type) {
  auto* found = static_cast<const VkBaseOutStructure*>(chain);
  while (found != nullptr && found->sType != type) found = found->pNext;
  return const_cast<VkBaseOutStructure*>(found);
}

// Takes a structure out of a create info's chain for as long as this lives.
class Without {
 public:
  Without(const void* create_info, VkStructureType type) {
    auto* before = static_cast<VkBaseOutStructure*>(const_cast<void*>(create_info));
    while (before->pNext != nullptr && before->pNext->sType != type) before = before->pNext;
    if (before->pNext == nullptr) return;
    before_ = before;
    taken_ = before->pNext;
    before->pNext = taken_->pNext;
  }
  ~Without() {
    if (before_ != nullptr) before_->pNext = taken_;
  }
  Without(const Without&) = delete;
  Without& operator=(const Without&) = delete;

 private:
  VkBaseOutStructure* before_ = nullptr;
  VkBaseOutStructure* taken_ = nullptr;
};

VKAPI_ATTR VkResult VKAPI_CALL createInstance(const VkInstanceCreateInfo* info,
                                              const VkAllocationCallbacks* allocator,
                                              VkInstance* instance) {
  auto* link =
      linkIn<VkLayerInstanceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO);
  if (link == nullptr) return VK_ERROR_INITIALIZATION_FAILED;
  const PFN_vkGetInstanceProcAddr next = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
  link->u.pLayerInfo = link->u.pLayerInfo->pNext;
  if (link->u.pLayerInfo != nullptr) {
    std::fputs("VK_LAYER_REPRISE_fragment_rate has to be the last layer before the driver\n",
               stderr);
    return VK_ERROR_INITIALIZATION_FAILED;
  }
  const auto create =
      reinterpret_cast<PFN_vkCreateInstance>(next(VK_NULL_HANDLE, "vkCreateInstance"));
  const VkResult result = create(info, allocator, instance);
  if (result != VK_SUCCESS) return result;
  Instance& made = instances[keyOf(*instance)];
  made.handle = *instance;
  made.get = next;
  lookUp(made, "vkDestroyInstance", made.destroy);
  lookUp(made, "vkEnumerateDeviceExtensionProperties", made.enumerate_extensions);
  lookUp(made, "vkGetPhysicalDeviceFeatures2", made.get_features);
  lookUp(made, "vkGetPhysicalDeviceProperties2", made.get_properties);
  return result;
}

VKAPI_ATTR void VKAPI_CALL destroyInstance(VkInstance instance,
                                           const VkAllocationCallbacks* allocator) {
  if (instance == VK_NULL_HANDLE) return;
  void* const key = keyOf(instance);
  instances.at(key).destroy(instance, allocator);
  instances.erase(key);
}

VKAPI_ATTR VkResult VKAPI_CALL enumerateDeviceExtensions(VkPhysicalDevice device, const char* layer,
                                                         uint32_t* count,
                                                         VkExtensionProperties* properties) {
  const auto next = instances.at(keyOf(device)).enumerate_extensions;
  if (layer != nullptr) return next(device, layer, count, properties);
  uint32_t room = *count;
  const VkResult result = next(device, nullptr, count, properties);
  if (result < 0) return result;
  VkExtensionProperties added{};
  std::strcpy(added.extensionName, VK_KHR_FRAGMENT_SHADING_RATE_EXTENSION_NAME);
  added.specVersion = VK_KHR_FRAGMENT_SHADING_RATE_SPEC_VERSION;
  if (properties != nullptr) {
    if (result == VK_INCOMPLETE || room <= *count) return VK_INCOMPLETE;
    properties[*count] = added;
  }
  ++*count;
  return result;
}

VKAPI_ATTR void VKAPI_CALL getFeatures(VkPhysicalDevice device,
                                       VkPhysicalDeviceFeatures2* features) {
  instances.at(keyOf(device)).get_features(device, features);
  auto* rates = reinterpret_cast<VkPhysicalDeviceFragmentShadingRateFeaturesKHR*>(
      findIn(features, VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FRAGMENT_SHADING_RATE_FEATURES_KHR));
  if (rates != nullptr) rates->pipelineFragmentShadingRate = VK_TRUE;
}

VKAPI_ATTR void VKAPI_CALL getProperties(VkPhysicalDevice device,
                                         VkPhysicalDeviceProperties2* properties) {
  instances.at(keyOf(device)).get_properties(device, properties);
  auto* rates = reinterpret_cast<VkPhysicalDeviceFragmentShadingRatePropertiesKHR*>(
      findIn(properties, VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FRAGMENT_SHADING_RATE_PROPERTIES_KHR));
  if (rates == nullptr) return;
  // The least that a device with the feature may have.
  void* const rest = rates->pNext;
  *rates = {.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FRAGMENT_SHADING_RATE_PROPERTIES_KHR};
  rates->pNext = rest;
  rates->maxFragmentSize = kCoarse;
  rates->maxFragmentSizeAspectRatio = 2;
  rates->maxFragmentShadingRateCoverageSamples = 16;
  rates->maxFragmentShadingRateRasterizationSamples = VK_SAMPLE_COUNT_4_BIT;
}

VKAPI_ATTR VkResult VKAPI_CALL getRates(VkPhysicalDevice, uint32_t* count,
                                        VkPhysicalDeviceFragmentShadingRateKHR* rates) {
  constexpr VkExtent2D kSizes[] = {kCoarse, {1, 1}};
  if (rates == nullptr) {
    *count = 2;
    return VK_SUCCESS;
  }
  const VkResult result = *count < 2 ? VK_INCOMPLETE : VK_SUCCESS;
  if (*count > 2) *count = 2;
  for (uint32_t i = 0; i < *count; ++i) {
    rates[i].sampleCounts = VK_SAMPLE_COUNT_1_BIT | VK_SAMPLE_COUNT_4_BIT;
    rates[i].fragmentSize = kSizes[i];
  }
  return result;
}

VKAPI_ATTR VkResult VKAPI_CALL createDevice(VkPhysicalDevice physical,
                                            const VkDeviceCreateInfo* info,
                                            const VkAllocationCallbacks* allocator,
                                            VkDevice* device) {
  auto* link =
      linkIn<VkLayerDeviceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO);
  if (link == nullptr) return VK_ERROR_INITIALIZATION_FAILED;
  const VkLayerDeviceLink& next = *link->u.pLayerInfo;
  link->u.pLayerInfo = next.pNext;
  VkDeviceCreateInfo passed = *info;
  std::vector<const char*> extensions;
  for (uint32_t i = 0; i < info->enabledExtensionCount; ++i) {
    const char* name = info->ppEnabledExtensionNames[i];
    if (std::strcmp(name, VK_KHR_FRAGMENT_SHADING_RATE_EXTENSION_NAME) != 0) {
      extensions.push_back(name);
    }
  }
  passed.enabledExtensionCount = static_cast<uint32_t>(extensions.size());
  passed.ppEnabledExtensionNames = extensions.data();
  const Without rates(&passed,
                      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FRAGMENT_SHADING_RATE_FEATURES_KHR);
  const Instance& instance = instances.at(keyOf(physical));
  const auto create = reinterpret_cast<PFN_vkCreateDevice>(
      next.pfnNextGetInstanceProcAddr(instance.handle, "vkCreateDevice"));
  const VkResult result = create(physical, &passed, allocator, device);
  if (result == VK_SUCCESS) devices[keyOf(*device)] = next.pfnNextGetDeviceProcAddr;
  return result;
}

VKAPI_ATTR void VKAPI_CALL destroyDevice(VkDevice device, const VkAllocationCallbacks* allocator) {
  if (device == VK_NULL_HANDLE) return;
  void* const key = keyOf(device);
  nextOfDevice<PFN_vkDestroyDevice>(device, "vkDestroyDevice")(device, allocator);
  devices.erase(key);
}

VKAPI_ATTR VkResult VKAPI_CALL createPipeline(VkDevice device, VkPipelineCache cache,
                                              uint32_t count,
                                              const VkGraphicsPipelineCreateInfo* infos,
                                              const VkAllocationCallbacks* allocator,
                                              VkPipeline* pipelines) {
  const auto next =
      nextOfDevice<PFN_vkCreateGraphicsPipelines>(device, "vkCreateGraphicsPipelines");
  if (count != 1) return VK_ERROR_INITIALIZATION_FAILED;  // the lab makes one at a time
  const Without rate(infos, VK_STRUCTURE_TYPE_PIPELINE_FRAGMENT_SHADING_RATE_STATE_CREATE_INFO_KHR);
  return next(device, cache, count, infos, allocator, pipelines);
}

template <typename Function>
PFN_vkVoidFunction asVoid(Function function) {
  return reinterpret_cast<PFN_vkVoidFunction>(function);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL getDeviceProcAddr(VkDevice device, const char* name) {
  const std::string asked = name;
  if (asked == "vkGetDeviceProcAddr") return asVoid(getDeviceProcAddr);
  if (asked == "vkDestroyDevice") return asVoid(destroyDevice);
  if (asked == "vkCreateGraphicsPipelines") return asVoid(createPipeline);
  return devices.at(keyOf(device))(device, name);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL getInstanceProcAddr(VkInstance instance,
                                                             const char* name) {
  static const std::map<std::string, PFN_vkVoidFunction> own = {
      {"vkGetInstanceProcAddr", asVoid(getInstanceProcAddr)},
      {"vkCreateInstance", asVoid(createInstance)},
      {"vkDestroyInstance", asVoid(destroyInstance)},
      {"vkEnumerateDeviceExtensionProperties", asVoid(enumerateDeviceExtensions)},
      {"vkGetPhysicalDeviceFeatures2", asVoid(getFeatures)},
      {"vkGetPhysicalDeviceFeatures2KHR", asVoid(getFeatures)},
      {"vkGetPhysicalDeviceProperties2", asVoid(getProperties)},
      {"vkGetPhysicalDeviceProperties2KHR", asVoid(getProperties)},
      {"vkGetPhysicalDeviceFragmentShadingRatesKHR", asVoid(getRates)},
      {"vkCreateDevice", asVoid(createDevice)},
      {"vkGetDeviceProcAddr", asVoid(getDeviceProcAddr)},
      {"vkDestroyDevice", asVoid(destroyDevice)},
      {"vkCreateGraphicsPipelines", asVoid(createPipeline)},
  };
  const auto found = own.find(name);
  if (found != own.end()) return found->second;
  if (instance == VK_NULL_HANDLE) return nullptr;
  return instances.at(keyOf(instance)).get(instance, name);
}

}  // namespace

extern "C" VK_LAYER_EXPORT VKAPI_ATTR VkResult VKAPI_CALL
vkNegotiateLoaderLayerInterfaceVersion(VkNegotiateLayerInterface* version) {
  version->loaderLayerInterfaceVersion = 2;
  version->pfnGetInstanceProcAddr = getInstanceProcAddr;
  version->pfnGetDeviceProcAddr = getDeviceProcAddr;
  version->pfnGetPhysicalDeviceProcAddr = nullptr;
  return VK_SUCCESS;
}
