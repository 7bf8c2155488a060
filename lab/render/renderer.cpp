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
constexpr uint32_t kVisibilityFragmentShader[] = {
#include "visibility.frag.inc"
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
constexpr uint32_t kServeShader[] = {
#include "serve.comp.inc"
};
constexpr uint32_t kFinishShader[] = {
#include "finish.comp.inc"
};

constexpr VkDescriptorType kStorageBuffer = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
constexpr VkDescriptorType kUniform = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
constexpr VkDescriptorType kTexels = VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER;
constexpr VkDescriptorType kSampled = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
constexpr VkDescriptorType kStored = VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;

template <typename T>
std::span<const T> spanOf(const std::vector<T>& values) {
  return {values.data(), values.size()};
}

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

Renderer::Renderer(Device& device, const SceneRun& run, VkExtent2D extent, double frame_rate)
    : device_(device),
      scene_(run.scene->create()),
      run_(run),
      extent_(extent),
      frame_rate_(frame_rate),
      visible_(device, {.format = VK_FORMAT_R32G32_UINT, .extent = extent, .render_target = true}),
      depth_(device, {.format = VK_FORMAT_D32_SFLOAT, .extent = extent, .render_target = true}),
      motion_(device, {.format = VK_FORMAT_R32G32_SFLOAT, .extent = extent}),
      color_(device, {.format = VK_FORMAT_R16G16B16A16_SFLOAT, .extent = extent}),
      sum_(device, {.format = VK_FORMAT_R32G32B32A32_SFLOAT, .extent = extent}) {
  createBuffers(device);
  createPrograms(device);
}

void Renderer::createBuffers(Device& device) {
  const Geometry& geometry = scene_->geometry();
  vertices_ = deviceBuffer(device, spanOf(geometry.vertices));
  indices_ = deviceBuffer(device, spanOf(geometry.indices));
  materials_ = deviceBuffer(device, spanOf(geometry.materials));
  std::vector<GpuTriangle> triangles(geometry.indices.size() / 3);
  for (const Instance& instance : geometry.instances) {
    for (uint32_t k = 0; k < instance.index_count; k += 3) {
      const uint32_t* corner = &geometry.indices[instance.first_index + k];
      triangles[(instance.first_index + k) / 3] = {corner[0], corner[1], corner[2],
                                                   instance.material};
    }
  }
  triangles_ = deviceBuffer(device, spanOf(triangles));
  triangles_.makeTexelView(VK_FORMAT_R32G32B32A32_UINT);
  frame_ = Buffer(device, sizeof(GpuFrame), BufferKind::kHost);
  transforms_ = Buffer(device, (kMaxFramesBack + 1) * geometry.instances.size() * sizeof(glm::mat4),
                       BufferKind::kHost);
  std::vector<uint32_t> vertex_instances(geometry.vertices.size(), 0);
  for (uint32_t i = 0; i < geometry.instances.size(); ++i) {
    const Instance& instance = geometry.instances[i];
    for (uint32_t k = 0; k < instance.index_count; ++k) {
      vertex_instances[geometry.indices[instance.first_index + k]] = i;
    }
  }
  vertex_instances_ = deviceBuffer(device, spanOf(vertex_instances));
  world_ = Buffer(device, vertices_.bytes(), BufferKind::kDevice);
  world_.makeTexelView(VK_FORMAT_R32G32B32A32_SFLOAT);
  previous_world_ =
      Buffer(device, geometry.vertices.size() * sizeof(glm::vec4), BufferKind::kDevice);
  previous_world_.makeTexelView(VK_FORMAT_R32G32B32A32_SFLOAT);
  counter_ = Buffer(device, sizeof(uint32_t), BufferKind::kHost);
  std::memset(counter_.mapped(), 0, counter_.bytes());
}

std::vector<uint32_t> Renderer::shadeSpecialization(bool accumulate) const {
  uint32_t kinds = 0;
  const std::vector<GpuMaterial>& materials = scene_->geometry().materials;
  for (const GpuMaterial& material : materials) kinds |= 1u << material.kind;
  const auto only_kind = materials.size() == 1 ? materials[0].kind : ~0u;
  return {kinds, accumulate ? 1u : 0u, only_kind};
}

ComputeProgram Renderer::createShadeProgram(Device& device, bool accumulate) const {
  return ComputeProgram(device, {.name = "shade",
                                 .spirv = kShadeShader,
                                 .bindings = {kUniform, kTexels, kTexels, kSampled, kStorageBuffer,
                                              kStored, kStored, kStorageBuffer},
                                 .push_bytes = sizeof(ShadeConstants),
                                 .specialization = shadeSpecialization(accumulate)});
}

void Renderer::createPrograms(Device& device) {
  visibility_program_ =
      GraphicsProgram(device, {.name = "visibility",
                               .vertex_spirv = kVisibilityVertexShader,
                               .fragment_spirv = kVisibilityFragmentShader,
                               .bindings = {kUniform, kStorageBuffer, kStorageBuffer},
                               .push_bytes = sizeof(VisibilityConstants),
                               .color_format = VK_FORMAT_R32G32_UINT});
  transform_program_ =
      ComputeProgram(device, {.name = "transform",
                              .spirv = kTransformShader,
                              .bindings = {kUniform, kStorageBuffer, kStorageBuffer, kStorageBuffer,
                                           kStorageBuffer, kStorageBuffer},
                              .push_bytes = sizeof(TransformConstants),
                              .specialization = {}});
  motion_program_ =
      ComputeProgram(device, {.name = "motion",
                              .spirv = kMotionShader,
                              .bindings = {kUniform, kTexels, kTexels, kSampled, kTexels, kStored},
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
  const CameraPose pose = scene_->camera(run_.camera->name, run_.values, time_s, extent_.height);
  const float aspect = static_cast<float>(extent_.width) / static_cast<float>(extent_.height);
  const glm::mat4 view = glm::lookAt(pose.eye_world, pose.target_world, pose.up_world);
  const glm::mat4 proj = projection(pose.vertical_fov, aspect, pose.near_plane);
  RepriseCamera camera{};
  std::memcpy(camera.view, &view, sizeof(view));
  std::memcpy(camera.projection, &proj, sizeof(proj));
  if (near_plane != nullptr) *near_plane = pose.near_plane;
  return camera;
}

void Renderer::setFrame(uint32_t index, float mip_bias) {
  GpuFrame data{};
  const auto instance_count = static_cast<uint32_t>(scene_->geometry().instances.size());
  auto* transforms = static_cast<glm::mat4*>(transforms_.mapped());
  for (uint32_t age = 0; age <= kMaxFramesBack; ++age) {
    const double time_s = static_cast<double>(index - std::min(age, index)) / frame_rate_;
    const RepriseCamera camera = cameraAt(time_s, nullptr);
    glm::mat4 view;
    glm::mat4 proj;
    std::memcpy(&view, camera.view, sizeof(view));
    std::memcpy(&proj, camera.projection, sizeof(proj));
    data.view_projection[age] = proj * view;
    for (uint32_t i = 0; i < instance_count; ++i) {
      transforms[age * instance_count + i] = scene_->transform(i, time_s);
    }
  }
  const double now_s = static_cast<double>(index) / frame_rate_;
  camera_ = cameraAt(now_s, &near_plane_);
  const CameraPose pose = scene_->camera(run_.camera->name, run_.values, now_s, extent_.height);
  data.eye_world = glm::vec4(pose.eye_world, 1.0f);
  data.light = scene_->light(now_s);
  data.extent_px = glm::vec2(extent_.width, extent_.height);
  data.instance_count = instance_count;
  data.mip_bias = mip_bias;
  std::memcpy(frame_.mapped(), &data, sizeof(data));
}

void Renderer::recordTransform(VkCommandBuffer commands, uint32_t frames_back) const {
  constexpr uint32_t kRow = 1024;
  const auto count = static_cast<uint32_t>(scene_->geometry().vertices.size());
  transform_program_.dispatch(
      commands, {kRow, (count + kRow - 1) / kRow},
      {uniform(frame_), stored(vertices_), stored(vertex_instances_), stored(transforms_),
       stored(world_), stored(previous_world_)},
      TransformConstants{count, kRow, std::min(frames_back, kMaxFramesBack), 0});
  fullBarrier(commands);
}

void Renderer::recordVisibility(VkCommandBuffer commands, eq::vec2 jitter_px) const {
  // Reversed depth: the far plane is 0.
  beginRendering(commands, &visible_, depth_, 0.0f);
  visibility_program_.bind(commands);
  const std::vector<Instance>& instances = scene_->geometry().instances;
  for (uint32_t i = 0; i < instances.size(); ++i) {
    visibility_program_.push(commands, {uniform(frame_), stored(world_), stored(indices_)},
                             VisibilityConstants{{jitter_px.x, jitter_px.y}, i, 0});
    vkCmdDraw(commands, instances[i].index_count, 1, instances[i].first_index, 0);
  }
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
    image = Image(device_, {.format = VK_FORMAT_R32G32_SFLOAT, .extent = extent_});
  }
}

void Renderer::recordMotionBack(VkCommandBuffer commands, eq::vec2 jitter_px,
                                uint32_t frames_back) const {
  recordTransform(commands, frames_back);
  recordMotionInto(commands, motionBack(frames_back), jitter_px, frames_back);
}

void Renderer::prepareServe() {
  if (extra_.view() != VK_NULL_HANDLE) return;
  extra_ = Image(device_, {.format = VK_FORMAT_R16G16B16A16_SFLOAT, .extent = extent_});
  serve_program_ =
      ComputeProgram(device_, {.name = "serve",
                               .spirv = kServeShader,
                               .bindings = {kUniform, kTexels, kTexels, kSampled, kStorageBuffer,
                                            kStored, kStorageBuffer, kStorageBuffer},
                               .push_bytes = 0,
                               .specialization = shadeSpecialization(false)});
}

void Renderer::recordServe(VkCommandBuffer commands, VkBuffer requests) const {
  const VkClearColorValue zero{};
  const VkImageSubresourceRange range{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
  vkCmdClearColorImage(commands, extra_.handle(), VK_IMAGE_LAYOUT_GENERAL, &zero, 1, &range);
  fullBarrier(commands);
  serve_program_.dispatchIndirect(
      commands, requests,
      {uniform(frame_), texels(world_), texels(triangles_), sampled(visible_), stored(materials_),
       stored(extra_), stored(requests), stored(counter_)});
  fullBarrier(commands);
}

void Renderer::recordMotionInto(VkCommandBuffer commands, const Image& image, eq::vec2 jitter_px,
                                uint32_t frames_back) const {
  motion_program_.dispatch(
      commands, extent_,
      {uniform(frame_), texels(world_), texels(triangles_), sampled(visible_),
       texels(previous_world_), stored(image)},
      MotionConstants{{jitter_px.x, jitter_px.y}, std::min(frames_back, kMaxFramesBack), 0});
  fullBarrier(commands);
}

void Renderer::recordShadeWith(VkCommandBuffer commands, const ComputeProgram& program,
                               const ShadeConstants& constants) const {
  program.dispatch(commands, extent_,
                   {uniform(frame_), texels(world_), texels(triangles_), sampled(visible_),
                    stored(materials_), stored(color_), stored(sum_), stored(counter_)},
                   constants);
  fullBarrier(commands);
}

void Renderer::recordShade(VkCommandBuffer commands, const ShadeConstants& constants) const {
  recordShadeWith(commands, shade_program_, constants);
}

void Renderer::recordClearSum(VkCommandBuffer commands) const {
  const VkClearColorValue zero{};
  const VkImageSubresourceRange range{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
  vkCmdClearColorImage(commands, sum_.handle(), VK_IMAGE_LAYOUT_GENERAL, &zero, 1, &range);
  fullBarrier(commands);
}

void Renderer::recordAccumulate(VkCommandBuffer commands, std::span<const eq::vec2> jitters_px,
                                const RenderSwitches& switches, Timestamps* timestamps) const {
  for (const eq::vec2 jitter_px : jitters_px) {
    if (timestamps != nullptr) timestamps->start(commands, "visibility");
    recordVisibility(commands, jitter_px);
    if (timestamps != nullptr) {
      timestamps->stop(commands);
      timestamps->start(commands, "shade");
    }
    const ShadeConstants constants{.jitter_px = {jitter_px.x, jitter_px.y},
                                   .unjitter = switches.unjitter_textures ? 1u : 0u};
    recordShadeWith(commands, accumulate_program_, constants);
    if (timestamps != nullptr) timestamps->stop(commands);
  }
}

void Renderer::recordMean(VkCommandBuffer commands, float scale) const {
  mean_program_.dispatch(commands, extent_, {sampled(sum_), stored(color_)},
                         FinishConstants{scale});
  fullBarrier(commands);
}

uint64_t Renderer::takeEvaluations() {
  auto* counter = static_cast<uint32_t*>(counter_.mapped());
  const uint64_t evaluations = *counter;
  *counter = 0;
  return evaluations;
}

std::vector<uint8_t> Renderer::contentBytes() const {
  std::vector<uint8_t> bytes;
  const Geometry& geometry = scene_->geometry();
  append(bytes, geometry.vertices.data(), geometry.vertices.size());
  append(bytes, geometry.indices.data(), geometry.indices.size());
  append(bytes, geometry.instances.data(), geometry.instances.size());
  append(bytes, geometry.materials.data(), geometry.materials.size());
  // Of the current frame only: earlier cameras do not change how it looks.
  const auto* frame = static_cast<const GpuFrame*>(frame_.mapped());
  append(bytes, &frame->view_projection[0], 1);
  append(bytes, &frame->eye_world, 1);
  append(bytes, &frame->light, 1);
  append(bytes, &frame->extent_px, 1);
  append(bytes, &frame->mip_bias, 1);
  append(bytes, static_cast<const glm::mat4*>(transforms_.mapped()), geometry.instances.size());
  append(bytes, kVisibilityVertexShader, std::size(kVisibilityVertexShader));
  append(bytes, kVisibilityFragmentShader, std::size(kVisibilityFragmentShader));
  append(bytes, kShadeShader, std::size(kShadeShader));
  return bytes;
}

}  // namespace reprise::lab
