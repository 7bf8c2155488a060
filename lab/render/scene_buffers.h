// SPDX-License-Identifier: MIT
//
// A scene on the GPU: geometry, materials and textures, uploaded once; transforms and the frame's
// block, written for every frame. What each binding holds is declared in scene_buffers.glsl and
// shade_triangle.glsl.
#pragma once

#include <cstdint>
#include <vector>

#include "lab/render/frame_data.h"
#include "lab/render/textures.h"
#include "lab/scene/scene.h"
#include "lab/vk/bindings.h"

namespace reprise::lab {

struct Ball {
  glm::vec3 center_world{0.0f};
  float radius_m = 0.0f;
};

class SceneBuffers {
 public:
  SceneBuffers(Device& device, const Scene& scene, TextureFilter filter);

  // The block of the current frame and the transforms of `age` frames back, one an instance.
  GpuFrame& frame() { return *static_cast<GpuFrame*>(frame_.mapped()); }
  glm::mat4* transforms(uint32_t age) {
    return static_cast<glm::mat4*>(transforms_.mapped()) + size_t{age} * instance_count_;
  }
  // Of the current frame.
  std::span<const glm::mat4> transforms() const {
    return {static_cast<const glm::mat4*>(transforms_.mapped()), instance_count_};
  }
  // Whether the wind moves anything.
  bool sways() const { return has_sways_; }
  uint32_t vertexCount() const { return vertex_count_; }
  uint32_t instanceCount() const { return instance_count_; }

  // Instances without and with holes, to be drawn in this order.
  const std::vector<uint32_t>& opaque() const { return opaque_; }
  const std::vector<uint32_t>& tested() const { return tested_; }
  // Around everything in the current frame that casts a shadow, wherever the wind takes it.
  Ball casterBounds() const;

  // Of the transform pass.
  static std::vector<VkDescriptorType> transformTypes();
  std::vector<Bound> transformBindings() const;
  std::vector<uint32_t> transformSpecialization() const { return {has_sways_ ? 1u : 0u}; }
  // Of passes that draw triangles; of those that test them for holes.
  static std::vector<VkDescriptorType> rasterTypes();
  std::vector<Bound> rasterBindings() const;
  static std::vector<VkDescriptorType> testedTypes();
  std::vector<Bound> testedBindings() const;
  // For the camera, holes are looked up as colours are, with the frame's mip bias. For the sun one
  // lookup does, whose texels no one sees: up to sixteen were most of its pass.
  std::vector<uint32_t> rasterSpecialization(bool camera) const {
    return {
        0, 0, 0, textures_.classCount(), 0, camera ? textures_.anisotropy() : 1, camera ? 1u : 0u};
  }
  // 0 to 3, of every compute pass that looks at surfaces.
  static std::vector<VkDescriptorType> surfaceTypes();
  std::vector<Bound> surfaceBindings(const Image& visible) const;
  // 0 to kLampsBinding - 1, of every pass that shades.
  static std::vector<VkDescriptorType> shadingTypes();
  std::vector<Bound> shadingBindings(const Image& visible, const Image& shadow_map) const;
  // World positions as the transform pass left them of the frames before.
  const Buffer& previousWorld() const { return previous_world_; }
  const Buffer& world() const { return world_; }
  const Buffer& frameBuffer() const { return frame_; }

  // kKinds, and kOnlyKind of shade_triangle.glsl.
  uint32_t materialKinds() const { return material_kinds_; }
  uint32_t onlyKind() const { return only_kind_; }
  const Textures& textures() const { return textures_; }

  // Surface evaluations since the last call; after the recorded work has finished.
  uint64_t takeEvaluations();

  // Bytes that determine what the current frame looks like, for content hashes.
  void appendContent(std::vector<uint8_t>& bytes) const;

 private:
  const Scene& scene_;
  uint32_t vertex_count_;
  uint32_t instance_count_;
  uint32_t material_kinds_ = 0;
  uint32_t only_kind_ = ~0u;
  std::vector<uint32_t> opaque_;
  std::vector<uint32_t> tested_;
  std::vector<Ball> instance_bounds_;  // in each instance's space
  float wind_reach_m_ = 0.0f;          // farthest that a wind of 1 moves a vertex
  bool has_sways_;
  Textures textures_;
  Buffer frame_;
  Buffer vertices_;
  Buffer indices_;
  Buffer triangles_;
  Buffer vertex_instances_;
  Buffer transforms_;
  Buffer world_;
  Buffer previous_world_;
  Buffer materials_;
  Buffer sways_;
  Buffer counter_;
};

}  // namespace reprise::lab
