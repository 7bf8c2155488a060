// SPDX-License-Identifier: MIT
#include "lab/vk/buffer.h"

#include <utility>

namespace reprise::lab {

Buffer::Buffer(Device& device, uint64_t bytes, BufferKind kind) : device_(&device), bytes_(bytes) {
  VkBufferCreateInfo info{.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
  info.size = bytes;
  info.usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT |
               VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT |
               VK_BUFFER_USAGE_INDEX_BUFFER_BIT | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT |
               VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT;
  check(vkCreateBuffer(device.handle(), &info, nullptr, &buffer_), "vkCreateBuffer");
  VkMemoryRequirements needs{};
  vkGetBufferMemoryRequirements(device.handle(), buffer_, &needs);
  const bool host = kind == BufferKind::kHost;
  memory_ =
      host ? device.allocate(
                 needs, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT,
                 VK_MEMORY_PROPERTY_HOST_CACHED_BIT)
           : device.allocate(needs, 0, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
  check(vkBindBufferMemory(device.handle(), buffer_, memory_, 0), "vkBindBufferMemory");
  if (host) {
    check(vkMapMemory(device.handle(), memory_, 0, VK_WHOLE_SIZE, 0, &mapped_), "vkMapMemory");
  }
}

void Buffer::makeTexelView(VkFormat format) {
  VkBufferViewCreateInfo info{.sType = VK_STRUCTURE_TYPE_BUFFER_VIEW_CREATE_INFO};
  info.buffer = buffer_;
  info.format = format;
  info.range = VK_WHOLE_SIZE;
  check(vkCreateBufferView(device_->handle(), &info, nullptr, &texel_view_), "vkCreateBufferView");
}

Buffer::~Buffer() {
  if (device_ == nullptr) return;
  vkDestroyBufferView(device_->handle(), texel_view_, nullptr);
  vkDestroyBuffer(device_->handle(), buffer_, nullptr);
  vkFreeMemory(device_->handle(), memory_, nullptr);
}

Buffer& Buffer::operator=(Buffer&& other) noexcept {
  std::swap(device_, other.device_);
  std::swap(buffer_, other.buffer_);
  std::swap(memory_, other.memory_);
  std::swap(texel_view_, other.texel_view_);
  std::swap(bytes_, other.bytes_);
  std::swap(mapped_, other.mapped_);
  return *this;
}

}  // namespace reprise::lab
