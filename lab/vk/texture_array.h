// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "lab/vk/buffer.h"
#include "lab/vk/device.h"

namespace reprise::lab {

// Layers of one extent with all their mip levels, sampled only; VK_IMAGE_LAYOUT_GENERAL.
class TextureArray {
 public:
  TextureArray() = default;
  // `layers`: for each layer the texels of each level, tightly packed, four bytes each.
  TextureArray(Device& device, VkFormat format, VkExtent2D extent,
               const std::vector<std::vector<std::vector<uint8_t>>>& layers);
  ~TextureArray();
  TextureArray(TextureArray&& other) noexcept { *this = std::move(other); }
  TextureArray& operator=(TextureArray&& other) noexcept;

  VkImageView view() const { return view_; }

 private:
  Device* device_ = nullptr;
  VkImage image_ = VK_NULL_HANDLE;
  VkDeviceMemory memory_ = VK_NULL_HANDLE;
  VkImageView view_ = VK_NULL_HANDLE;
};

}  // namespace reprise::lab
