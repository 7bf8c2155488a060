// SPDX-License-Identifier: MIT
//
// What lies beyond a scene of plants: rows of trees, wooded hills, the sky. None of it comes near
// the camera or casts a shadow on what does.
#pragma once

#include <glm/glm.hpp>

#include "lab/scene/mesh/mesh.h"

namespace reprise::lab {

// A ring of cards about the origin that show treeLineImage, feet on the ground.
Mesh treeLineMesh(float radius_m, float height_m, uint32_t cards, float first_u);
// A ring of land that begins below the ground at `from_m` and rises to wooded crests; uv in
// repeats of canopyImage.
Mesh hillsMesh(float from_m, float to_m);
// A dome that shows skyImage.
Mesh skyMesh(float radius_m);

}  // namespace reprise::lab
