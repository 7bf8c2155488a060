// SPDX-License-Identifier: MIT
#include "core/gpu.h"

#include <algorithm>
#include <cstring>

#include "core/error.h"

namespace reprise {

uint32_t Gpu::memoryType(uint32_t type_bits, VkMemoryPropertyFlags required,
                         VkMemoryPropertyFlags preferred, const std::string& what) const {
  for (const VkMemoryPropertyFlags wanted : {required | preferred, required}) {
    for (uint32_t i = 0; i < memory.memoryTypeCount; ++i) {
      const bool allowed = (type_bits & (1u << i)) != 0;
      if (allowed && (memory.memoryTypes[i].propertyFlags & wanted) == wanted) return i;
    }
  }
  fail(REPRISE_ERROR_UNSUPPORTED, "the device has no memory type for " + what);
}

bool Gpu::storable(VkFormat format) const {
  VkFormatProperties properties{};
  vk.GetPhysicalDeviceFormatProperties(physical_device, format, &properties);
  constexpr VkFormatFeatureFlags kNeeded = VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT |
                                           VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT |
                                           VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT;
  return (properties.optimalTilingFeatures & kNeeded) == kNeeded;
}

DeviceBuffer::DeviceBuffer(const Gpu& gpu, const char* name, uint64_t bytes,
                           VkBufferUsageFlags usage)
    : gpu_(gpu), name_(name), bytes_(bytes) {
  const std::string what = std::string("buffer '") + name_ + "'";
  try {
    VkBufferCreateInfo info{.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
    info.size = bytes_;
    info.usage = usage;
    check(gpu_.vk.CreateBuffer(gpu_.device, &info, nullptr, &buffer_), what);
    VkMemoryRequirements needs{};
    gpu_.vk.GetBufferMemoryRequirements(gpu_.device, buffer_, &needs);
    VkMemoryAllocateInfo memory_info{.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
    memory_info.allocationSize = needs.size;
    memory_info.memoryTypeIndex =
        gpu_.memoryType(needs.memoryTypeBits, 0, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, what);
    check(gpu_.vk.AllocateMemory(gpu_.device, &memory_info, nullptr, &memory_), what);
    check(gpu_.vk.BindBufferMemory(gpu_.device, buffer_, memory_, 0), what);
  } catch (...) {
    gpu_.vk.DestroyBuffer(gpu_.device, buffer_, nullptr);
    gpu_.vk.FreeMemory(gpu_.device, memory_, nullptr);
    throw;
  }
}

DeviceBuffer::~DeviceBuffer() {
  gpu_.vk.DestroyBuffer(gpu_.device, buffer_, nullptr);
  gpu_.vk.FreeMemory(gpu_.device, memory_, nullptr);
}

HistoryImage::HistoryImage(const Gpu& gpu, const char* name, VkFormat format, VkExtent2D extent,
                           uint32_t copies)
    : gpu_(gpu), name_(name), format_(format), extent_(extent), copies_(copies) {
  const std::string what = std::string("history image '") + name_ + "'";
  try {
    for (Copy& copy : copies_) {
      VkImageCreateInfo image_info{.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
      image_info.imageType = VK_IMAGE_TYPE_2D;
      image_info.format = format_;
      image_info.extent = {extent_.width, extent_.height, 1};
      image_info.mipLevels = 1;
      image_info.arrayLayers = 1;
      image_info.samples = VK_SAMPLE_COUNT_1_BIT;
      image_info.tiling = VK_IMAGE_TILING_OPTIMAL;
      image_info.usage =
          VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
      check(gpu_.vk.CreateImage(gpu_.device, &image_info, nullptr, &copy.image), what);

      VkMemoryRequirements needs{};
      gpu_.vk.GetImageMemoryRequirements(gpu_.device, copy.image, &needs);
      VkMemoryAllocateInfo memory_info{.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
      memory_info.allocationSize = needs.size;
      memory_info.memoryTypeIndex =
          gpu_.memoryType(needs.memoryTypeBits, 0, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, what);
      check(gpu_.vk.AllocateMemory(gpu_.device, &memory_info, nullptr, &copy.memory), what);
      check(gpu_.vk.BindImageMemory(gpu_.device, copy.image, copy.memory, 0), what);
      bytes_ += needs.size;

      VkImageViewCreateInfo view_info{.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
      view_info.image = copy.image;
      view_info.viewType = VK_IMAGE_VIEW_TYPE_2D;
      view_info.format = format_;
      view_info.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
      check(gpu_.vk.CreateImageView(gpu_.device, &view_info, nullptr, &copy.view), what);
    }
  } catch (...) {
    release();
    throw;
  }
}

HistoryImage::~HistoryImage() {
  release();
}

void HistoryImage::release() {
  for (Copy& copy : copies_) {
    gpu_.vk.DestroyImageView(gpu_.device, copy.view, nullptr);
    gpu_.vk.DestroyImage(gpu_.device, copy.image, nullptr);
    gpu_.vk.FreeMemory(gpu_.device, copy.memory, nullptr);
  }
  copies_.clear();
}

void HistoryImage::recordInitialLayout(VkCommandBuffer commands) {
  if (has_layout_) return;
  const VkImageSubresourceRange whole{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
  for (const Copy& copy : copies_) {
    VkImageMemoryBarrier barrier{.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER};
    barrier.dstAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
    barrier.oldLayout = VK_IMAGE_LAYOUT_UNDEFINED;
    barrier.newLayout = VK_IMAGE_LAYOUT_GENERAL;
    barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = copy.image;
    barrier.subresourceRange = whole;
    gpu_.vk.CmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT,
                               VK_PIPELINE_STAGE_TRANSFER_BIT, 0, 0, nullptr, 0, nullptr, 1,
                               &barrier);
    // Zero as a float and as an integer alike.
    const VkClearColorValue zero{};
    gpu_.vk.CmdClearColorImage(commands, copy.image, VK_IMAGE_LAYOUT_GENERAL, &zero, 1, &whole);
    barrier.srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
    barrier.dstAccessMask = VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT;
    barrier.oldLayout = VK_IMAGE_LAYOUT_GENERAL;
    gpu_.vk.CmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TRANSFER_BIT,
                               VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, 0, 0, nullptr, 0, nullptr, 1,
                               &barrier);
  }
  has_layout_ = true;
}

uint32_t ConstantRing::alignedSize(const Gpu& gpu, uint32_t bytes) {
  const auto alignment =
      static_cast<uint32_t>(std::max<VkDeviceSize>(gpu.limits.minUniformBufferOffsetAlignment, 16));
  return (bytes + alignment - 1) / alignment * alignment;
}

ConstantRing::ConstantRing(const Gpu& gpu, uint32_t slot_bytes, uint32_t frames)
    : gpu_(gpu), slot_bytes_(std::max(alignedSize(gpu, slot_bytes), 16u)) {
  VkBufferCreateInfo buffer_info{.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
  buffer_info.size = VkDeviceSize{slot_bytes_} * frames;
  buffer_info.usage = VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT;
  check(gpu_.vk.CreateBuffer(gpu_.device, &buffer_info, nullptr, &buffer_), "constant buffer");
  try {
    VkMemoryRequirements needs{};
    gpu_.vk.GetBufferMemoryRequirements(gpu_.device, buffer_, &needs);
    VkMemoryAllocateInfo memory_info{.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
    memory_info.allocationSize = needs.size;
    memory_info.memoryTypeIndex =
        gpu_.memoryType(needs.memoryTypeBits,
                        VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT,
                        VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, "constant buffer");
    check(gpu_.vk.AllocateMemory(gpu_.device, &memory_info, nullptr, &memory_), "constant buffer");
    check(gpu_.vk.BindBufferMemory(gpu_.device, buffer_, memory_, 0), "constant buffer");
    void* mapped = nullptr;
    check(gpu_.vk.MapMemory(gpu_.device, memory_, 0, VK_WHOLE_SIZE, 0, &mapped), "constant buffer");
    mapped_ = static_cast<uint8_t*>(mapped);
  } catch (...) {
    gpu_.vk.DestroyBuffer(gpu_.device, buffer_, nullptr);
    gpu_.vk.FreeMemory(gpu_.device, memory_, nullptr);
    throw;
  }
}

ConstantRing::~ConstantRing() {
  gpu_.vk.DestroyBuffer(gpu_.device, buffer_, nullptr);
  gpu_.vk.FreeMemory(gpu_.device, memory_, nullptr);
}

uint32_t ConstantRing::write(const void* data, uint32_t bytes) {
  const uint32_t offset = cursor_;
  std::memcpy(mapped_ + offset, data, bytes);
  cursor_ += alignedSize(gpu_, bytes);
  return offset;
}

}  // namespace reprise
