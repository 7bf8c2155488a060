// SPDX-License-Identifier: MIT
#pragma once

#include <initializer_list>
#include <vector>

#include "lab/vk/buffer.h"
#include "lab/vk/image.h"

namespace reprise::lab {

// What a shader's binding is given. Bindings are numbered 0, 1, 2 ... in the order in which they
// are listed, in set 0, as push descriptors.
struct Bound {
  VkDescriptorType type;
  VkDescriptorImageInfo image{};
  VkDescriptorBufferInfo buffer{};
  VkBufferView texels = VK_NULL_HANDLE;
};

// texelFetch only: the program's sampler is nearest and clamped.
inline Bound sampled(const Image& image) {
  return {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
          {VK_NULL_HANDLE, image.view(), VK_IMAGE_LAYOUT_GENERAL},
          {}};
}
// A view and a sampler of their own, for `texture...` and `sampler` of a shader.
inline Bound separateImage(VkImageView view) {
  return {VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE, {VK_NULL_HANDLE, view, VK_IMAGE_LAYOUT_GENERAL}, {}};
}
inline Bound separateSampler(VkSampler sampler) {
  return {VK_DESCRIPTOR_TYPE_SAMPLER, {sampler, VK_NULL_HANDLE, VK_IMAGE_LAYOUT_UNDEFINED}, {}};
}
inline Bound stored(const Image& image) {
  return {VK_DESCRIPTOR_TYPE_STORAGE_IMAGE,
          {VK_NULL_HANDLE, image.view(), VK_IMAGE_LAYOUT_GENERAL},
          {}};
}
inline Bound stored(const Buffer& buffer) {
  return {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, {}, {buffer.handle(), 0, VK_WHOLE_SIZE}};
}
inline Bound stored(VkBuffer buffer) {
  return {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, {}, {buffer, 0, VK_WHOLE_SIZE}};
}
inline Bound texels(const Buffer& buffer) {
  return {VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER, {}, {}, buffer.texelView()};
}
inline Bound uniform(const Buffer& buffer) {
  return {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, {}, {buffer.handle(), 0, VK_WHOLE_SIZE}};
}

// Bindings that many passes share, followed by a pass's own.
template <typename T>
std::vector<T> followedBy(std::vector<T> shared, std::initializer_list<T> own) {
  shared.insert(shared.end(), own);
  return shared;
}
template <typename T>
std::vector<T> followedBy(std::vector<T> shared, const std::vector<T>& own) {
  shared.insert(shared.end(), own.begin(), own.end());
  return shared;
}

// The layout that programs share: set 0 of push descriptors, one range of push constants.
class ProgramLayout {
 public:
  ProgramLayout() = default;
  ProgramLayout(Device& device, const std::vector<VkDescriptorType>& types, uint32_t push_bytes,
                VkShaderStageFlags stages);
  ~ProgramLayout();
  ProgramLayout(ProgramLayout&& other) noexcept { *this = std::move(other); }
  ProgramLayout& operator=(ProgramLayout&& other) noexcept;

  VkPipelineLayout handle() const { return layout_; }
  void pushConstants(VkCommandBuffer commands, const void* constants, uint32_t bytes) const;
  // Throws DeviceError when `bound` or the size of the push constants is not what was declared.
  void push(VkCommandBuffer commands, VkPipelineBindPoint point, const std::vector<Bound>& bound,
            const void* constants, uint32_t constant_bytes) const;

 private:
  Device* device_ = nullptr;
  std::vector<VkDescriptorType> types_;
  uint32_t push_bytes_ = 0;
  VkShaderStageFlags stages_ = 0;
  VkSampler nearest_ = VK_NULL_HANDLE;
  VkDescriptorSetLayout set_layout_ = VK_NULL_HANDLE;
  VkPipelineLayout layout_ = VK_NULL_HANDLE;
};

}  // namespace reprise::lab
