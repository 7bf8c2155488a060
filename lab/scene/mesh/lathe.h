// SPDX-License-Identifier: MIT
//
// Surfaces of revolution about y: spheres, tori, cylinders, cones, feet, lamps.
#pragma once

#include <span>

#include "lab/scene/mesh/mesh.h"

namespace reprise::lab {

// Points (radius, y) of the profile, so that the outside is at its right when walked: a closed
// solid goes from its bottom on the axis, outwards, to its top on the axis. uv: (metres along the
// profile, turns). Edges that bend by more than `crease` (radians) stay sharp.
Mesh lathe(std::span<const glm::vec2> profile, uint32_t around, float crease = kNoCrease);

Mesh sphereMesh(float radius, uint32_t around);
Mesh ellipsoidMesh(glm::vec3 radii, uint32_t around);
// Around y; `ring` from the centre to the middle of the tube.
Mesh torusMesh(float ring_radius, float tube_radius, uint32_t around, uint32_t around_tube);
// From y = 0 to `height`, closed; `crease` as sharp edges need.
Mesh frustumMesh(float bottom_radius, float top_radius, float height, uint32_t around);

}  // namespace reprise::lab
