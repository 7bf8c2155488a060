// SPDX-License-Identifier: MIT
#include "lab/vk/device.h"

#include <algorithm>
#include <charconv>
#include <cstring>

#include "reprise/reprise.h"

namespace reprise::lab {
namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";

// The lab's own needs; the library needs none. Every desktop driver and lavapipe have both.
constexpr const char* kExtensions[] = {VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME,
                                       VK_KHR_DYNAMIC_RENDERING_EXTENSION_NAME};

void loadVulkan() {
  static const VkResult result = volkInitialize();
  if (result != VK_SUCCESS) throw DeviceError("no Vulkan loader is installed (libvulkan.so.1)");
}

VkInstance createBareInstance() {
  loadVulkan();
  VkApplicationInfo application{.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO};
  application.apiVersion = VK_API_VERSION_1_2;
  VkInstanceCreateInfo info{.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
  info.pApplicationInfo = &application;
  VkInstance instance = VK_NULL_HANDLE;
  check(vkCreateInstance(&info, nullptr, &instance), "vkCreateInstance");
  volkLoadInstance(instance);
  return instance;
}

std::vector<VkPhysicalDevice> physicalDevices(VkInstance instance) {
  uint32_t count = 0;
  check(vkEnumeratePhysicalDevices(instance, &count, nullptr), "vkEnumeratePhysicalDevices");
  std::vector<VkPhysicalDevice> devices(count);
  check(vkEnumeratePhysicalDevices(instance, &count, devices.data()), "vkEnumeratePhysicalDevices");
  return devices;
}

bool hasExtension(VkPhysicalDevice device, const char* name) {
  uint32_t count = 0;
  vkEnumerateDeviceExtensionProperties(device, nullptr, &count, nullptr);
  std::vector<VkExtensionProperties> extensions(count);
  vkEnumerateDeviceExtensionProperties(device, nullptr, &count, extensions.data());
  return std::any_of(extensions.begin(), extensions.end(), [&](const auto& extension) {
    return std::strcmp(extension.extensionName, name) == 0;
  });
}

// Sides, above 1, of the square fragments that a pipeline may ask for at one sample a pixel. Empty
// without VK_KHR_fragment_shading_rate, which may also be there without this feature.
std::vector<uint32_t> squareFragments(VkPhysicalDevice device) {
  if (!hasExtension(device, VK_KHR_FRAGMENT_SHADING_RATE_EXTENSION_NAME)) return {};
  VkPhysicalDeviceFragmentShadingRateFeaturesKHR rates{
      .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FRAGMENT_SHADING_RATE_FEATURES_KHR};
  VkPhysicalDeviceFeatures2 features{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2};
  features.pNext = &rates;
  vkGetPhysicalDeviceFeatures2(device, &features);
  if (!rates.pipelineFragmentShadingRate) return {};
  uint32_t count = 0;
  vkGetPhysicalDeviceFragmentShadingRatesKHR(device, &count, nullptr);
  std::vector<VkPhysicalDeviceFragmentShadingRateKHR> offered(
      count, {.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FRAGMENT_SHADING_RATE_KHR});
  vkGetPhysicalDeviceFragmentShadingRatesKHR(device, &count, offered.data());
  std::vector<uint32_t> sides;
  for (const VkPhysicalDeviceFragmentShadingRateKHR& rate : offered) {
    const VkExtent2D size = rate.fragmentSize;
    const bool one_sample = (rate.sampleCounts & VK_SAMPLE_COUNT_1_BIT) != 0;
    if (one_sample && size.width == size.height && size.width > 1) sides.push_back(size.width);
  }
  return sides;
}

bool contains(const std::vector<uint32_t>& values, uint32_t value) {
  return std::find(values.begin(), values.end(), value) != values.end();
}

// What the lab itself needs of a device, beyond what the library asks for.
struct Needed {
  VkPhysicalDeviceFeatures features{};
  std::string missing;
};

Needed neededFeatures(VkPhysicalDevice device) {
  RepriseRequirements library{};
  library.size = sizeof(library);
  repriseGetRequirements("taa", VK_NULL_HANDLE, VK_NULL_HANDLE, nullptr, &library);
  Needed needed{.features = library.features, .missing = ""};
  needed.features.geometryShader = VK_TRUE;  // gl_PrimitiveID in the visibility pass
  needed.features.shaderStorageImageWriteWithoutFormat = VK_TRUE;
  VkPhysicalDeviceFeatures offered{};
  vkGetPhysicalDeviceFeatures(device, &offered);
  if (!offered.geometryShader) needed.missing = "geometryShader";
  if (!offered.shaderStorageImageWriteWithoutFormat) {
    needed.missing = "shaderStorageImageWriteWithoutFormat";
  }
  needed.features.fragmentStoresAndAtomics = offered.fragmentStoresAndAtomics;  // raster shading
  for (const char* extension : kExtensions) {
    if (!hasExtension(device, extension)) needed.missing = extension;
  }
  VkPhysicalDeviceProperties properties{};
  vkGetPhysicalDeviceProperties(device, &properties);
  if (properties.apiVersion < VK_API_VERSION_1_2) needed.missing = "Vulkan 1.2";
  if (!properties.limits.timestampComputeAndGraphics) needed.missing = "timestamps";
  return needed;
}

const char* typeName(VkPhysicalDeviceType type) {
  switch (type) {
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
      return "integrated GPU";
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
      return "discrete GPU";
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
      return "virtual GPU";
    case VK_PHYSICAL_DEVICE_TYPE_CPU:
      return "CPU";
    default:
      return "other";
  }
}

DeviceSummary summarize(VkPhysicalDevice device) {
  VkPhysicalDeviceDriverProperties driver{.sType =
                                              VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES};
  VkPhysicalDeviceProperties2 properties{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2};
  properties.pNext = &driver;
  vkGetPhysicalDeviceProperties2(device, &properties);
  const uint32_t version = properties.properties.apiVersion;
  DeviceSummary summary;
  summary.name = properties.properties.deviceName;
  summary.driver = std::string(driver.driverName) + " " + driver.driverInfo;
  summary.type = typeName(properties.properties.deviceType);
  summary.api_version = std::to_string(VK_API_VERSION_MAJOR(version)) + "." +
                        std::to_string(VK_API_VERSION_MINOR(version));
  summary.missing = neededFeatures(device).missing;
  summary.usable = summary.missing.empty();
  summary.shading_rate = contains(squareFragments(device), 2);
  return summary;
}

VkPhysicalDevice select(const std::vector<VkPhysicalDevice>& devices, const std::string& selector) {
  if (devices.empty()) throw DeviceError("no Vulkan device (for the CPU: mesa-vulkan-drivers)");
  if (selector.empty()) {
    for (const bool want_gpu : {true, false}) {
      for (VkPhysicalDevice device : devices) {
        const DeviceSummary summary = summarize(device);
        if (summary.usable && (summary.type != "CPU") == want_gpu) return device;
      }
    }
    throw DeviceError("no usable Vulkan device: '" + summarize(devices[0]).name + "' lacks " +
                      summarize(devices[0]).missing);
  }
  size_t index = devices.size();
  const char* end = selector.data() + selector.size();
  const bool is_index = std::from_chars(selector.data(), end, index).ptr == end;
  for (size_t i = 0; i < devices.size(); ++i) {
    const DeviceSummary summary = summarize(devices[i]);
    const bool matches = is_index ? i == index : summary.name.find(selector) != std::string::npos;
    if (!matches) continue;
    if (!summary.usable)
      throw DeviceError("device '" + summary.name + "' lacks " + summary.missing);
    return devices[i];
  }
  throw DeviceError("no device '" + selector + "' (see 'reprise list')");
}

}  // namespace

void check(VkResult result, const char* what) {
  if (result == VK_SUCCESS) return;
  throw DeviceError(std::string(what) + " failed with VkResult " +
                    std::to_string(static_cast<int>(result)));
}

std::vector<DeviceSummary> Device::list() {
  VkInstance instance = createBareInstance();
  std::vector<DeviceSummary> summaries;
  for (VkPhysicalDevice device : physicalDevices(instance)) summaries.push_back(summarize(device));
  vkDestroyInstance(instance, nullptr);
  return summaries;
}

bool Device::validationAvailable() {
  loadVulkan();
  uint32_t count = 0;
  vkEnumerateInstanceLayerProperties(&count, nullptr);
  std::vector<VkLayerProperties> layers(count);
  vkEnumerateInstanceLayerProperties(&count, layers.data());
  return std::any_of(layers.begin(), layers.end(), [](const VkLayerProperties& layer) {
    return std::strcmp(layer.layerName, kValidationLayer) == 0;
  });
}

VkBool32 Device::receive(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                         const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
  static_cast<Device*>(user)->validation_messages_.emplace_back(data->pMessage);
  return VK_FALSE;
}

void Device::createInstance(bool validation) {
  if (!validation) {
    instance_ = createBareInstance();
    return;
  }
  loadVulkan();
  if (!validationAvailable()) {
    throw DeviceError("the validation layer is not installed (vulkan-validationlayers)");
  }
  VkApplicationInfo application{.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO};
  application.apiVersion = VK_API_VERSION_1_2;
  const VkValidationFeatureEnableEXT enabled[] = {
      VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT};
  VkValidationFeaturesEXT features{.sType = VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT};
  features.enabledValidationFeatureCount = 1;
  features.pEnabledValidationFeatures = enabled;
  VkDebugUtilsMessengerCreateInfoEXT messenger{
      .sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT};
  messenger.pNext = &features;
  messenger.messageSeverity = VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT |
                              VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
  messenger.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT;
  messenger.pfnUserCallback = &Device::receive;
  messenger.pUserData = this;
  const char* extensions[] = {VK_EXT_DEBUG_UTILS_EXTENSION_NAME};
  VkInstanceCreateInfo info{.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
  info.pNext = &messenger;
  info.pApplicationInfo = &application;
  info.enabledLayerCount = 1;
  info.ppEnabledLayerNames = &kValidationLayer;
  info.enabledExtensionCount = 1;
  info.ppEnabledExtensionNames = extensions;
  check(vkCreateInstance(&info, nullptr, &instance_), "vkCreateInstance");
  volkLoadInstance(instance_);
  messenger.pNext = nullptr;
  check(vkCreateDebugUtilsMessengerEXT(instance_, &messenger, nullptr, &messenger_),
        "vkCreateDebugUtilsMessengerEXT");
}

void Device::createDevice() {
  const Needed needed = neededFeatures(physical_device_);
  uint32_t family_count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(physical_device_, &family_count, nullptr);
  std::vector<VkQueueFamilyProperties> families(family_count);
  vkGetPhysicalDeviceQueueFamilyProperties(physical_device_, &family_count, families.data());
  constexpr VkQueueFlags kWanted = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
  while (queue_family_ < family_count &&
         (families[queue_family_].queueFlags & kWanted) != kWanted) {
    ++queue_family_;
  }
  if (queue_family_ == family_count) {
    throw DeviceError("device '" + name_ + "' has no queue for graphics and compute");
  }
  const float priority = 1.0f;
  VkDeviceQueueCreateInfo queue_info{.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
  queue_info.queueFamilyIndex = queue_family_;
  queue_info.queueCount = 1;
  queue_info.pQueuePriorities = &priority;
  VkPhysicalDeviceDynamicRenderingFeaturesKHR rendering{
      .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DYNAMIC_RENDERING_FEATURES_KHR};
  rendering.dynamicRendering = VK_TRUE;
  fragment_stores_ = needed.features.fragmentStoresAndAtomics == VK_TRUE;
  fragment_sizes_ = squareFragments(physical_device_);
  VkPhysicalDeviceFragmentShadingRateFeaturesKHR rates{
      .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FRAGMENT_SHADING_RATE_FEATURES_KHR};
  rates.pipelineFragmentShadingRate = VK_TRUE;
  std::vector<const char*> extensions(std::begin(kExtensions), std::end(kExtensions));
  if (!fragment_sizes_.empty()) {
    extensions.push_back(VK_KHR_FRAGMENT_SHADING_RATE_EXTENSION_NAME);
    rendering.pNext = &rates;
  }
  VkDeviceCreateInfo info{.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO};
  info.pNext = &rendering;
  info.enabledExtensionCount = static_cast<uint32_t>(extensions.size());
  info.ppEnabledExtensionNames = extensions.data();
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue_info;
  info.pEnabledFeatures = &needed.features;
  check(vkCreateDevice(physical_device_, &info, nullptr, &device_), "vkCreateDevice");
  // volkLoadDevice is not called: its pointers would belong to one device of possibly several.
  vkGetDeviceQueue(device_, queue_family_, 0, &queue_);
}

Device::Device(const DeviceOptions& options) {
  createInstance(options.validation);
  physical_device_ = select(physicalDevices(instance_), options.selector);
  const DeviceSummary summary = summarize(physical_device_);
  name_ = summary.name;
  driver_ = summary.driver;
  VkPhysicalDeviceProperties properties{};
  vkGetPhysicalDeviceProperties(physical_device_, &properties);
  limits_ = properties.limits;
  vkGetPhysicalDeviceMemoryProperties(physical_device_, &memory_);
  createDevice();

  VkCommandPoolCreateInfo pool_info{.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
  pool_info.flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
  pool_info.queueFamilyIndex = queue_family_;
  check(vkCreateCommandPool(device_, &pool_info, nullptr, &command_pool_), "vkCreateCommandPool");
  VkCommandBufferAllocateInfo commands_info{.sType =
                                                VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
  commands_info.commandPool = command_pool_;
  commands_info.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
  commands_info.commandBufferCount = 1;
  check(vkAllocateCommandBuffers(device_, &commands_info, &commands_), "vkAllocateCommandBuffers");
  VkFenceCreateInfo fence_info{.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
  check(vkCreateFence(device_, &fence_info, nullptr, &fence_), "vkCreateFence");
}

Device::~Device() {
  if (device_ != VK_NULL_HANDLE) {
    vkDeviceWaitIdle(device_);
    vkDestroyFence(device_, fence_, nullptr);
    vkDestroyCommandPool(device_, command_pool_, nullptr);
    vkDestroyDevice(device_, nullptr);
  }
  if (messenger_ != VK_NULL_HANDLE) {
    // Not volk's global: another instance, without the extension, may have reloaded it since.
    const auto destroy = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
        vkGetInstanceProcAddr(instance_, "vkDestroyDebugUtilsMessengerEXT"));
    destroy(instance_, messenger_, nullptr);
  }
  vkDestroyInstance(instance_, nullptr);
}

bool Device::hasFragmentSize(uint32_t size) const {
  return size == 1 || contains(fragment_sizes_, size);
}

void Device::submitAndWait(const std::function<void(VkCommandBuffer)>& record) {
  VkCommandBufferBeginInfo begin{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
  begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  check(vkBeginCommandBuffer(commands_, &begin), "vkBeginCommandBuffer");
  record(commands_);
  check(vkEndCommandBuffer(commands_), "vkEndCommandBuffer");
  VkSubmitInfo submit{.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO};
  submit.commandBufferCount = 1;
  submit.pCommandBuffers = &commands_;
  check(vkQueueSubmit(queue_, 1, &submit, fence_), "vkQueueSubmit");
  check(vkWaitForFences(device_, 1, &fence_, VK_TRUE, UINT64_MAX), "vkWaitForFences");
  check(vkResetFences(device_, 1, &fence_), "vkResetFences");
}

VkDeviceMemory Device::allocate(const VkMemoryRequirements& needs, VkMemoryPropertyFlags required,
                                VkMemoryPropertyFlags preferred) const {
  for (const VkMemoryPropertyFlags wanted : {required | preferred, required}) {
    for (uint32_t i = 0; i < memory_.memoryTypeCount; ++i) {
      const bool allowed = (needs.memoryTypeBits & (1u << i)) != 0;
      if (!allowed || (memory_.memoryTypes[i].propertyFlags & wanted) != wanted) continue;
      VkMemoryAllocateInfo info{.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
      info.allocationSize = needs.size;
      info.memoryTypeIndex = i;
      VkDeviceMemory memory = VK_NULL_HANDLE;
      check(vkAllocateMemory(device_, &info, nullptr, &memory), "vkAllocateMemory");
      return memory;
    }
  }
  throw DeviceError("device '" + name_ + "' has no fitting memory type");
}

void fullBarrier(VkCommandBuffer commands) {
  VkMemoryBarrier barrier{.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER};
  barrier.srcAccessMask = VK_ACCESS_MEMORY_WRITE_BIT;
  barrier.dstAccessMask = VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT;
  vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT,
                       VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0, 1, &barrier, 0, nullptr, 0, nullptr);
}

}  // namespace reprise::lab
