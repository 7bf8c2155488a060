// SPDX-License-Identifier: MIT
#include "lab/scene/mesh/bezier_patch.h"

namespace reprise::lab {
namespace {

// Bernstein polynomials of degree 3.
std::array<float, 4> bernstein(float t) {
  const float s = 1.0f - t;
  return {s * s * s, 3.0f * s * s * t, 3.0f * s * t * t, t * t * t};
}

}  // namespace

glm::vec3 pointOf(const BezierPatch& patch, float u, float v) {
  const std::array<float, 4> weight_u = bernstein(u);
  const std::array<float, 4> weight_v = bernstein(v);
  glm::vec3 point(0.0f);
  for (size_t i = 0; i < 4; ++i) {
    for (size_t j = 0; j < 4; ++j) point += weight_u[i] * weight_v[j] * patch[i][j];
  }
  return point;
}

Mesh bezierMesh(const BezierPatch& patch, uint32_t cells) {
  return gridMesh(cells, cells, [&](uint32_t column, uint32_t row) {
    const glm::vec2 at =
        glm::vec2(static_cast<float>(column), static_cast<float>(row)) / static_cast<float>(cells);
    return GridPoint{pointOf(patch, at.x, at.y), at};
  });
}

}  // namespace reprise::lab
