// SPDX-License-Identifier: MIT
//
// A mesh before it belongs to a scene. Triangles are counter-clockwise seen from outside: the
// normal of (a, b, c) is along cross(b - a, c - a).
#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "lab/scene/scene.h"

namespace reprise::lab {

struct Mesh {
  std::vector<GpuVertex> vertices;
  std::vector<uint32_t> indices;

  size_t triangleCount() const { return indices.size() / 3; }
  glm::vec3 position(uint32_t index) const { return {vertices[index].position_u}; }
};

struct GridPoint {
  glm::vec3 position{0.0f};
  glm::vec2 uv{0.0f};
};

// (columns + 1) x (rows + 1) points, two triangles a cell, facing d point/d column x d point/d row.
// Triangles with two corners in one place (poles) are left out. No normals yet: see makeSmooth.
Mesh gridMesh(uint32_t columns, uint32_t rows,
              const std::function<GridPoint(uint32_t column, uint32_t row)>& point);

void append(Mesh& mesh, const Mesh& more);

// `matrix` turns, moves, scales uniformly and may mirror.
Mesh transformed(Mesh mesh, const glm::mat4& matrix);

// Vertices nearer to each other than `tolerance` move to exactly one place. They stay several where
// their uv differ.
void weld(Mesh& mesh, float tolerance);

// Unit normals: mean of the faces that meet at a place, weighted by angle, over those that bend by
// less than `crease` (radians) from a corner's own face. Vertices on creases are split.
void makeSmooth(Mesh& mesh, float crease);
constexpr float kNoCrease = 4.0f;  // above pi: everything is smooth

// Makes the mesh an instance of its own; returns its number.
uint32_t addInstance(Geometry& geometry, const Mesh& mesh, uint32_t material);

}  // namespace reprise::lab
