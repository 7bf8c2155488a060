// SPDX-License-Identifier: MIT
#include "lab/render/scene_buffers.h"

#include <algorithm>
#include <cstring>

namespace reprise::lab {
namespace {

constexpr VkDescriptorType kStorageBuffer = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
constexpr VkDescriptorType kUniform = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
constexpr VkDescriptorType kTexels = VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER;
constexpr VkDescriptorType kSampled = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;

template <typename T>
std::span<const T> spanOf(const std::vector<T>& values) {
  return {values.data(), values.size()};
}

template <typename T>
void append(std::vector<uint8_t>& bytes, const T* data, size_t count) {
  const auto* begin = reinterpret_cast<const uint8_t*>(data);
  bytes.insert(bytes.end(), begin, begin + count * sizeof(T));
}

std::vector<GpuTriangle> trianglesOf(const Geometry& geometry) {
  std::vector<GpuTriangle> triangles(geometry.indices.size() / 3);
  for (const Instance& instance : geometry.instances) {
    for (uint32_t k = 0; k < instance.index_count; k += 3) {
      const uint32_t* corner = &geometry.indices[instance.first_index + k];
      triangles[(instance.first_index + k) / 3] = {corner[0], corner[1], corner[2],
                                                   instance.material};
    }
  }
  return triangles;
}

std::vector<uint32_t> instanceOfVertices(const Geometry& geometry) {
  std::vector<uint32_t> vertex_instances(geometry.vertices.size(), 0);
  for (uint32_t i = 0; i < geometry.instances.size(); ++i) {
    const Instance& instance = geometry.instances[i];
    for (uint32_t k = 0; k < instance.index_count; ++k) {
      vertex_instances[geometry.indices[instance.first_index + k]] = i;
    }
  }
  return vertex_instances;
}

Ball boundsOf(const Geometry& geometry, const Instance& instance) {
  glm::vec3 low(1.0e30f);
  glm::vec3 high(-1.0e30f);
  for (uint32_t k = 0; k < instance.index_count; ++k) {
    const glm::vec3 p(geometry.vertices[geometry.indices[instance.first_index + k]].position_u);
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  if (instance.index_count == 0) return {};
  return {0.5f * (low + high), 0.5f * glm::length(high - low)};
}

float windReach_m(const Geometry& geometry) {
  float reach = 0.0f;
  for (size_t i = 0; i < geometry.sways.size(); ++i) {
    const GpuSway& sway = geometry.sways[i];
    // A turn moves a vertex by no more than the diameter of its circle.
    const float turn = sway.pivot_angle.w != 0.0f
                           ? 2.0f * glm::distance(glm::vec3(geometry.vertices[i].position_u),
                                                  glm::vec3(sway.pivot_angle))
                           : 0.0f;
    reach = std::max(reach, turn + std::abs(sway.push.x) + std::abs(sway.push.y));
  }
  return reach;
}

// Materials name images as the scene numbers them; shaders want class and layer.
std::vector<GpuMaterial> materialsOf(const Geometry& geometry, const Textures& textures) {
  std::vector<GpuMaterial> materials = geometry.materials;
  for (GpuMaterial& material : materials) {
    for (uint32_t* texture : {&material.color_texture, &material.normal_texture,
                              &material.surface_texture, &material.emission_texture}) {
      *texture = textures.reference(*texture);
    }
  }
  return materials;
}

}  // namespace

SceneBuffers::SceneBuffers(Device& device, const Scene& scene, TextureFilter filter)
    : scene_(scene),
      vertex_count_(static_cast<uint32_t>(scene.geometry().vertices.size())),
      instance_count_(static_cast<uint32_t>(scene.geometry().instances.size())),
      wind_reach_m_(windReach_m(scene.geometry())),
      has_sways_(!scene.geometry().sways.empty()),
      textures_(device, scene.geometry().images, filter) {
  const Geometry& geometry = scene.geometry();
  for (uint32_t i = 0; i < instance_count_; ++i) {
    const Instance& instance = geometry.instances[i];
    const bool holes = geometry.materials[instance.material].alpha_cutoff > 0.0f;
    (holes ? tested_ : opaque_).push_back(i);
    instance_bounds_.push_back(boundsOf(geometry, instance));
  }
  for (const GpuMaterial& material : geometry.materials) material_kinds_ |= 1u << material.kind;
  if (geometry.materials.size() == 1) only_kind_ = geometry.materials[0].kind;

  frame_ = Buffer(device, sizeof(GpuFrame), BufferKind::kHost);
  std::memset(frame_.mapped(), 0, frame_.bytes());
  vertices_ = deviceBuffer(device, spanOf(geometry.vertices));
  vertices_.makeTexelView(VK_FORMAT_R32G32B32A32_SFLOAT);
  indices_ = deviceBuffer(device, spanOf(geometry.indices));
  triangles_ = deviceBuffer(device, spanOf(trianglesOf(geometry)));
  triangles_.makeTexelView(VK_FORMAT_R32G32B32A32_UINT);
  vertex_instances_ = deviceBuffer(device, spanOf(instanceOfVertices(geometry)));
  materials_ = deviceBuffer(device, spanOf(materialsOf(geometry, textures_)));
  std::vector<GpuSway> sways = geometry.sways;
  if (has_sways_) sways.resize(vertex_count_, GpuSway{});
  sways_ = deviceBuffer(device, spanOf(sways));
  transforms_ = Buffer(device, uint64_t{kMaxFramesBack + 1} * instance_count_ * sizeof(glm::mat4),
                       BufferKind::kHost);
  world_ = Buffer(device, vertices_.bytes(), BufferKind::kDevice);
  world_.makeTexelView(VK_FORMAT_R32G32B32A32_SFLOAT);
  previous_world_ = Buffer(device, vertex_count_ * sizeof(glm::vec4), BufferKind::kDevice);
  previous_world_.makeTexelView(VK_FORMAT_R32G32B32A32_SFLOAT);
  counter_ = Buffer(device, sizeof(uint32_t), BufferKind::kHost);
  std::memset(counter_.mapped(), 0, counter_.bytes());
}

Ball SceneBuffers::casterBounds() const {
  const auto* transforms = static_cast<const glm::mat4*>(transforms_.mapped());
  const auto* frame = static_cast<const GpuFrame*>(frame_.mapped());
  glm::vec3 low(1.0e30f);
  glm::vec3 high(-1.0e30f);
  bool any = false;
  for (uint32_t i = 0; i < instance_count_; ++i) {
    if (scene_.geometry().instances[i].casts_shadow == 0) continue;
    any = true;
    const Ball& ball = instance_bounds_[i];
    const float scale = std::max({glm::length(glm::vec3(transforms[i][0])),
                                  glm::length(glm::vec3(transforms[i][1])),
                                  glm::length(glm::vec3(transforms[i][2]))});
    const glm::vec3 center(transforms[i] * glm::vec4(ball.center_world, 1.0f));
    low = glm::min(low, center - ball.radius_m * scale);
    high = glm::max(high, center + ball.radius_m * scale);
  }
  if (!any) return {};
  const float reach = wind_reach_m_ * glm::length(glm::vec3(frame->wind[0]));
  return {0.5f * (low + high), 0.5f * glm::length(high - low) + reach};
}

std::vector<VkDescriptorType> SceneBuffers::transformTypes() {
  std::vector<VkDescriptorType> types(7, kStorageBuffer);
  types[0] = kUniform;
  return types;
}

std::vector<Bound> SceneBuffers::transformBindings() const {
  return {uniform(frame_),     stored(vertices_), stored(vertex_instances_),
          stored(transforms_), stored(world_),    stored(previous_world_),
          stored(sways_)};
}

std::vector<VkDescriptorType> SceneBuffers::rasterTypes() {
  return {kUniform, kStorageBuffer, kStorageBuffer};
}

std::vector<Bound> SceneBuffers::rasterBindings() const {
  return {uniform(frame_), stored(world_), stored(indices_)};
}

std::vector<VkDescriptorType> SceneBuffers::testedTypes() {
  return followedBy(followedBy(rasterTypes(), {kStorageBuffer}), Textures::types());
}

std::vector<Bound> SceneBuffers::testedBindings() const {
  return followedBy(followedBy(rasterBindings(), {stored(materials_)}), textures_.bindings());
}

std::vector<VkDescriptorType> SceneBuffers::surfaceTypes() {
  return {kUniform, kTexels, kTexels, kSampled};
}

std::vector<Bound> SceneBuffers::surfaceBindings(const Image& visible) const {
  return {uniform(frame_), texels(world_), texels(triangles_), sampled(visible)};
}

std::vector<VkDescriptorType> SceneBuffers::shadingTypes() {
  return followedBy(followedBy(surfaceTypes(),
                               {kStorageBuffer, kStorageBuffer, kTexels, kStorageBuffer, kSampled}),
                    Textures::types());
}

std::vector<Bound> SceneBuffers::shadingBindings(const Image& visible,
                                                 const Image& shadow_map) const {
  return followedBy(
      followedBy(surfaceBindings(visible), {stored(materials_), stored(counter_), texels(vertices_),
                                            stored(transforms_), sampled(shadow_map)}),
      textures_.bindings());
}

uint64_t SceneBuffers::takeEvaluations() {
  auto* counter = static_cast<uint32_t*>(counter_.mapped());
  const uint64_t evaluations = *counter;
  *counter = 0;
  return evaluations;
}

void SceneBuffers::appendContent(std::vector<uint8_t>& bytes) const {
  const Geometry& geometry = scene_.geometry();
  append(bytes, geometry.vertices.data(), geometry.vertices.size());
  append(bytes, geometry.indices.data(), geometry.indices.size());
  append(bytes, geometry.instances.data(), geometry.instances.size());
  append(bytes, geometry.materials.data(), geometry.materials.size());
  append(bytes, geometry.sways.data(), geometry.sways.size());
  textures_.appendContent(bytes);
  // Earlier cameras and transforms do not change how the current frame looks.
  GpuFrame frame = *static_cast<const GpuFrame*>(frame_.mapped());
  for (uint32_t age = 1; age <= kMaxFramesBack; ++age) {
    frame.view_projection[age] = mat4(0.0f);
    frame.wind[age] = vec4(0.0f);
  }
  append(bytes, &frame, 1);
  append(bytes, static_cast<const glm::mat4*>(transforms_.mapped()), instance_count_);
}

}  // namespace reprise::lab
