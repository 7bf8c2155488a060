// SPDX-License-Identifier: MIT
#pragma once

#include "lab/vk/device.h"

namespace reprise::lab {

// A VkImage with its memory and one view of all of it, in VK_IMAGE_LAYOUT_GENERAL from its creation
// on: what images and texture arrays have in common.
class DeviceImage {
 public:
  DeviceImage() = default;
  DeviceImage(Device& device, const VkImageCreateInfo& info, VkImageViewType view_type,
              VkImageAspectFlags aspect);
  ~DeviceImage();
  DeviceImage(DeviceImage&& other) noexcept { *this = std::move(other); }
  DeviceImage& operator=(DeviceImage&& other) noexcept;

  VkImage handle() const { return image_; }
  VkImageView view() const { return view_; }

 private:
  Device* device_ = nullptr;
  VkImage image_ = VK_NULL_HANDLE;
  VkDeviceMemory memory_ = VK_NULL_HANDLE;
  VkImageView view_ = VK_NULL_HANDLE;
};

}  // namespace reprise::lab
