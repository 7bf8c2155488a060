// SPDX-License-Identifier: MIT
#include "lab/render/raster_shading.h"

#include <string>

#include "lab/render/background.h"

namespace reprise::lab {
namespace {

constexpr uint32_t kVertexShader[] = {
#include "shade.vert.inc"
};
constexpr uint32_t kFragmentShader[] = {
#include "shade.frag.inc"
};

constexpr VkDescriptorType kStorageBuffer = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;

int32_t toMultiple(uint32_t origin_px, uint32_t size) {
  return static_cast<int32_t>((size - origin_px % size) % size);
}

VkClearColorValue background(uint32_t light_layers) {
  const vec3 rgb = (light_layers & kLightLayerMain) != 0 ? kBackground : vec3(0.0f);
  return {{rgb.x, rgb.y, rgb.z, 1.0f}};
}

}  // namespace

RasterShading::RasterShading(Device& device, const SceneBuffers& buffers,
                             const std::vector<Instance>& instances, VkExtent2D extent,
                             const std::vector<VkDescriptorType>& types,
                             const std::vector<uint32_t>& specialization)
    : device_(device),
      buffers_(buffers),
      instances_(instances),
      extent_(extent),
      types_(followedBy(types, {kStorageBuffer, kStorageBuffer})),
      specialization_(specialization) {
  if (!device.hasFragmentStores()) {
    throw DeviceError("device '" + device.name() +
                      "' has no fragmentStoresAndAtomics: it cannot shade by raster");
  }
  prepare(1);
}

void RasterShading::prepare(uint32_t size) {
  if (size > kMaxCoarseSize || !device_.hasFragmentSize(size)) {
    const std::string side = std::to_string(size);
    throw DeviceError("device '" + device_.name() + "' has no VK_KHR_fragment_shading_rate with " +
                      side + " x " + side + " pixels a fragment; --shade-by compute needs none");
  }
  if (ready_[size]) return;
  std::vector<uint32_t> specialization = specialization_;
  specialization.push_back(size);
  programs_[size] = GraphicsProgram(device_, {.name = "raster shading",
                                              .vertex_spirv = kVertexShader,
                                              .fragment_spirv = kFragmentShader,
                                              .bindings = types_,
                                              .push_bytes = sizeof(RasterConstants),
                                              .color_format = VK_FORMAT_R16G16B16A16_SFLOAT,
                                              .depth_compare = VK_COMPARE_OP_EQUAL,
                                              .depth_write = false,
                                              .fragment_size = size,
                                              .specialization = specialization});
  ready_[size] = true;
  if (size == 1 || visible_.view() != VK_NULL_HANDLE) return;
  const VkExtent2D extent{extent_.width + kMaxCoarseSize - 1, extent_.height + kMaxCoarseSize - 1};
  visible_ =
      Image(device_, {.format = VK_FORMAT_R32G32_UINT, .extent = extent, .render_target = true});
  depth_ =
      Image(device_, {.format = VK_FORMAT_D32_SFLOAT, .extent = extent, .render_target = true});
  color_ = Image(
      device_, {.format = VK_FORMAT_R16G16B16A16_SFLOAT, .extent = extent, .render_target = true});
}

VkOffset2D RasterShading::shiftOf(const CoarseConstants& coarse, uint32_t size) {
  return {toMultiple(coarse.origin_x_px, size), toMultiple(coarse.origin_y_px, size)};
}

void RasterShading::copyToFrame(VkCommandBuffer commands, const Image& from, VkOffset2D shift_px,
                                const Image& to) const {
  const VkImageSubresourceLayers layer{from.aspect(), 0, 0, 1};
  const VkImageCopy copy{
      layer, {shift_px.x, shift_px.y, 0}, layer, {0, 0, 0}, {extent_.width, extent_.height, 1}};
  vkCmdCopyImage(commands, from.handle(), VK_IMAGE_LAYOUT_GENERAL, to.handle(),
                 VK_IMAGE_LAYOUT_GENERAL, 1, &copy);
}

void RasterShading::copyVisibility(VkCommandBuffer commands, VkOffset2D shift_px,
                                   const RasterImages& frame_images) const {
  copyToFrame(commands, visible_, shift_px, *frame_images.visible);
  copyToFrame(commands, depth_, shift_px, *frame_images.depth);
  fullBarrier(commands);
}

void RasterShading::record(VkCommandBuffer commands, const RasterImages& frame_images,
                           const RasterFrame& frame, const ShadingBindings& bindings) const {
  const VkOffset2D shift_px = shiftOf(frame.coarse, frame.size);
  const bool shifted = shift_px.x != 0 || shift_px.y != 0;
  const RasterImages images = shifted ? beside() : frame_images;
  RasterConstants constants{};
  constants.draw.jitter_px = {frame.jitter_px.x, frame.jitter_px.y};
  constants.shade = frame.shade;
  constants.shift_x_px = static_cast<uint32_t>(shift_px.x);
  constants.shift_y_px = static_cast<uint32_t>(shift_px.y);
  constants.shade_covered = frame.coarse.shade_covered;
  draw(commands, images, bindings(*images.visible), constants, frame.size);
  if (!shifted) return;
  copyToFrame(commands, *images.color, shift_px, *frame_images.color);
  fullBarrier(commands);
}

void RasterShading::draw(VkCommandBuffer commands, const RasterImages& images,
                         const std::vector<Bound>& bound, RasterConstants constants,
                         uint32_t size) const {
  const std::vector<Bound> vertices = buffers_.rasterBindings();
  const GraphicsProgram& program = programs_[size];
  beginRendering(commands, {.color = images.color,
                            .depth = images.depth,
                            .clear_color = background(constants.shade.light_layers),
                            .viewport = {{static_cast<int32_t>(constants.shift_x_px),
                                          static_cast<int32_t>(constants.shift_y_px)},
                                         extent_}});
  program.bind(commands);
  bool bindings_pushed = false;
  // Holes are in the depth already: what is drawn in them does not meet it.
  for (const std::vector<uint32_t>* which : {&buffers_.opaque(), &buffers_.tested()}) {
    for (const uint32_t i : *which) {
      constants.draw.instance = i;
      constants.draw.material = instances_[i].material;
      if (bindings_pushed) {
        program.pushConstants(commands, constants);
      } else {
        program.push(commands, followedBy(bound, {vertices[1], vertices[2]}), constants);
        bindings_pushed = true;
      }
      vkCmdDraw(commands, instances_[i].index_count, 1, instances_[i].first_index, 0);
    }
  }
  endRendering(commands);
  fullBarrier(commands);
}

}  // namespace reprise::lab
