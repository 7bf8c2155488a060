// SPDX-License-Identifier: MIT
#include "lab/vk/texture_array.h"

#include <algorithm>

namespace reprise::lab {

TextureArray::TextureArray(Device& device, VkFormat format, VkExtent2D extent,
                           const std::vector<std::vector<std::vector<uint8_t>>>& layers) {
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
  image_ = DeviceImage(device, image_info, VK_IMAGE_VIEW_TYPE_2D_ARRAY, VK_IMAGE_ASPECT_COLOR_BIT);

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
      vkCmdCopyBufferToImage(commands, staging.handle(), image_.handle(), VK_IMAGE_LAYOUT_GENERAL,
                             level_count, copies.data());
      fullBarrier(commands);
    });
  }
}

}  // namespace reprise::lab
