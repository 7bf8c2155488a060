// SPDX-License-Identifier: MIT
//
// Plants that grow by a rule and sway as a whole: every vertex knows how the wind moves it.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <random>
#include <vector>

#include "lab/scene/mesh/mesh.h"

namespace reprise::lab {

// A mesh whose vertices follow the wind.
struct SwayingMesh {
  Mesh mesh;
  std::vector<GpuSway> sways;  // a vertex each
};

// Makes the mesh an instance of its own; returns its number.
uint32_t addInstance(Geometry& geometry, const SwayingMesh& plant, uint32_t material);

// Numbers that are the same everywhere: the standard's distributions are not.
class Dice {
 public:
  explicit Dice(uint32_t seed) : engine_(seed) {}
  float unit() { return static_cast<float>(engine_() >> 8) / 16777216.0f; }  // [0, 1)
  float between(float low, float high) { return low + (high - low) * unit(); }
  glm::vec3 direction();  // unit, any way

 private:
  std::mt19937 engine_;
};

struct TreeShape {
  float height_m = 5.0f;
  float trunk_radius_m = 0.11f;
  uint32_t limbs = 12;
  uint32_t twigs_a_limb = 7;
  uint32_t leaves_a_twig = 28;
  float leaf_m = 0.105f;  // length of a leaf
};

// Wood and leaves of a tree that stands at `foot_world`. Leaves show one of 2 x 2 pictures.
struct Tree {
  SwayingMesh wood;
  SwayingMesh leaves;
};
Tree growTree(glm::vec3 foot_world, const TreeShape& shape, Dice& dice);

// A tuft of grass: a picture of blades on two crossed cards that turn about their foot.
void appendTuft(SwayingMesh& grass, glm::vec3 foot_world, float height_m, float width_m,
                glm::vec3 wind_direction, Dice& dice);
// One blade as geometry, far thinner than a pixel from some metres on.
void appendBlade(SwayingMesh& grass, glm::vec3 foot_world, float height_m, float width_m,
                 glm::vec3 wind_direction, Dice& dice);

}  // namespace reprise::lab
