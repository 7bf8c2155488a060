// SPDX-License-Identifier: MIT
#include "lab/vk/graphics_program.h"

#include <utility>

#include "lab/vk/compute_program.h"

namespace reprise::lab {

GraphicsProgram::GraphicsProgram(Device& device, const GraphicsProgramInfo& info)
    : device_(&device),
      layout_(device, info.bindings, info.push_bytes,
              VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT) {
  std::vector<VkSpecializationMapEntry> entries(info.specialization.size());
  for (uint32_t i = 0; i < entries.size(); ++i) entries[i] = {i, i * 4, 4};
  const VkSpecializationInfo specialization{static_cast<uint32_t>(entries.size()), entries.data(),
                                            info.specialization.size() * 4,
                                            info.specialization.data()};
  VkPipelineShaderStageCreateInfo stages[2] = {};
  for (VkPipelineShaderStageCreateInfo& stage : stages) {
    stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    stage.pName = "main";
    stage.pSpecializationInfo = &specialization;
  }
  stages[0].stage = VK_SHADER_STAGE_VERTEX_BIT;
  stages[0].module = createShaderModule(device, info.vertex_spirv);
  stages[1].stage = VK_SHADER_STAGE_FRAGMENT_BIT;
  const bool has_fragments = !info.fragment_spirv.empty();
  if (has_fragments) stages[1].module = createShaderModule(device, info.fragment_spirv);

  VkPipelineVertexInputStateCreateInfo vertex_input{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
  VkPipelineInputAssemblyStateCreateInfo assembly{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
  assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  VkPipelineViewportStateCreateInfo viewport{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO};
  viewport.viewportCount = 1;
  viewport.scissorCount = 1;
  VkPipelineRasterizationStateCreateInfo raster{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
  raster.cullMode = VK_CULL_MODE_NONE;
  raster.lineWidth = 1.0f;
  raster.depthBiasEnable = info.depth_bias_slope != 0.0f ? VK_TRUE : VK_FALSE;
  raster.depthBiasSlopeFactor = info.depth_bias_slope;
  VkPipelineMultisampleStateCreateInfo multisample{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
  multisample.rasterizationSamples = info.samples;
  VkPipelineDepthStencilStateCreateInfo depth{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO};
  depth.depthTestEnable = VK_TRUE;
  depth.depthWriteEnable = info.depth_write ? VK_TRUE : VK_FALSE;
  depth.depthCompareOp = info.depth_compare;
  VkPipelineColorBlendAttachmentState attachment{};
  attachment.colorWriteMask = VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT |
                              VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
  VkPipelineColorBlendStateCreateInfo blend{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
  const bool has_color = info.color_format != VK_FORMAT_UNDEFINED;
  blend.attachmentCount = has_color ? 1 : 0;
  blend.pAttachments = &attachment;
  const VkDynamicState dynamic_states[] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
  VkPipelineDynamicStateCreateInfo dynamic{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO};
  dynamic.dynamicStateCount = 2;
  dynamic.pDynamicStates = dynamic_states;
  VkPipelineRenderingCreateInfoKHR rendering{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO_KHR};
  rendering.colorAttachmentCount = has_color ? 1 : 0;
  rendering.pColorAttachmentFormats = &info.color_format;
  rendering.depthAttachmentFormat = info.depth_format;

  VkPipelineFragmentShadingRateStateCreateInfoKHR rate{
      .sType = VK_STRUCTURE_TYPE_PIPELINE_FRAGMENT_SHADING_RATE_STATE_CREATE_INFO_KHR};
  rate.fragmentSize = {info.fragment_size, info.fragment_size};
  // The pipeline's own, whatever primitives or an attachment would say.
  rate.combinerOps[0] = VK_FRAGMENT_SHADING_RATE_COMBINER_OP_KEEP_KHR;
  rate.combinerOps[1] = VK_FRAGMENT_SHADING_RATE_COMBINER_OP_KEEP_KHR;
  // Not where the extension may be missing.
  if (info.fragment_size > 1) rendering.pNext = &rate;

  VkGraphicsPipelineCreateInfo pipeline{.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO};
  pipeline.pNext = &rendering;
  pipeline.stageCount = has_fragments ? 2 : 1;
  pipeline.pStages = stages;
  pipeline.pVertexInputState = &vertex_input;
  pipeline.pInputAssemblyState = &assembly;
  pipeline.pViewportState = &viewport;
  pipeline.pRasterizationState = &raster;
  pipeline.pMultisampleState = &multisample;
  pipeline.pDepthStencilState = &depth;
  pipeline.pColorBlendState = &blend;
  pipeline.pDynamicState = &dynamic;
  pipeline.layout = layout_.handle();
  const VkResult result =
      vkCreateGraphicsPipelines(device.handle(), VK_NULL_HANDLE, 1, &pipeline, nullptr, &pipeline_);
  for (const VkPipelineShaderStageCreateInfo& stage : stages) {
    vkDestroyShaderModule(device.handle(), stage.module, nullptr);
  }
  check(result, info.name);
}

GraphicsProgram::~GraphicsProgram() {
  if (device_ != nullptr) vkDestroyPipeline(device_->handle(), pipeline_, nullptr);
}

GraphicsProgram& GraphicsProgram::operator=(GraphicsProgram&& other) noexcept {
  std::swap(device_, other.device_);
  std::swap(layout_, other.layout_);
  std::swap(pipeline_, other.pipeline_);
  return *this;
}

void GraphicsProgram::bind(VkCommandBuffer commands) const {
  vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_);
}

void beginRendering(VkCommandBuffer commands, const RenderTargets& targets) {
  VkRenderingAttachmentInfoKHR color_info{.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO_KHR};
  VkRenderingAttachmentInfoKHR depth_info = color_info;
  for (VkRenderingAttachmentInfoKHR* info : {&color_info, &depth_info}) {
    info->imageLayout = VK_IMAGE_LAYOUT_GENERAL;
    info->loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
    info->storeOp = VK_ATTACHMENT_STORE_OP_STORE;
  }
  if (targets.color != nullptr) color_info.imageView = targets.color->view();
  color_info.clearValue.color = targets.clear_color;
  depth_info.imageView = targets.depth->view();
  if (targets.clear_depth.has_value()) {
    depth_info.clearValue.depthStencil.depth = *targets.clear_depth;
  } else {
    depth_info.loadOp = VK_ATTACHMENT_LOAD_OP_LOAD;
  }
  const VkExtent2D extent = targets.depth->extent();
  VkRenderingInfoKHR rendering{.sType = VK_STRUCTURE_TYPE_RENDERING_INFO_KHR};
  rendering.renderArea.extent = extent;
  rendering.layerCount = 1;
  rendering.colorAttachmentCount = targets.color != nullptr ? 1 : 0;
  rendering.pColorAttachments = &color_info;
  rendering.pDepthAttachment = &depth_info;
  vkCmdBeginRenderingKHR(commands, &rendering);
  const VkRect2D seen =
      targets.viewport.extent.width > 0 ? targets.viewport : VkRect2D{{0, 0}, extent};
  const VkViewport viewport{static_cast<float>(seen.offset.x),
                            static_cast<float>(seen.offset.y),
                            static_cast<float>(seen.extent.width),
                            static_cast<float>(seen.extent.height),
                            0.0f,
                            1.0f};
  vkCmdSetViewport(commands, 0, 1, &viewport);
  vkCmdSetScissor(commands, 0, 1, &rendering.renderArea);
}

void beginRendering(VkCommandBuffer commands, const Image* color, const Image& depth,
                    float clear_depth) {
  beginRendering(commands, {.color = color, .depth = &depth, .clear_depth = clear_depth});
}

void endRendering(VkCommandBuffer commands) {
  vkCmdEndRenderingKHR(commands);
}

}  // namespace reprise::lab
