// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "lab/scene/mesh/mesh.h"

namespace reprise::lab {

// Control points [i][j] of a bicubic Bezier patch; i along u, j along v.
using BezierPatch = std::array<std::array<glm::vec3, 4>, 4>;

glm::vec3 pointOf(const BezierPatch& patch, float u, float v);

// cells x cells squares, facing d/du x d/dv; uv are the patch's own. No normals yet.
Mesh bezierMesh(const BezierPatch& patch, uint32_t cells);

}  // namespace reprise::lab
