// SPDX-License-Identifier: MIT
#include "lab/scene/mesh/loft.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace reprise::lab {
namespace {

// What one row of the tube is: a section with the direction of the path there.
struct Ring {
  Section section;
  glm::vec3 direction{0.0f};
  float along_m = 0.0f;
};

template <typename T>
T catmullRom(const T& a, const T& b, const T& c, const T& d, float t) {
  const float t2 = t * t;
  const float t3 = t2 * t;
  return 0.5f * ((2.0f * b) + (c - a) * t + (2.0f * a - 5.0f * b + 4.0f * c - d) * t2 +
                 (3.0f * b - a - 3.0f * c + d) * t3);
}

std::vector<Ring> ringsAlong(std::span<const Section> sections, uint32_t rows_a_span) {
  const auto count = static_cast<int>(sections.size());
  const auto at = [&](int i) { return sections[static_cast<size_t>(std::clamp(i, 0, count - 1))]; };
  std::vector<Ring> rings;
  for (int span = 0; span + 1 < count; ++span) {
    const bool last = span + 2 == count;
    for (uint32_t row = 0; row < rows_a_span + (last ? 1 : 0); ++row) {
      const float t = static_cast<float>(row) / static_cast<float>(rows_a_span);
      const Section a = at(span - 1);
      const Section b = at(span);
      const Section c = at(span + 1);
      const Section d = at(span + 2);
      Ring ring;
      ring.section = {catmullRom(a.center, b.center, c.center, d.center, t),
                      catmullRom(a.half_height, b.half_height, c.half_height, d.half_height, t),
                      catmullRom(a.half_width, b.half_width, c.half_width, d.half_width, t)};
      rings.push_back(ring);
    }
  }
  for (size_t i = 0; i < rings.size(); ++i) {
    const glm::vec3 before = rings[i == 0 ? 0 : i - 1].section.center;
    const glm::vec3 after = rings[std::min(i + 1, rings.size() - 1)].section.center;
    rings[i].direction = glm::normalize(after - before);
    if (i > 0) {
      rings[i].along_m = rings[i - 1].along_m +
                         glm::distance(rings[i - 1].section.center, rings[i].section.center);
    }
  }
  return rings;
}

// A quarter ellipse that closes the end, from the pole to (not including) `end`.
std::vector<Ring> cap(const Ring& end, float outwards, const LoftDetail& detail) {
  const float length =
      detail.cap_length * 0.5f * (end.section.half_height + end.section.half_width);
  std::vector<Ring> rings;
  for (uint32_t row = 0; row < detail.cap_rows; ++row) {
    const float angle = 0.5f * std::numbers::pi_v<float> * static_cast<float>(row) /
                        static_cast<float>(detail.cap_rows);
    const float out = outwards * length * std::cos(angle);
    const float share = row == 0 ? 0.0f : std::sin(angle);
    Ring ring = end;
    ring.section = {end.section.center + out * end.direction, share * end.section.half_height,
                    share * end.section.half_width};
    ring.along_m += out;
    rings.push_back(ring);
  }
  return rings;
}

}  // namespace

Mesh loft(std::span<const Section> sections, const LoftDetail& detail) {
  const std::vector<Ring> middle = ringsAlong(sections, detail.rows_a_span);
  std::vector<Ring> rings = cap(middle.front(), -1.0f, detail);
  rings.insert(rings.end(), middle.begin(), middle.end());
  std::vector<Ring> end = cap(middle.back(), 1.0f, detail);
  rings.insert(rings.end(), end.rbegin(), end.rend());

  Mesh mesh = gridMesh(
      static_cast<uint32_t>(rings.size()) - 1, detail.around, [&](uint32_t column, uint32_t row) {
        const Ring& ring = rings[column];
        const glm::vec3 side =
            glm::normalize(detail.side - glm::dot(detail.side, ring.direction) * ring.direction);
        const glm::vec3 up = glm::cross(side, ring.direction);
        const float turn = static_cast<float>(row) / static_cast<float>(detail.around);
        // The last row is exactly the first.
        const float angle = 2.0f * std::numbers::pi_v<float> * (row == detail.around ? 0.0f : turn);
        return GridPoint{ring.section.center + side * (ring.section.half_width * std::cos(angle)) +
                             up * (ring.section.half_height * std::sin(angle)),
                         {ring.along_m, turn}};
      });
  makeSmooth(mesh, kNoCrease);
  return mesh;
}

}  // namespace reprise::lab
