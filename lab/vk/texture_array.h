// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "lab/vk/buffer.h"
#include "lab/vk/device_image.h"

namespace reprise::lab {

// Layers of one extent with all their mip levels, sampled only; VK_IMAGE_LAYOUT_GENERAL.
class TextureArray {
 public:
  TextureArray() = default;
  // `layers`: for each layer the texels of each level, tightly packed, four bytes each.
  TextureArray(Device& device, VkFormat format, VkExtent2D extent,
               const std::vector<std::vector<std::vector<uint8_t>>>& layers);

  VkImageView view() const { return image_.view(); }

 private:
  DeviceImage image_;
};

}  // namespace reprise::lab
