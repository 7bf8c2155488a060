// SPDX-License-Identifier: MIT
//
// A headless Vulkan device for the lab: one queue, one command buffer, submit and wait.
#pragma once

#include <volk.h>

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace reprise::lab {

// The device failed or lacks a feature; exit code 4.
class DeviceError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Throws DeviceError unless `result` is VK_SUCCESS.
void check(VkResult result, const char* what);

struct DeviceOptions {
  // "" takes the first GPU, or the CPU driver where there is none; otherwise an index of
  // Device::list() or a part of a name.
  std::string selector;
  bool validation = false;  // Khronos validation with synchronization validation
};

struct DeviceSummary {
  std::string name;
  std::string driver;
  std::string type;  // "discrete GPU", "CPU" ...
  std::string api_version;
  bool usable = false;        // meets the lab's needs
  std::string missing;        // what it lacks where it is not
  bool shading_rate = false;  // fragments of 2 x 2 pixels, by VK_KHR_fragment_shading_rate
};

class Device {
 public:
  explicit Device(const DeviceOptions& options = {});
  ~Device();
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  static std::vector<DeviceSummary> list();

  VkInstance instance() const { return instance_; }
  VkPhysicalDevice physicalDevice() const { return physical_device_; }
  VkDevice handle() const { return device_; }
  PFN_vkGetInstanceProcAddr getInstanceProcAddr() const { return vkGetInstanceProcAddr; }
  const std::string& name() const { return name_; }
  const std::string& driver() const { return driver_; }
  const VkPhysicalDeviceLimits& limits() const { return limits_; }
  // Whether a fragment shader may write to buffers.
  bool hasFragmentStores() const { return fragment_stores_; }
  // Whether a pipeline may shade fragments of size x size pixels, at one sample a pixel.
  bool hasFragmentSize(uint32_t size) const;

  // Records into the device's command buffer, submits, waits. The work of one call is complete when
  // it returns.
  void submitAndWait(const std::function<void(VkCommandBuffer)>& record);

  VkDeviceMemory allocate(const VkMemoryRequirements& needs, VkMemoryPropertyFlags required,
                          VkMemoryPropertyFlags preferred) const;

  // Warnings and errors that the validation layer has said so far; empty without validation.
  const std::vector<std::string>& validationMessages() const { return validation_messages_; }
  // Whether the validation layer is installed.
  static bool validationAvailable();

 private:
  void createInstance(bool validation);
  void createDevice();
  static VKAPI_ATTR VkBool32 VKAPI_CALL receive(VkDebugUtilsMessageSeverityFlagBitsEXT,
                                                VkDebugUtilsMessageTypeFlagsEXT,
                                                const VkDebugUtilsMessengerCallbackDataEXT*, void*);

  VkInstance instance_ = VK_NULL_HANDLE;
  VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
  VkPhysicalDevice physical_device_ = VK_NULL_HANDLE;
  VkDevice device_ = VK_NULL_HANDLE;
  VkQueue queue_ = VK_NULL_HANDLE;
  uint32_t queue_family_ = 0;
  VkCommandPool command_pool_ = VK_NULL_HANDLE;
  VkCommandBuffer commands_ = VK_NULL_HANDLE;
  VkFence fence_ = VK_NULL_HANDLE;
  VkPhysicalDeviceMemoryProperties memory_{};
  VkPhysicalDeviceLimits limits_{};
  bool fragment_stores_ = false;
  std::vector<uint32_t> fragment_sizes_;  // sides of square fragments above 1
  std::string name_;
  std::string driver_;
  std::vector<std::string> validation_messages_;
};

// Everything before is complete and visible to everything after. The lab's frames are few and
// large: one full barrier between passes costs nothing that shows.
void fullBarrier(VkCommandBuffer commands);

}  // namespace reprise::lab
