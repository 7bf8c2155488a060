// SPDX-License-Identifier: MIT
//
// Materials and images of a glTF file as the lab shades them (shading/textured.glsl).
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

#include "lab/scene/gltf/gltf_file.h"
#include "lab/scene/scene.h"

namespace reprise::lab {

// Where a material's textures lie: a set of coordinates, and KHR_texture_transform of it.
struct UvMapping {
  int set = 0;
  glm::vec2 offset{0.0f};
  glm::vec2 scale{1.0f};
  float rotation = 0.0f;  // radians

  glm::vec2 apply(glm::vec2 uv) const;
  bool operator==(const UvMapping&) const = default;
};

struct GltfMaterial {
  uint32_t number = 0;  // in Geometry::materials
  UvMapping mapping;
  bool invisible = false;  // all of it is a hole
  bool repeats = true;     // its textures mean to repeat beyond [0, 1]
};

class GltfMaterials {
 public:
  // Fills the materials and images of `geometry` when they are first asked for.
  GltfMaterials(GltfFile& file, Geometry& geometry) : file_(file), geometry_(geometry) {}

  // -1: the default material.
  const GltfMaterial& material(int index);

 private:
  struct Pixels {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<uint8_t> rgba;  // empty: the image cannot be had
  };
  GltfMaterial make(const tinygltf::Material& from, const std::string& name);
  // Number of the scene's image for a texture, 0 for none. `role` and `alpha_cutoff` as SceneImage.
  uint32_t image(int texture, ImageRole role, float alpha_cutoff);
  // Occlusion, roughness, metalness of two textures in one image.
  uint32_t surfaceImage(int surface_texture, int occlusion_texture, float strength);
  // Image number of a texture; none where it has no format that is known here.
  std::optional<size_t> source(int texture);
  const Pixels& pixels(size_t image);

  GltfFile& file_;
  Geometry& geometry_;
  std::map<int, GltfMaterial> made_;
  std::map<std::tuple<size_t, ImageRole, float>, uint32_t> images_;
  std::map<std::tuple<int, int, float>, uint32_t> surface_images_;
  std::map<size_t, Pixels> pixels_;
};

}  // namespace reprise::lab
