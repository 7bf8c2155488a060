// SPDX-License-Identifier: MIT
//
// A tube through elliptical cross-sections, with rounded ends: bodies, limbs, necks, horns.
#pragma once

#include <span>

#include "lab/scene/mesh/mesh.h"

namespace reprise::lab {

// An ellipse across the path. Its width lies along the loft's side axis, its height along
// cross(side, direction of the path).
struct Section {
  glm::vec3 center{0.0f};
  float half_height = 0.0f;
  float half_width = 0.0f;
};

struct LoftDetail {
  glm::vec3 side{0.0f, 0.0f, 1.0f};  // never along the path
  uint32_t around = 32;
  uint32_t rows_a_span = 8;  // between two sections
  uint32_t cap_rows = 6;
  float cap_length = 1.0f;  // of the rounded ends, in the mean radius of the end's section
};

// Closed. Between sections everything follows a Catmull-Rom spline (centripetal in the distance of
// centres would add nothing at the near even spacing we use: uniform). At least two sections.
// uv: (metres along, turns around).
Mesh loft(std::span<const Section> sections, const LoftDetail& detail = {});

}  // namespace reprise::lab
