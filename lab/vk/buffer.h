// SPDX-License-Identifier: MIT
#pragma once

#include <cstring>
#include <span>
#include <vector>

#include "lab/vk/device.h"

namespace reprise::lab {

enum class BufferKind {
  kDevice,  // filled by fill() or by shaders
  kHost     // mapped for the host for its whole life
};

class Buffer {
 public:
  Buffer() = default;
  Buffer(Device& device, uint64_t bytes, BufferKind kind);
  ~Buffer();
  Buffer(Buffer&& other) noexcept { *this = std::move(other); }
  Buffer& operator=(Buffer&& other) noexcept;

  VkBuffer handle() const { return buffer_; }
  uint64_t bytes() const { return bytes_; }
  // kHost only.
  void* mapped() const { return mapped_; }
  // A view of the whole buffer as texels of `format`, for samplerBuffer. CPU drivers fetch a texel
  // of four floats much faster than four floats of a storage buffer.
  void makeTexelView(VkFormat format);
  VkBufferView texelView() const { return texel_view_; }
  template <typename T>
  void write(std::span<const T> data) {
    // memcpy takes no null pointer, and an empty span has one.
    if (!data.empty()) std::memcpy(mapped_, data.data(), data.size_bytes());
  }

 private:
  Device* device_ = nullptr;
  VkBuffer buffer_ = VK_NULL_HANDLE;
  VkDeviceMemory memory_ = VK_NULL_HANDLE;
  VkBufferView texel_view_ = VK_NULL_HANDLE;
  uint64_t bytes_ = 0;
  void* mapped_ = nullptr;
};

// A device buffer that holds `data`, uploaded at once.
template <typename T>
Buffer deviceBuffer(Device& device, std::span<const T> data) {
  Buffer staging(device, data.size_bytes() == 0 ? 16 : data.size_bytes(), BufferKind::kHost);
  staging.write(data);
  Buffer buffer(device, staging.bytes(), BufferKind::kDevice);
  device.submitAndWait([&](VkCommandBuffer commands) {
    const VkBufferCopy copy{0, 0, staging.bytes()};
    vkCmdCopyBuffer(commands, staging.handle(), buffer.handle(), 1, &copy);
  });
  return buffer;
}

}  // namespace reprise::lab
