// SPDX-License-Identifier: MIT
#include "lab/vk/texture_array.h"

#include <algorithm>
#include <utility>

namespace reprise::lab {

TextureArray::TextureArray(Device& device, VkFormat format, VkExtent2D extent,
                           const std::vector<std::vector<std::vector<uint8_t>>>& layers)
    : device_(&device) {
  const auto layer_count = static_cast<uint32_t>(layers.size());
  const auto level_count = static_cast<uint32_t>(layers.front().size());
  if (layer_count > device.limits().maxImageArrayLayers ||
      std::max(extent.width, extent.height) > device.limits().maxImageDimension2D) {
    throw DeviceError("the device holds no array of " + std::to_string(layer_count) +
                      " textures of " + std::to_string(extent.width) + "x" +
                      std::to_string(extent.height));
  }
  VkImageCreateInfo image_info{.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
  image_info.imageType = VK_IMAGE_TYPE_2D;
  image_info.format = format;
  image_info.extent = {extent.width, extent.height, 1};
  image_info.mipLevels = level_count;
  image_info.arrayLayers = layer_count;
  image_info.samples = VK_SAMPLE_COUNT_1_BIT;
  image_info.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
  check(vkCreateImage(device.handle(), &image_info, nullptr, &image_), "vkCreateImage");
  VkMemoryRequirements needs{};
  vkGetImageMemoryRequirements(device.handle(), image_, &needs);
  memory_ = device.allocate(needs, 0, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
  check(vkBindImageMemory(device.handle(), image_, memory_, 0), "vkBindImageMemory");
  VkImageViewCreateInfo view_info{.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
  view_info.image = image_;
  view_info.viewType = VK_IMAGE_VIEW_TYPE_2D_ARRAY;
  view_info.format = format;
  view_info.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, level_count, 0, layer_count};
  check(vkCreateImageView(device.handle(), &view_info, nullptr, &view_), "vkCreateImageView");

  uint64_t layer_bytes = 0;
  for (const std::vector<uint8_t>& level : layers.front()) layer_bytes += level.size();
  Buffer staging(device, layer_bytes, BufferKind::kHost);
  for (uint32_t layer = 0; layer < layer_count; ++layer) {
    std::vector<VkBufferImageCopy> copies;
    uint64_t offset = 0;
    for (uint32_t level = 0; level < level_count; ++level) {
      const std::vector<uint8_t>& bytes = layers[layer][level];
      std::copy(bytes.begin(), bytes.end(), static_cast<uint8_t*>(staging.mapped()) + offset);
      VkBufferImageCopy copy{};
      copy.bufferOffset = offset;
      copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, level, layer, 1};
      copy.imageExtent = {std::max(1u, extent.width >> level), std::max(1u, extent.height >> level),
                          1};
      copies.push_back(copy);
      offset += bytes.size();
    }
    device.submitAndWait([&](VkCommandBuffer commands) {
      VkImageMemoryBarrier barrier{.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER};
      barrier.dstAccessMask = VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT;
      barrier.oldLayout = VK_IMAGE_LAYOUT_UNDEFINED;
      barrier.newLayout = VK_IMAGE_LAYOUT_GENERAL;
      barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
      barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
      barrier.image = image_;
      barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, level_count, layer, 1};
      vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT,
                           VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0, 0, nullptr, 0, nullptr, 1,
                           &barrier);
      vkCmdCopyBufferToImage(commands, staging.handle(), image_, VK_IMAGE_LAYOUT_GENERAL,
                             level_count, copies.data());
      fullBarrier(commands);
    });
  }
}

TextureArray::~TextureArray() {
  if (device_ == nullptr) return;
  vkDestroyImageView(device_->handle(), view_, nullptr);
  vkDestroyImage(device_->handle(), image_, nullptr);
  vkFreeMemory(device_->handle(), memory_, nullptr);
}

TextureArray& TextureArray::operator=(TextureArray&& other) noexcept {
  std::swap(device_, other.device_);
  std::swap(image_, other.image_);
  std::swap(memory_, other.memory_);
  std::swap(view_, other.view_);
  return *this;
}

}  // namespace reprise::lab
