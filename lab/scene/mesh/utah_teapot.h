// SPDX-License-Identifier: MIT
//
// Martin Newell's teapot of 1975: 32 bicubic patches (with the bottom that was added later). In his
// units, y up, 3.15 high with the lid, spout along +x, standing on y = 0.
#pragma once

#include <vector>

#include "lab/scene/mesh/bezier_patch.h"

namespace reprise::lab {

std::vector<BezierPatch> utahTeapotPatches();

// cells x cells squares a patch, scaled; patches join without gaps.
Mesh utahTeapotMesh(uint32_t cells, float scale);

}  // namespace reprise::lab
