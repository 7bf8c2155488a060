// SPDX-License-Identifier: MIT
#include "core/compute_pass.h"

#include <cassert>

#include "core/error.h"
#include "core/workgroup.h"

namespace reprise {
namespace {

VkDescriptorType descriptorType(Binding binding) {
  switch (binding) {
    case Binding::kTexel:
    case Binding::kLinear:
      return VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    case Binding::kStorage:
      return VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
    case Binding::kBuffer:
      return VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    case Binding::kConstants:
      return VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
  }
  return VK_DESCRIPTOR_TYPE_MAX_ENUM;
}

}  // namespace

ComputePass::ComputePass(const Gpu& gpu, const PassInfo& info, VkSampler nearest, VkSampler linear,
                         uint32_t frames_in_flight)
    : gpu_(gpu), name_(info.name), bindings_(info.bindings), constant_bytes_(info.constant_bytes) {
  try {
    build(info, nearest, linear, frames_in_flight);
  } catch (...) {
    release();
    throw;
  }
}

void ComputePass::build(const PassInfo& info, VkSampler nearest, VkSampler linear,
                        uint32_t frames_in_flight) {
  const std::string what = "pass '" + std::string(name_) + "'";
  const auto count = static_cast<uint32_t>(bindings_.size());
  assert(count <= kMaxBindings);
  std::vector<VkDescriptorSetLayoutBinding> layout_bindings(count);
  std::vector<VkDescriptorPoolSize> pool_sizes(count);
  for (uint32_t i = 0; i < count; ++i) {
    const VkSampler* sampler = bindings_[i] == Binding::kTexel    ? &nearest
                               : bindings_[i] == Binding::kLinear ? &linear
                                                                  : nullptr;
    layout_bindings[i] = {i, descriptorType(bindings_[i]), 1, VK_SHADER_STAGE_COMPUTE_BIT, sampler};
    pool_sizes[i] = {descriptorType(bindings_[i]), frames_in_flight};
  }
  VkDescriptorSetLayoutCreateInfo set_info{.sType =
                                               VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
  set_info.bindingCount = count;
  set_info.pBindings = layout_bindings.data();
  check(gpu_.vk.CreateDescriptorSetLayout(gpu_.device, &set_info, nullptr, &set_layout_), what);

  VkPipelineLayoutCreateInfo layout_info{.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
  layout_info.setLayoutCount = 1;
  layout_info.pSetLayouts = &set_layout_;
  check(gpu_.vk.CreatePipelineLayout(gpu_.device, &layout_info, nullptr, &layout_), what);

  VkDescriptorPoolCreateInfo pool_info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
  pool_info.maxSets = frames_in_flight;
  pool_info.poolSizeCount = count;
  pool_info.pPoolSizes = pool_sizes.data();
  check(gpu_.vk.CreateDescriptorPool(gpu_.device, &pool_info, nullptr, &pool_), what);
  const std::vector<VkDescriptorSetLayout> layouts(frames_in_flight, set_layout_);
  sets_.resize(frames_in_flight);
  VkDescriptorSetAllocateInfo allocate_info{.sType =
                                                VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
  allocate_info.descriptorPool = pool_;
  allocate_info.descriptorSetCount = frames_in_flight;
  allocate_info.pSetLayouts = layouts.data();
  check(gpu_.vk.AllocateDescriptorSets(gpu_.device, &allocate_info, sets_.data()), what);

  std::vector<VkSpecializationMapEntry> entries(info.specialization.size());
  for (uint32_t i = 0; i < entries.size(); ++i) entries[i] = {i, i * 4, 4};
  const VkSpecializationInfo specialization{static_cast<uint32_t>(entries.size()), entries.data(),
                                            info.specialization.size() * 4,
                                            info.specialization.data()};
  VkShaderModuleCreateInfo module_info{.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
  module_info.codeSize = info.spirv.size_bytes();
  module_info.pCode = info.spirv.data();
  VkShaderModule module = VK_NULL_HANDLE;
  check(gpu_.vk.CreateShaderModule(gpu_.device, &module_info, nullptr, &module), what);
  VkComputePipelineCreateInfo pipeline_info{.sType =
                                                VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO};
  pipeline_info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
  pipeline_info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
  pipeline_info.stage.module = module;
  pipeline_info.stage.pName = "main";
  pipeline_info.stage.pSpecializationInfo = &specialization;
  pipeline_info.layout = layout_;
  const VkResult result = gpu_.vk.CreateComputePipelines(gpu_.device, gpu_.pipeline_cache, 1,
                                                         &pipeline_info, nullptr, &pipeline_);
  gpu_.vk.DestroyShaderModule(gpu_.device, module, nullptr);
  check(result, what);
}

ComputePass::~ComputePass() {
  release();
}

void ComputePass::release() {
  gpu_.vk.DestroyPipeline(gpu_.device, pipeline_, nullptr);
  gpu_.vk.DestroyDescriptorPool(gpu_.device, pool_, nullptr);
  gpu_.vk.DestroyPipelineLayout(gpu_.device, layout_, nullptr);
  gpu_.vk.DestroyDescriptorSetLayout(gpu_.device, set_layout_, nullptr);
}

void PassRecording::expect([[maybe_unused]] Binding a, [[maybe_unused]] Binding b) const {
  assert(count_ < pass_.bindings_.size());
  assert(pass_.bindings_[count_] == a || pass_.bindings_[count_] == b);
}

PassRecording& PassRecording::read(VkImageView view, VkImageLayout layout) {
  expect(Binding::kTexel, Binding::kLinear);
  images_[count_++] = {VK_NULL_HANDLE, view, layout};
  return *this;
}

PassRecording& PassRecording::write(VkImageView view) {
  expect(Binding::kStorage, Binding::kStorage);
  images_[count_++] = {VK_NULL_HANDLE, view, VK_IMAGE_LAYOUT_GENERAL};
  return *this;
}

PassRecording& PassRecording::buffer(VkBuffer buffer) {
  expect(Binding::kBuffer, Binding::kBuffer);
  buffers_[count_++] = {buffer, 0, VK_WHOLE_SIZE};
  return *this;
}

PassRecording& PassRecording::constants(const void* data, uint32_t bytes) {
  expect(Binding::kConstants, Binding::kConstants);
  assert(bytes == pass_.constant_bytes_);
  buffers_[count_] = {target_.constants->buffer(), target_.constants->write(data, bytes), bytes};
  ++count_;
  return *this;
}

// `end`: 0 before the pass, 1 after it.
void PassRecording::writeTimestamp(uint32_t end) const {
  if (target_.timestamps == VK_NULL_HANDLE) return;
  pass_.gpu_.vk.CmdWriteTimestamp(target_.commands, VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT,
                                  target_.timestamps,
                                  target_.first_timestamp + 2 * pass_index_ + end);
  if (end == 1) return;
  // lavapipe takes a timestamp with its next flush, which a dispatch that reads nothing drawn
  // before does not do: the pass would begin after its own end. A barrier flushes.
  pass_.gpu_.vk.CmdPipelineBarrier(target_.commands, VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT,
                                   VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, 0, 0, nullptr, 0, nullptr,
                                   0, nullptr);
}

void PassRecording::skip() {
  writeTimestamp(0);
  writeTimestamp(1);
}

void PassRecording::dispatch(VkExtent2D extent) {
  assert(count_ == pass_.bindings_.size());
  const VulkanFunctions& vk = pass_.gpu_.vk;
  const VkDescriptorSet set = pass_.sets_[target_.slot];
  VkWriteDescriptorSet writes[ComputePass::kMaxBindings];
  for (uint32_t i = 0; i < count_; ++i) {
    writes[i] = {.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
    writes[i].dstSet = set;
    writes[i].dstBinding = i;
    writes[i].descriptorCount = 1;
    writes[i].descriptorType = descriptorType(pass_.bindings_[i]);
    writes[i].pImageInfo = &images_[i];
    writes[i].pBufferInfo = &buffers_[i];
  }
  vk.UpdateDescriptorSets(pass_.gpu_.device, count_, writes, 0, nullptr);

  const VkCommandBuffer commands = target_.commands;
  writeTimestamp(0);
  vk.CmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pass_.pipeline_);
  vk.CmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pass_.layout_, 0, 1, &set, 0,
                           nullptr);
  constexpr uint32_t kSize = REPRISE_WORKGROUP_SIZE;
  vk.CmdDispatch(commands, (extent.width + kSize - 1) / kSize, (extent.height + kSize - 1) / kSize,
                 1);
  writeTimestamp(1);
  // Read after write by the next pass or the next frame, and write after read by the next frame.
  VkMemoryBarrier barrier{.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER};
  barrier.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT;
  barrier.dstAccessMask = VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT;
  vk.CmdPipelineBarrier(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT,
                        VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, 0, 1, &barrier, 0, nullptr, 0,
                        nullptr);
}

}  // namespace reprise
