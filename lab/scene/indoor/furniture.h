// SPDX-License-Identifier: MIT
//
// What stands in the room of the scene `indoor`, each piece about its own foot or joint.
#pragma once

#include "lab/scene/mesh/mesh.h"

namespace reprise::lab {

// A carved chest without its lid, on y = 0, and the lid, hinged along z at the origin.
constexpr glm::vec3 kChest_m = {0.62f, 0.50f, 0.95f};
Mesh carvedChest();
Mesh carvedLid();

// A turned stone foot; its top is at y = height.
Mesh pedestal(float height, float radius);
// A shade of a lamp that hangs, with its rod; the bulb's place is the origin.
Mesh lampShade(float rod_m);

}  // namespace reprise::lab
