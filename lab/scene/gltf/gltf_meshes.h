// SPDX-License-Identifier: MIT
//
// Meshes of a glTF file as the lab's geometry.
#pragma once

#include <cstdint>
#include <vector>

#include "lab/scene/gltf/gltf_file.h"
#include "lab/scene/gltf/gltf_nodes.h"
#include "lab/scene/scene.h"

namespace reprise::lab {

// Fills `geometry`. What stands still is one instance a material, in world space; what moves is an
// instance for each node and primitive, and `movers` names the node of each, -1 for the rest.
void appendMeshes(GltfFile& file, const GltfNodes& nodes, Geometry& geometry,
                  std::vector<int>& movers);

}  // namespace reprise::lab
