// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "lab/float_image.h"
#include "lab/vk/buffer.h"
#include "lab/vk/device_image.h"

namespace reprise::lab {

struct ImageInfo {
  VkFormat format = VK_FORMAT_R16G16B16A16_SFLOAT;
  VkExtent2D extent{1, 1};
  // Colour formats are sampled and stored to; depth formats sampled and rendered to.
  bool render_target = false;
  // 4: rendered to and fetched from by shaders; neither stored to, up- nor downloaded.
  VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_1_BIT;
};

// A 2D image of one mip level that stays in VK_IMAGE_LAYOUT_GENERAL from its creation on.
class Image {
 public:
  Image() = default;
  Image(Device& device, const ImageInfo& info);

  VkImage handle() const { return image_.handle(); }
  VkImageView view() const { return image_.view(); }
  VkFormat format() const { return info_.format; }
  VkExtent2D extent() const { return info_.extent; }
  VkImageAspectFlags aspect() const;
  uint64_t bytes() const;  // of its texels, tightly packed

  // Tightly packed rows, from top to bottom, in the image's own format. The recorded forms copy
  // from or to `buffer` at `offset`; a barrier around them is the caller's.
  void recordUpload(VkCommandBuffer commands, const Buffer& buffer, uint64_t offset = 0) const;
  void recordDownload(VkCommandBuffer commands, const Buffer& buffer, uint64_t offset = 0) const;

 private:
  ImageInfo info_;
  DeviceImage image_;
};

// Bytes of one texel. Throws DeviceError for formats that the lab does not use.
uint32_t texelBytes(VkFormat format);

// Whole-image transfers that submit and wait. Raw bytes are in the image's format; the float forms
// convert: R32F, RG32F, RGBA32F, RGBA16F, D32, R32_UINT.
std::vector<uint8_t> downloadBytes(Device& device, const Image& image);
void uploadBytes(Device& device, const Image& image, std::span<const uint8_t> bytes);
FloatImage download(Device& device, const Image& image);
void upload(Device& device, const Image& image, const FloatImage& texels);

// Texels of `format`, tightly packed, as floats with the format's channel count.
FloatImage floatsFromTexels(VkFormat format, VkExtent2D extent, const void* texels);

}  // namespace reprise::lab
