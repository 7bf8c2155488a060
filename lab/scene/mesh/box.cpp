// SPDX-License-Identifier: MIT
#include "lab/scene/mesh/box.h"

namespace reprise::lab {

Mesh boxMesh(glm::vec3 size_m, uint32_t cells, const FaceRelief& relief) {
  Mesh mesh;
  for (uint32_t face = 0; face < 6; ++face) {
    const int axis = static_cast<int>(face) / 2;
    const float sign = face % 2 == 0 ? 1.0f : -1.0f;
    // Columns run along `a`, rows along `b`; swapped for negative faces, so that a x b looks out.
    const int a = (axis + (sign > 0.0f ? 1 : 2)) % 3;
    const int b = (axis + (sign > 0.0f ? 2 : 1)) % 3;
    append(mesh, gridMesh(cells, cells, [&](uint32_t column, uint32_t row) {
             // Exact at both ends: faces share their edges.
             const auto along = [&](uint32_t step, float length) {
               return length * (static_cast<float>(step) - 0.5f * static_cast<float>(cells)) /
                      static_cast<float>(cells);
             };
             const glm::vec2 on_face(along(column, size_m[a]), along(row, size_m[b]));
             const bool edge = column == 0 || column == cells || row == 0 || row == cells;
             const float raised = relief && !edge ? relief(face, on_face) : 0.0f;
             GridPoint point;
             point.position[axis] = sign * (0.5f * size_m[axis] + raised);
             point.position[a] = on_face.x;
             point.position[b] = on_face.y;
             point.uv = on_face + 0.5f * glm::vec2(size_m[a], size_m[b]);
             return point;
           }));
  }
  constexpr float kSharp = 0.7f;
  makeSmooth(mesh, kSharp);
  return mesh;
}

}  // namespace reprise::lab
