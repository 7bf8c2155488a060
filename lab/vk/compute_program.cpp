// SPDX-License-Identifier: MIT
#include "lab/vk/compute_program.h"

#include <utility>

#include "core/workgroup.h"

namespace reprise::lab {

VkShaderModule createShaderModule(Device& device, std::span<const uint32_t> spirv) {
  VkShaderModuleCreateInfo info{.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
  info.codeSize = spirv.size_bytes();
  info.pCode = spirv.data();
  VkShaderModule module = VK_NULL_HANDLE;
  check(vkCreateShaderModule(device.handle(), &info, nullptr, &module), "vkCreateShaderModule");
  return module;
}

ComputeProgram::ComputeProgram(Device& device, const ComputeProgramInfo& info)
    : device_(&device),
      layout_(device, info.bindings, info.push_bytes, VK_SHADER_STAGE_COMPUTE_BIT) {
  std::vector<VkSpecializationMapEntry> entries(info.specialization.size());
  for (uint32_t i = 0; i < entries.size(); ++i) entries[i] = {i, i * 4, 4};
  const VkSpecializationInfo specialization{static_cast<uint32_t>(entries.size()), entries.data(),
                                            info.specialization.size() * 4,
                                            info.specialization.data()};
  VkComputePipelineCreateInfo pipeline{.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO};
  pipeline.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
  pipeline.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
  pipeline.stage.module = createShaderModule(device, info.spirv);
  pipeline.stage.pName = "main";
  pipeline.stage.pSpecializationInfo = &specialization;
  pipeline.layout = layout_.handle();
  const VkResult result =
      vkCreateComputePipelines(device.handle(), VK_NULL_HANDLE, 1, &pipeline, nullptr, &pipeline_);
  vkDestroyShaderModule(device.handle(), pipeline.stage.module, nullptr);
  check(result, info.name);
}

ComputeProgram::~ComputeProgram() {
  if (device_ != nullptr) vkDestroyPipeline(device_->handle(), pipeline_, nullptr);
}

ComputeProgram& ComputeProgram::operator=(ComputeProgram&& other) noexcept {
  std::swap(device_, other.device_);
  std::swap(layout_, other.layout_);
  std::swap(pipeline_, other.pipeline_);
  return *this;
}

void ComputeProgram::record(VkCommandBuffer commands, VkExtent2D extent,
                            const std::vector<Bound>& bound, const void* constants,
                            uint32_t constant_bytes) const {
  vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline_);
  layout_.push(commands, VK_PIPELINE_BIND_POINT_COMPUTE, bound, constants, constant_bytes);
  constexpr uint32_t kSize = REPRISE_WORKGROUP_SIZE;
  vkCmdDispatch(commands, (extent.width + kSize - 1) / kSize, (extent.height + kSize - 1) / kSize,
                1);
}

void ComputeProgram::recordIndirect(VkCommandBuffer commands, VkBuffer arguments,
                                    const std::vector<Bound>& bound, const void* constants,
                                    uint32_t constant_bytes) const {
  vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline_);
  layout_.push(commands, VK_PIPELINE_BIND_POINT_COMPUTE, bound, constants, constant_bytes);
  vkCmdDispatchIndirect(commands, arguments, 0);
}

}  // namespace reprise::lab
