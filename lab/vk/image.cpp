// SPDX-License-Identifier: MIT
#include "lab/vk/image.h"

#include <glm/gtc/packing.hpp>
#include <utility>

namespace reprise::lab {
namespace {

struct FormatInfo {
  uint32_t bytes;
  uint32_t channels;
};

FormatInfo formatInfo(VkFormat format) {
  switch (format) {
    case VK_FORMAT_R32_SFLOAT:
    case VK_FORMAT_R32_UINT:
    case VK_FORMAT_D32_SFLOAT:
      return {4, 1};
    case VK_FORMAT_R8G8B8A8_UNORM:
      return {4, 4};
    case VK_FORMAT_R32G32_SFLOAT:
    case VK_FORMAT_R32G32_UINT:
      return {8, 2};
    case VK_FORMAT_R16G16B16A16_SFLOAT:
      return {8, 4};
    case VK_FORMAT_R32G32B32A32_SFLOAT:
      return {16, 4};
    default:
      throw DeviceError("the lab does not use VkFormat " + std::to_string(format));
  }
}

VkBufferImageCopy wholeImage(const Image& image, uint64_t offset) {
  VkBufferImageCopy copy{};
  copy.bufferOffset = offset;
  copy.imageSubresource = {image.aspect(), 0, 0, 1};
  copy.imageExtent = {image.extent().width, image.extent().height, 1};
  return copy;
}

}  // namespace

uint32_t texelBytes(VkFormat format) {
  return formatInfo(format).bytes;
}

VkImageAspectFlags Image::aspect() const {
  return info_.format == VK_FORMAT_D32_SFLOAT ? VK_IMAGE_ASPECT_DEPTH_BIT
                                              : VK_IMAGE_ASPECT_COLOR_BIT;
}

uint64_t Image::bytes() const {
  return uint64_t{info_.extent.width} * info_.extent.height * texelBytes(info_.format);
}

Image::Image(Device& device, const ImageInfo& info) : info_(info) {
  VkImageCreateInfo image_info{.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
  image_info.imageType = VK_IMAGE_TYPE_2D;
  image_info.format = info.format;
  image_info.extent = {info.extent.width, info.extent.height, 1};
  image_info.mipLevels = 1;
  image_info.arrayLayers = 1;
  image_info.samples = info.samples;
  image_info.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT |
                     VK_IMAGE_USAGE_TRANSFER_DST_BIT;
  if (aspect() == VK_IMAGE_ASPECT_DEPTH_BIT) {
    image_info.usage |= VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
  } else {
    image_info.usage |= VK_IMAGE_USAGE_STORAGE_BIT;
    if (info.render_target) image_info.usage |= VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
  }
  image_ = DeviceImage(device, image_info, VK_IMAGE_VIEW_TYPE_2D, aspect());
}

void Image::recordUpload(VkCommandBuffer commands, const Buffer& buffer, uint64_t offset) const {
  const VkBufferImageCopy copy = wholeImage(*this, offset);
  vkCmdCopyBufferToImage(commands, buffer.handle(), handle(), VK_IMAGE_LAYOUT_GENERAL, 1, &copy);
}

void Image::recordDownload(VkCommandBuffer commands, const Buffer& buffer, uint64_t offset) const {
  const VkBufferImageCopy copy = wholeImage(*this, offset);
  vkCmdCopyImageToBuffer(commands, handle(), VK_IMAGE_LAYOUT_GENERAL, buffer.handle(), 1, &copy);
}

std::vector<uint8_t> downloadBytes(Device& device, const Image& image) {
  Buffer staging(device, image.bytes(), BufferKind::kHost);
  device.submitAndWait([&](VkCommandBuffer commands) {
    fullBarrier(commands);
    image.recordDownload(commands, staging);
    fullBarrier(commands);
  });
  const auto* begin = static_cast<const uint8_t*>(staging.mapped());
  return std::vector<uint8_t>(begin, begin + image.bytes());
}

void uploadBytes(Device& device, const Image& image, std::span<const uint8_t> bytes) {
  if (bytes.size() != image.bytes()) throw DeviceError("upload of the wrong size");
  Buffer staging(device, image.bytes(), BufferKind::kHost);
  staging.write(bytes);
  device.submitAndWait([&](VkCommandBuffer commands) {
    image.recordUpload(commands, staging);
    fullBarrier(commands);
  });
}

FloatImage floatsFromTexels(VkFormat format, VkExtent2D extent, const void* texels) {
  FloatImage image(extent.width, extent.height, formatInfo(format).channels);
  const size_t count = image.texels.size();
  switch (format) {
    case VK_FORMAT_R16G16B16A16_SFLOAT: {
      const auto* halves = static_cast<const uint16_t*>(texels);
      for (size_t i = 0; i < count; ++i) image.texels[i] = glm::unpackHalf1x16(halves[i]);
      break;
    }
    case VK_FORMAT_R8G8B8A8_UNORM: {
      const auto* bytes = static_cast<const uint8_t*>(texels);
      for (size_t i = 0; i < count; ++i) image.texels[i] = static_cast<float>(bytes[i]) / 255.0f;
      break;
    }
    case VK_FORMAT_R32_UINT:
    case VK_FORMAT_R32G32_UINT: {
      const auto* words = static_cast<const uint32_t*>(texels);
      for (size_t i = 0; i < count; ++i) image.texels[i] = static_cast<float>(words[i]);
      break;
    }
    default:
      std::memcpy(image.texels.data(), texels, count * sizeof(float));
  }
  return image;
}

FloatImage download(Device& device, const Image& image) {
  return floatsFromTexels(image.format(), image.extent(), downloadBytes(device, image).data());
}

void upload(Device& device, const Image& image, const FloatImage& texels) {
  const FormatInfo info = formatInfo(image.format());
  if (texels.width != image.extent().width || texels.height != image.extent().height ||
      texels.channels != info.channels) {
    throw DeviceError("upload of the wrong shape");
  }
  std::vector<uint8_t> bytes(image.bytes());
  switch (image.format()) {
    case VK_FORMAT_R16G16B16A16_SFLOAT: {
      auto* halves = reinterpret_cast<uint16_t*>(bytes.data());
      for (size_t i = 0; i < texels.texels.size(); ++i) {
        halves[i] = glm::packHalf1x16(texels.texels[i]);
      }
      break;
    }
    case VK_FORMAT_R32_UINT:
    case VK_FORMAT_R32G32_UINT: {
      auto* words = reinterpret_cast<uint32_t*>(bytes.data());
      for (size_t i = 0; i < texels.texels.size(); ++i) {
        words[i] = static_cast<uint32_t>(texels.texels[i]);
      }
      break;
    }
    case VK_FORMAT_R8G8B8A8_UNORM:
      throw DeviceError("upload of RGBA8 from floats is not offered");
    default:
      std::memcpy(bytes.data(), texels.texels.data(), bytes.size());
  }
  uploadBytes(device, image, bytes);
}

}  // namespace reprise::lab
