// SPDX-License-Identifier: MIT
#pragma once

#include "lab/scene/mesh/mesh.h"

namespace reprise::lab {

// Height above a face (m), of a point of it in metres from its centre, on face 0 to 5 (+x, -x, +y,
// -y, +z, -z). It must be 0 on the face's edges, where faces meet.
using FaceRelief = std::function<float(uint32_t face, glm::vec2 on_face_m)>;

// A box of that size about the origin, each face in cells x cells squares, raised by a relief.
// Closed. uv: metres from the face's corner.
Mesh boxMesh(glm::vec3 size_m, uint32_t cells, const FaceRelief& relief = nullptr);

}  // namespace reprise::lab
