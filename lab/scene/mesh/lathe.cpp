// SPDX-License-Identifier: MIT
#include "lab/scene/mesh/lathe.h"

#include <array>
#include <cmath>
#include <numbers>

namespace reprise::lab {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

float fraction(uint32_t part, uint32_t whole) {
  return static_cast<float>(part) / static_cast<float>(whole);
}

// From pole to pole; the poles lie exactly on the axis.
std::vector<glm::vec2> halfCircle(float radius, uint32_t steps) {
  std::vector<glm::vec2> profile;
  for (uint32_t i = 0; i <= steps; ++i) {
    const float angle = kPi * fraction(i, steps);
    const bool pole = i == 0 || i == steps;
    profile.emplace_back(pole ? 0.0f : radius * std::sin(angle), -radius * std::cos(angle));
  }
  return profile;
}

}  // namespace

Mesh lathe(std::span<const glm::vec2> profile, uint32_t around, float crease) {
  std::vector<float> along_m = {0.0f};
  for (size_t i = 1; i < profile.size(); ++i) {
    along_m.push_back(along_m.back() + glm::distance(profile[i - 1], profile[i]));
  }
  Mesh mesh = gridMesh(
      static_cast<uint32_t>(profile.size()) - 1, around, [&](uint32_t column, uint32_t row) {
        const float angle = 2.0f * kPi * (row == around ? 0.0f : fraction(row, around));
        const glm::vec2 p = profile[column];
        return GridPoint{{p.x * std::cos(angle), p.y, p.x * std::sin(angle)},
                         {along_m[column], fraction(row, around)}};
      });
  makeSmooth(mesh, crease);
  return mesh;
}

Mesh sphereMesh(float radius, uint32_t around) {
  return lathe(halfCircle(radius, around / 2), around);
}

Mesh ellipsoidMesh(glm::vec3 radii, uint32_t around) {
  Mesh mesh = sphereMesh(1.0f, around);
  for (GpuVertex& vertex : mesh.vertices) {
    // The gradient of x^2/a^2 + y^2/b^2 + z^2/c^2 is the normal.
    const glm::vec3 normal = glm::normalize(glm::vec3(vertex.normal_v) / radii);
    vertex = {{glm::vec3(vertex.position_u) * radii, vertex.position_u.w},
              {normal, vertex.normal_v.w}};
  }
  return mesh;
}

Mesh torusMesh(float ring_radius, float tube_radius, uint32_t around, uint32_t around_tube) {
  std::vector<glm::vec2> profile;
  for (uint32_t i = 0; i < around_tube; ++i) {
    const float angle = 2.0f * kPi * fraction(i, around_tube);
    profile.emplace_back(ring_radius + tube_radius * std::cos(angle),
                         tube_radius * std::sin(angle));
  }
  profile.push_back(profile.front());
  return lathe(profile, around);
}

Mesh frustumMesh(float bottom_radius, float top_radius, float height, uint32_t around) {
  const std::array<glm::vec2, 4> profile = {
      {{0.0f, 0.0f}, {bottom_radius, 0.0f}, {top_radius, height}, {0.0f, height}}};
  constexpr float kSharp = 0.6f;
  return lathe(profile, around, kSharp);
}

}  // namespace reprise::lab
