// SPDX-License-Identifier: MIT
//
// The host's device as the library sees it, and the few objects that a context owns on it.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/vulkan_functions.h"
#include "reprise/reprise.h"

namespace reprise {

struct Gpu {
  VulkanFunctions vk;
  VkDevice device = VK_NULL_HANDLE;
  VkPipelineCache pipeline_cache = VK_NULL_HANDLE;
  VkPhysicalDeviceMemoryProperties memory{};
  VkPhysicalDeviceLimits limits{};
  VkPhysicalDevice physical_device = VK_NULL_HANDLE;

  // Whether an image of `format` can be written by shaders and sampled with a linear filter.
  bool storable(VkFormat format) const;

  // Index of the first memory type in `type_bits` with all `required` flags, preferring
  // `preferred`.
  uint32_t memoryType(uint32_t type_bits, VkMemoryPropertyFlags required,
                      VkMemoryPropertyFlags preferred, const std::string& what) const;
};

// Copies of one image that take turns: with two, current() is written while previous() is read. The
// turn is that of the record count, never of a jitter phase.
class HistoryImage {
 public:
  // `name` must be in static storage: memory reports hand it to the host.
  HistoryImage(const Gpu& gpu, const char* name, VkFormat format, VkExtent2D extent,
               uint32_t copies);
  ~HistoryImage();
  HistoryImage(const HistoryImage&) = delete;
  HistoryImage& operator=(const HistoryImage&) = delete;

  const char* name() const { return name_; }
  VkFormat format() const { return format_; }
  VkExtent2D extent() const { return extent_; }
  uint32_t copies() const { return static_cast<uint32_t>(copies_.size()); }
  uint64_t bytes() const { return bytes_; }

  // The copy written in the record of number `record`, and the one written `age` records before.
  VkImageView copy(uint32_t index) const { return copies_[index].view; }
  VkImageView current(uint64_t record) const { return copies_[record % copies_.size()].view; }
  VkImageView previous(uint64_t record, uint32_t age = 1) const {
    return copies_[(record + copies_.size() - age) % copies_.size()].view;
  }

  // UNDEFINED -> GENERAL and zero, once, before the first use: a bilinear fetch reads texels that
  // were never written, and zero times a NaN would be a NaN.
  void recordInitialLayout(VkCommandBuffer commands);

 private:
  struct Copy {
    VkImage image = VK_NULL_HANDLE;
    VkDeviceMemory memory = VK_NULL_HANDLE;
    VkImageView view = VK_NULL_HANDLE;
  };
  void release();

  const Gpu& gpu_;
  const char* name_;
  VkFormat format_;
  VkExtent2D extent_;
  std::vector<Copy> copies_;
  uint64_t bytes_ = 0;
  bool has_layout_ = false;
};

// A buffer of device memory that shaders write, reported as history is.
class DeviceBuffer {
 public:
  // `name` must be in static storage.
  DeviceBuffer(const Gpu& gpu, const char* name, uint64_t bytes, VkBufferUsageFlags usage);
  ~DeviceBuffer();
  DeviceBuffer(const DeviceBuffer&) = delete;
  DeviceBuffer& operator=(const DeviceBuffer&) = delete;

  const char* name() const { return name_; }
  VkBuffer handle() const { return buffer_; }
  uint64_t bytes() const { return bytes_; }

 private:
  const Gpu& gpu_;
  const char* name_;
  uint64_t bytes_;
  VkBuffer buffer_ = VK_NULL_HANDLE;
  VkDeviceMemory memory_ = VK_NULL_HANDLE;
};

// Host-visible memory for the constants of every pass of `frames` frames in flight: one slot a
// frame.
class ConstantRing {
 public:
  ConstantRing(const Gpu& gpu, uint32_t slot_bytes, uint32_t frames);
  ~ConstantRing();
  ConstantRing(const ConstantRing&) = delete;
  ConstantRing& operator=(const ConstantRing&) = delete;

  VkBuffer buffer() const { return buffer_; }
  void beginSlot(uint32_t slot) { cursor_ = slot * slot_bytes_; }
  // Copies `bytes` into the current slot and returns the offset within buffer().
  uint32_t write(const void* data, uint32_t bytes);
  static uint32_t alignedSize(const Gpu& gpu, uint32_t bytes);

 private:
  const Gpu& gpu_;
  uint32_t slot_bytes_;
  uint32_t cursor_ = 0;
  VkBuffer buffer_ = VK_NULL_HANDLE;
  VkDeviceMemory memory_ = VK_NULL_HANDLE;
  uint8_t* mapped_ = nullptr;
};

}  // namespace reprise
