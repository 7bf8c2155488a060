// SPDX-License-Identifier: MIT
#include "lab/render/renderer.h"

#include <algorithm>
#include <cstring>
#include <glm/gtc/matrix_transform.hpp>

namespace reprise::lab {
namespace {

constexpr uint32_t kVisibilityVertexShader[] = {
#include "visibility.vert.inc"
};
constexpr uint32_t kInvariantVertexShader[] = {
#include "visibility_invariant.vert.inc"
};
constexpr uint32_t kVisibilityFragmentShader[] = {
#include "visibility.frag.inc"
};
constexpr uint32_t kVisibilityTestedShader[] = {
#include "visibility_tested.frag.inc"
};
constexpr uint32_t kHolesShader[] = {
#include "holes.frag.inc"
};
constexpr uint32_t kTransformShader[] = {
#include "transform.comp.inc"
};
constexpr uint32_t kMotionShader[] = {
#include "motion.comp.inc"
};
constexpr uint32_t kShadeShader[] = {
#include "shade.comp.inc"
};
constexpr uint32_t kLateShader[] = {
#include "late.comp.inc"
};
constexpr uint32_t kServeShader[] = {
#include "serve.comp.inc"
};
constexpr uint32_t kFinishShader[] = {
#include "finish.comp.inc"
};

constexpr VkDescriptorType kStorageBuffer = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
constexpr VkDescriptorType kTexels = VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER;
constexpr VkDescriptorType kSampled = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
constexpr VkDescriptorType kStored = VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;

template <typename T>
void append(std::vector<uint8_t>& bytes, const T* data, size_t count) {
  const auto* begin = reinterpret_cast<const uint8_t*>(data);
  bytes.insert(bytes.end(), begin, begin + count * sizeof(T));
}

// Reversed depth with the far plane at infinity, Vulkan clip space (y down): depth = near /
// view_depth.
glm::mat4 projection(float vertical_fov, float aspect, float near_plane) {
  const float scale = 1.0f / std::tan(0.5f * vertical_fov);
  glm::mat4 p(0.0f);
  p[0][0] = scale / aspect;
  p[1][1] = -scale;
  p[2][3] = -1.0f;
  p[3][2] = near_plane;
  return p;
}

}  // namespace

Renderer::Renderer(Device& device, const SceneRun& run, VkExtent2D extent, double frame_rate,
                   const RenderSwitches& switches)
    : device_(device),
      scene_(run.scene->create()),
      run_(run),
      extent_(extent),
      view_extent_(switches.view_extent.width > 0 ? switches.view_extent : extent),
      frame_rate_(frame_rate),
      buffers_(device, *scene_, switches.texture_filter),
      shadow_map_(device, *scene_, buffers_),
      light_tiles_(device,
                   scatteredLamps(*scene_, switches.lamps.value_or(scene_->lampCount()),
                                  switches.lamp_reach),
                   extent, switches.cull_lamps),
      visible_(device, {.format = VK_FORMAT_R32G32_UINT, .extent = extent, .render_target = true}),
      depth_(device, {.format = VK_FORMAT_D32_SFLOAT, .extent = extent, .render_target = true}),
      motion_(device, {.format = VK_FORMAT_R32G32_SFLOAT, .extent = extent}),
      color_(device, {.format = VK_FORMAT_R16G16B16A16_SFLOAT,
                      .extent = extent,
                      .render_target = switches.shade_by == ShadeBy::kRaster}),
      sum_(device, {.format = VK_FORMAT_R32G32B32A32_SFLOAT, .extent = extent}) {
  createPrograms(device, switches.shade_by);
}

std::vector<VkDescriptorType> Renderer::shadingTypes() {
  return followedBy(SceneBuffers::shadingTypes(), LightTiles::types());
}

std::vector<Bound> Renderer::shadingBindings(const Image& visible) const {
  return followedBy(buffers_.shadingBindings(visible, shadow_map_.image()),
                    light_tiles_.bindings());
}

std::vector<uint32_t> Renderer::shadeSpecialization(bool accumulate) const {
  return {buffers_.materialKinds(),   accumulate ? 1u : 0u,
          buffers_.onlyKind(),        buffers_.textures().classCount(),
          shadow_map_.on() ? 1u : 0u, buffers_.textures().anisotropy(),
          light_tiles_.lampCount()};
}

ComputeProgram Renderer::createShadeProgram(Device& device, bool accumulate) const {
  return ComputeProgram(device, {.name = "shade",
                                 .spirv = kShadeShader,
                                 .bindings = followedBy(shadingTypes(), {kStored, kStored}),
                                 .push_bytes = sizeof(ShadeConstants),
                                 .specialization = shadeSpecialization(accumulate)});
}

void Renderer::createPrograms(Device& device, ShadeBy shade_by) {
  GraphicsProgramInfo visibility{.name = "visibility",
                                 .vertex_spirv = kVisibilityVertexShader,
                                 .fragment_spirv = kVisibilityFragmentShader,
                                 .bindings = SceneBuffers::rasterTypes(),
                                 .push_bytes = sizeof(VisibilityConstants),
                                 .color_format = VK_FORMAT_R32G32_UINT,
                                 .specialization = {}};
  if (shade_by == ShadeBy::kRaster) {
    visibility.vertex_spirv = kInvariantVertexShader;
    raster_ = std::make_unique<RasterShading>(device, buffers_, scene_->geometry().instances,
                                              extent_, shadingTypes(), shadeSpecialization(false));
  }
  visibility_program_ = GraphicsProgram(device, visibility);
  if (!buffers_.tested().empty()) {
    visibility.name = "visibility, tested";
    visibility.fragment_spirv = kVisibilityTestedShader;
    visibility.bindings = SceneBuffers::testedTypes();
    visibility.specialization = buffers_.rasterSpecialization(true);
    tested_program_ = GraphicsProgram(device, visibility);
  }
  transform_program_ =
      ComputeProgram(device, {.name = "transform",
                              .spirv = kTransformShader,
                              .bindings = SceneBuffers::transformTypes(),
                              .push_bytes = sizeof(TransformConstants),
                              .specialization = buffers_.transformSpecialization()});
  motion_program_ = ComputeProgram(
      device, {.name = "motion",
               .spirv = kMotionShader,
               .bindings = followedBy(SceneBuffers::surfaceTypes(), {kTexels, kStored}),
               .push_bytes = sizeof(MotionConstants),
               .specialization = {}});
  shade_program_ = createShadeProgram(device, false);
  accumulate_program_ = createShadeProgram(device, true);
  mean_program_ = ComputeProgram(device, {.name = "mean",
                                          .spirv = kFinishShader,
                                          .bindings = {kSampled, kStored},
                                          .push_bytes = sizeof(FinishConstants),
                                          .specialization = {}});
}

RepriseCamera Renderer::cameraAt(double time_s, float* near_plane) const {
  const CameraPose pose =
      scene_->camera(run_.camera->name, run_.values, time_s, view_extent_.height);
  const float aspect =
      static_cast<float>(view_extent_.width) / static_cast<float>(view_extent_.height);
  const glm::mat4 view = glm::lookAt(pose.eye_world, pose.target_world, pose.up_world);
  const glm::mat4 proj = projection(pose.vertical_fov, aspect, pose.near_plane);
  RepriseCamera camera{};
  std::memcpy(camera.view, &view, sizeof(view));
  std::memcpy(camera.projection, &proj, sizeof(proj));
  if (near_plane != nullptr) *near_plane = pose.near_plane;
  return camera;
}

double Renderer::timeOf(double frame) const {
  if (run_.camera->frozen_at_s.has_value()) return *run_.camera->frozen_at_s;
  return std::max(frame, 0.0) / frame_rate_;
}

void Renderer::setFrame(double frame, float mip_bias) {
  GpuFrame data{};
  for (uint32_t age = 0; age <= kMaxFramesBack; ++age) {
    const double time_s = timeOf(frame - age);
    const RepriseCamera camera = cameraAt(time_s, nullptr);
    glm::mat4 view;
    glm::mat4 proj;
    std::memcpy(&view, camera.view, sizeof(view));
    std::memcpy(&proj, camera.projection, sizeof(proj));
    data.view_projection[age] = proj * view;
    data.wind[age] = glm::vec4(scene_->wind_world(time_s), static_cast<float>(time_s));
    glm::mat4* transforms = buffers_.transforms(age);
    for (uint32_t i = 0; i < buffers_.instanceCount(); ++i) {
      transforms[i] = scene_->transform(i, time_s);
    }
  }
  const double now_s = timeOf(frame);
  camera_ = cameraAt(now_s, &near_plane_);
  const CameraPose pose =
      scene_->camera(run_.camera->name, run_.values, now_s, view_extent_.height);
  data.eye_world = glm::vec4(pose.eye_world, 1.0f);
  const SceneLights lights = scene_->lights(now_s);
  data.light_count = std::min(static_cast<uint32_t>(lights.lights.size()), kMaxLights);
  std::copy_n(lights.lights.begin(), data.light_count, data.lights);
  data.ambient = glm::vec4(lights.ambient, 0.0f);
  data.extent_px = glm::vec2(extent_.width, extent_.height);
  data.instance_count = buffers_.instanceCount();
  data.mip_bias = mip_bias;
  data.time_s = static_cast<float>(now_s);
  buffers_.frame() = data;
  shadow_map_.setFrame(buffers_.frame(), frame, lights,
                       glm::normalize(pose.target_world - pose.eye_world));
}

void Renderer::recordTransform(VkCommandBuffer commands, uint32_t frames_back) const {
  constexpr uint32_t kRow = 1024;
  const uint32_t count = buffers_.vertexCount();
  transform_program_.dispatch(
      commands, {kRow, (count + kRow - 1) / kRow}, buffers_.transformBindings(),
      TransformConstants{count, kRow, std::min(frames_back, kMaxFramesBack), 0});
  fullBarrier(commands);
}

void Renderer::recordVisibility(VkCommandBuffer commands, eq::vec2 jitter_px,
                                VkOffset2D shift_px) const {
  const bool shifted = shift_px.x != 0 || shift_px.y != 0;
  const RasterImages own{&visible_, &depth_, nullptr};
  const RasterImages images = shifted ? raster_->beside() : own;
  // Reversed depth: the far plane is 0.
  beginRendering(commands, {.color = images.visible,
                            .depth = images.depth,
                            .clear_depth = 0.0f,
                            .viewport = {shift_px, extent_}});
  drawScene(commands, visibility_program_, tested_program_, jitter_px);
  endRendering(commands);
  fullBarrier(commands);
  if (shifted) raster_->copyVisibility(commands, shift_px, own);
}

void Renderer::recordLightTiles(VkCommandBuffer commands, eq::vec2 jitter_px) const {
  light_tiles_.record(commands, buffers_.frameBuffer(), depth_, jitter_px, near_plane_);
}

void Renderer::drawScene(VkCommandBuffer commands, const GraphicsProgram& opaque,
                         const GraphicsProgram& tested, eq::vec2 jitter_px) const {
  const std::vector<Instance>& instances = scene_->geometry().instances;
  const auto draw = [&](const GraphicsProgram& program, const std::vector<uint32_t>& which,
                        const std::vector<Bound>& bound) {
    if (which.empty()) return;
    program.bind(commands);
    for (const uint32_t i : which) {
      program.push(commands, bound,
                   VisibilityConstants{{jitter_px.x, jitter_px.y}, i, instances[i].material});
      vkCmdDraw(commands, instances[i].index_count, 1, instances[i].first_index, 0);
    }
  };
  draw(opaque, buffers_.opaque(), buffers_.rasterBindings());
  draw(tested, buffers_.tested(), buffers_.testedBindings());
}

void Renderer::prepareDepthSamples() {
  if (depth_samples_.view() != VK_NULL_HANDLE) return;
  depth_samples_ = Image(device_, {.format = VK_FORMAT_D32_SFLOAT,
                                   .extent = extent_,
                                   .render_target = true,
                                   .samples = VK_SAMPLE_COUNT_4_BIT});
  GraphicsProgramInfo info{.name = "depth samples",
                           .vertex_spirv = kVisibilityVertexShader,
                           .fragment_spirv = {},
                           .bindings = SceneBuffers::rasterTypes(),
                           .push_bytes = sizeof(VisibilityConstants),
                           .samples = VK_SAMPLE_COUNT_4_BIT,
                           .specialization = {}};
  depth_samples_program_ = GraphicsProgram(device_, info);
  if (buffers_.tested().empty()) return;
  info.fragment_spirv = kHolesShader;
  info.bindings = SceneBuffers::testedTypes();
  info.specialization = buffers_.rasterSpecialization(true);
  depth_samples_tested_program_ = GraphicsProgram(device_, info);
}

void Renderer::recordDepthSamples(VkCommandBuffer commands, eq::vec2 jitter_px) const {
  beginRendering(commands, nullptr, depth_samples_, 0.0f);
  drawScene(commands, depth_samples_program_, depth_samples_tested_program_, jitter_px);
  endRendering(commands);
  fullBarrier(commands);
}

void Renderer::recordMotion(VkCommandBuffer commands, eq::vec2 jitter_px,
                            uint32_t frames_back) const {
  recordMotionInto(commands, motion_, jitter_px, frames_back);
}

void Renderer::prepareMotionBack() {
  for (Image& image : motion_back_) {
    if (image.view() != VK_NULL_HANDLE) continue;
    // With view depths: see RepriseFrame::motion_back.
    image = Image(device_, {.format = VK_FORMAT_R32G32B32A32_SFLOAT, .extent = extent_});
  }
}

void Renderer::recordMotionBack(VkCommandBuffer commands, eq::vec2 jitter_px,
                                uint32_t frames_back) const {
  recordTransform(commands, frames_back);
  recordMotionInto(commands, motionBack(frames_back), jitter_px, frames_back);
}

void Renderer::prepareGeometry() {
  if (geometry_.view() != VK_NULL_HANDLE) return;
  geometry_ = Image(device_, {.format = VK_FORMAT_R32G32B32A32_SFLOAT, .extent = extent_});
}

void Renderer::recordGeometry(VkCommandBuffer commands) const {
  const eq::vec2 no_jitter_px(0.0f);
  recordTransform(commands, 1);
  recordVisibility(commands, no_jitter_px);
  recordMotionInto(commands, geometry_, no_jitter_px, 1);
}

void Renderer::prepareServe() {
  if (extra_.view() != VK_NULL_HANDLE) return;
  extra_ = Image(device_, {.format = VK_FORMAT_R16G16B16A16_SFLOAT, .extent = extent_});
  serve_program_ =
      ComputeProgram(device_, {.name = "serve",
                               .spirv = kServeShader,
                               .bindings = followedBy(shadingTypes(), {kStored, kStorageBuffer}),
                               .push_bytes = sizeof(ServeConstants),
                               .specialization = shadeSpecialization(false)});
}

void Renderer::recordServe(VkCommandBuffer commands, VkBuffer requests,
                           uint32_t light_layers) const {
  const VkClearColorValue zero{};
  const VkImageSubresourceRange range{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
  vkCmdClearColorImage(commands, extra_.handle(), VK_IMAGE_LAYOUT_GENERAL, &zero, 1, &range);
  fullBarrier(commands);
  serve_program_.dispatchIndirect(commands, requests,
                                  followedBy(shadingBindings(), {stored(extra_), stored(requests)}),
                                  ServeConstants{light_layers});
  fullBarrier(commands);
}

void Renderer::recordMotionInto(VkCommandBuffer commands, const Image& image, eq::vec2 jitter_px,
                                uint32_t frames_back) const {
  motion_program_.dispatch(
      commands, extent_,
      followedBy(buffers_.surfaceBindings(visible_),
                 {texels(buffers_.previousWorld()), stored(image)}),
      MotionConstants{{jitter_px.x, jitter_px.y}, std::min(frames_back, kMaxFramesBack), 0});
  fullBarrier(commands);
}

void Renderer::recordShadeWith(VkCommandBuffer commands, const ComputeProgram& program,
                               const Image& color, const ShadeConstants& constants) const {
  program.dispatch(commands, extent_, followedBy(shadingBindings(), {stored(color), stored(sum_)}),
                   constants);
  fullBarrier(commands);
}

void Renderer::recordShade(VkCommandBuffer commands, const ShadeConstants& constants) const {
  recordShadeWith(commands, shade_program_, color_, constants);
}

void Renderer::prepareCoarse(uint32_t size) {
  CoarseShading& coarse = coarse_.at(size);
  if (coarse.ready()) return;
  coarse = CoarseShading(device_, size, extent_, shadingTypes(), shadeSpecialization(false));
}

void Renderer::recordCoarse(VkCommandBuffer commands, uint32_t size,
                            const CoarseConstants& constants) const {
  coarse_.at(size).record(commands, shadingBindings(), color_, constants);
}

void Renderer::recordRaster(VkCommandBuffer commands, const RasterFrame& frame) const {
  raster_->record(commands, {&visible_, &depth_, &color_}, frame,
                  [&](const Image& visible) { return shadingBindings(visible); });
}

void Renderer::prepareLate() {
  if (late_.view() != VK_NULL_HANDLE) return;
  late_ = Image(device_, {.format = VK_FORMAT_R16G16B16A16_SFLOAT, .extent = extent_});
  late_program_ = ComputeProgram(device_, {.name = "late light",
                                           .spirv = kLateShader,
                                           .bindings = followedBy(shadingTypes(), {kStored}),
                                           .push_bytes = sizeof(LateConstants),
                                           .specialization = shadeSpecialization(false)});
}

void Renderer::recordLate(VkCommandBuffer commands, eq::vec2 jitter_px, uint32_t positions) const {
  late_program_.dispatch(commands, extent_, followedBy(shadingBindings(), {stored(late_)}),
                         LateConstants{{jitter_px.x, jitter_px.y}, positions});
  fullBarrier(commands);
}

void Renderer::recordClearSum(VkCommandBuffer commands) const {
  const VkClearColorValue zero{};
  const VkImageSubresourceRange range{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
  vkCmdClearColorImage(commands, sum_.handle(), VK_IMAGE_LAYOUT_GENERAL, &zero, 1, &range);
  fullBarrier(commands);
}

void Renderer::recordAccumulate(VkCommandBuffer commands, std::span<const eq::vec2> jitters_px,
                                ShadeConstants constants, bool shading_only,
                                Timestamps* timestamps) const {
  bool seen = false;
  for (const eq::vec2 jitter_px : jitters_px) {
    if (!seen || !shading_only) {
      const eq::vec2 seen_px = shading_only ? eq::vec2(0.0f, 0.0f) : jitter_px;
      if (timestamps != nullptr) timestamps->start(commands, "visibility");
      recordVisibility(commands, seen_px);
      if (timestamps != nullptr) timestamps->stop(commands);
      if (hasLamps()) {
        if (timestamps != nullptr) timestamps->start(commands, "light tiles");
        recordLightTiles(commands, seen_px);
        if (timestamps != nullptr) timestamps->stop(commands);
      }
      seen = true;
    }
    if (timestamps != nullptr) timestamps->start(commands, "shade");
    constants.jitter_px = {jitter_px.x, jitter_px.y};
    recordShadeWith(commands, accumulate_program_, color_, constants);
    if (timestamps != nullptr) timestamps->stop(commands);
  }
}

void Renderer::recordMean(VkCommandBuffer commands, float scale) const {
  mean_program_.dispatch(commands, extent_, {sampled(sum_), stored(color_)},
                         FinishConstants{scale});
  fullBarrier(commands);
}

std::vector<uint8_t> Renderer::contentBytes() const {
  std::vector<uint8_t> bytes;
  buffers_.appendContent(bytes);
  append(bytes, kVisibilityVertexShader, std::size(kVisibilityVertexShader));
  append(bytes, kVisibilityFragmentShader, std::size(kVisibilityFragmentShader));
  append(bytes, kVisibilityTestedShader, std::size(kVisibilityTestedShader));
  append(bytes, kTransformShader, std::size(kTransformShader));
  append(bytes, kShadeShader, std::size(kShadeShader));
  shadow_map_.appendContent(bytes);
  light_tiles_.appendContent(bytes);
  return bytes;
}

}  // namespace reprise::lab
