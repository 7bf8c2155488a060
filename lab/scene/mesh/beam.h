// SPDX-License-Identifier: MIT
//
// Struts and cables: what is thin for its length.
#pragma once

#include <span>

#include "lab/scene/mesh/mesh.h"

namespace reprise::lab {

// A square bar from `a` to `b`, open at its ends, which lie inside what it joins. uv: metres.
void appendBeam(Mesh& mesh, glm::vec3 a, glm::vec3 b, float thickness_m);

// A round tube through points, smooth. uv: turns, metres along.
void appendTube(Mesh& mesh, std::span<const glm::vec3> points, float radius_m, uint32_t sides);

// A cable that hangs between two points, `sag_m` at its middle, as a parabola.
void appendCable(Mesh& mesh, glm::vec3 a, glm::vec3 b, float sag_m, float radius_m);

// A lattice girder: two chords `depth_m` apart along `up`, posts, and diagonals that alternate.
struct Girder {
  glm::vec3 from{0.0f};
  glm::vec3 to{1.0f, 0.0f, 0.0f};
  glm::vec3 up{0.0f, 1.0f, 0.0f};
  float depth_m = 0.8f;
  uint32_t bays = 12;
  float chord_m = 0.10f;  // thickness
  float brace_m = 0.05f;
};
void appendGirder(Mesh& mesh, const Girder& girder);

}  // namespace reprise::lab
