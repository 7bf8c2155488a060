// SPDX-License-Identifier: MIT
#include "lab/vk/bindings.h"

#include <utility>

namespace reprise::lab {

ProgramLayout::ProgramLayout(Device& device, const std::vector<VkDescriptorType>& types,
                             uint32_t push_bytes, VkShaderStageFlags stages)
    : device_(&device), types_(types), push_bytes_(push_bytes), stages_(stages) {
  VkSamplerCreateInfo sampler_info{.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
  sampler_info.addressModeU = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  sampler_info.addressModeV = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  sampler_info.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  check(vkCreateSampler(device.handle(), &sampler_info, nullptr, &nearest_), "vkCreateSampler");
  std::vector<VkDescriptorSetLayoutBinding> bindings;
  for (uint32_t i = 0; i < types.size(); ++i) {
    const bool takes_sampler = types[i] == VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    bindings.push_back({i, types[i], 1, stages, takes_sampler ? &nearest_ : nullptr});
  }
  VkDescriptorSetLayoutCreateInfo set_info{.sType =
                                               VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
  set_info.flags = VK_DESCRIPTOR_SET_LAYOUT_CREATE_PUSH_DESCRIPTOR_BIT_KHR;
  set_info.bindingCount = static_cast<uint32_t>(bindings.size());
  set_info.pBindings = bindings.data();
  check(vkCreateDescriptorSetLayout(device.handle(), &set_info, nullptr, &set_layout_),
        "vkCreateDescriptorSetLayout");
  const VkPushConstantRange range{stages, 0, push_bytes};
  VkPipelineLayoutCreateInfo info{.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
  info.setLayoutCount = 1;
  info.pSetLayouts = &set_layout_;
  info.pushConstantRangeCount = push_bytes > 0 ? 1 : 0;
  info.pPushConstantRanges = &range;
  check(vkCreatePipelineLayout(device.handle(), &info, nullptr, &layout_),
        "vkCreatePipelineLayout");
}

ProgramLayout::~ProgramLayout() {
  if (device_ == nullptr) return;
  vkDestroyPipelineLayout(device_->handle(), layout_, nullptr);
  vkDestroyDescriptorSetLayout(device_->handle(), set_layout_, nullptr);
  vkDestroySampler(device_->handle(), nearest_, nullptr);
}

ProgramLayout& ProgramLayout::operator=(ProgramLayout&& other) noexcept {
  std::swap(device_, other.device_);
  std::swap(types_, other.types_);
  std::swap(push_bytes_, other.push_bytes_);
  std::swap(stages_, other.stages_);
  std::swap(nearest_, other.nearest_);
  std::swap(set_layout_, other.set_layout_);
  std::swap(layout_, other.layout_);
  return *this;
}

void ProgramLayout::push(VkCommandBuffer commands, VkPipelineBindPoint point,
                         const std::vector<Bound>& bound, const void* constants,
                         uint32_t constant_bytes) const {
  if (bound.size() != types_.size()) {
    throw DeviceError("a program was given other bindings than it declares");
  }
  std::vector<VkWriteDescriptorSet> writes;
  for (const Bound& item : bound) {
    const auto index = static_cast<uint32_t>(writes.size());
    if (item.type != types_[index]) throw DeviceError("a binding is of another type than declared");
    VkWriteDescriptorSet write{.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
    write.dstBinding = index;
    write.descriptorCount = 1;
    write.descriptorType = item.type;
    write.pImageInfo = &item.image;
    write.pBufferInfo = &item.buffer;
    write.pTexelBufferView = &item.texels;
    writes.push_back(write);
  }
  vkCmdPushDescriptorSetKHR(commands, point, layout_, 0, static_cast<uint32_t>(writes.size()),
                            writes.data());
  pushConstants(commands, constants, constant_bytes);
}

void ProgramLayout::pushConstants(VkCommandBuffer commands, const void* constants,
                                  uint32_t bytes) const {
  if (bytes != push_bytes_) {
    throw DeviceError("a program was given other constants than it declares");
  }
  if (bytes > 0) vkCmdPushConstants(commands, layout_, stages_, 0, bytes, constants);
}

}  // namespace reprise::lab
