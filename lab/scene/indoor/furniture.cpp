// SPDX-License-Identifier: MIT
#include "lab/scene/indoor/furniture.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "lab/scene/mesh/box.h"
#include "lab/scene/mesh/lathe.h"

namespace reprise::lab {
namespace {

constexpr float kLid_m = 0.13f;  // thickness

float smooth(float low, float high, float x) {
  const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

// Depth of the carving: a rosette of petals amid scales, framed by a beaded moulding.
float carving(glm::vec2 p, glm::vec2 half_m) {
  const glm::vec2 to_edge = half_m - glm::abs(p);
  const float edge = std::min(to_edge.x, to_edge.y);
  if (edge < 0.055f) {
    const float run = to_edge.x < to_edge.y ? p.y : p.x;
    const float across = (edge - 0.034f) / 0.016f;
    const float bead =
        std::max(0.0f, 1.0f - across * across) * std::abs(std::sin(run * 3.14159265f / 0.030f));
    return 0.014f * smooth(0.0f, 0.012f, edge) + 0.018f * bead;
  }
  const float radius = glm::length(p);
  const float angle = std::atan2(p.y, p.x);
  const float reach_m = 0.80f * (std::min(half_m.x, half_m.y) - 0.055f);
  const float petal = reach_m * (0.62f + 0.38f * std::abs(std::cos(4.0f * angle)));
  if (radius < petal) {
    const float ribs = 0.5f + 0.5f * std::cos(24.0f * angle);
    const float dome = 1.0f - (radius / petal) * (radius / petal);
    const float heart = 0.020f * std::max(0.0f, 1.0f - radius * radius / (0.04f * 0.04f));
    return 0.036f * std::sqrt(std::max(dome, 0.0f)) * (0.72f + 0.28f * ribs) + heart;
  }
  // Scales in the ground.
  const glm::vec2 q = p / 0.040f;
  const float row = std::floor(q.y);
  const float x = q.x + 0.5f * std::fmod(std::abs(row), 2.0f);
  const glm::vec2 within(x - std::floor(x) - 0.5f, q.y - row - 0.2f);
  return 0.012f * std::max(0.0f, 1.0f - 1.6f * glm::dot(within, within));
}

glm::vec2 halfOfFace(uint32_t face, glm::vec3 size_m) {
  const int axis = static_cast<int>(face) / 2;
  const int a = (axis + (face % 2 == 0 ? 1 : 2)) % 3;
  const int b = (axis + (face % 2 == 0 ? 2 : 1)) % 3;
  return {0.5f * size_m[a], 0.5f * size_m[b]};
}

Mesh carvedBox(glm::vec3 size_m, uint32_t cells) {
  return boxMesh(size_m, cells, [size_m](uint32_t face, glm::vec2 p) {
    return carving(p, halfOfFace(face, size_m));
  });
}

}  // namespace

Mesh carvedChest() {
  constexpr uint32_t kCells = 76;
  return transformed(carvedBox(kChest_m, kCells),
                     glm::translate(glm::mat4(1.0f), {0.0f, 0.5f * kChest_m.y, 0.0f}));
}

Mesh carvedLid() {
  const glm::vec3 size_m(kChest_m.x + 0.06f, kLid_m, kChest_m.z + 0.06f);
  return transformed(carvedBox(size_m, 44),
                     glm::translate(glm::mat4(1.0f), {0.5f * kChest_m.x, 0.5f * kLid_m, 0.0f}));
}

Mesh pedestal(float height, float radius) {
  const float r = radius;
  std::vector<glm::vec2> profile = {
      {0.0f, 0.0f}, {1.25f * r, 0.0f}, {1.25f * r, 0.07f}, {1.1f * r, 0.10f}};
  constexpr int kFlutes = 20;
  for (int i = 0; i <= kFlutes; ++i) {
    const float t = static_cast<float>(i) / kFlutes;
    const float waist = 0.74f + 0.20f * (2.0f * t - 1.0f) * (2.0f * t - 1.0f);
    profile.emplace_back(r * waist, 0.12f + t * (height - 0.22f));
  }
  profile.insert(profile.end(), {{1.02f * r, height - 0.07f},
                                 {1.15f * r, height - 0.05f},
                                 {1.15f * r, height},
                                 {0.0f, height}});
  return lathe(profile, 48, 0.5f);
}

Mesh lampShade(float rod_m) {
  const glm::vec2 profile[] = {{0.26f, -0.06f}, {0.25f, -0.02f}, {0.17f, 0.08f},  {0.07f, 0.15f},
                               {0.035f, 0.17f}, {0.012f, 0.19f}, {0.012f, rod_m}, {0.0f, rod_m}};
  return lathe(profile, 48, 0.9f);
}

}  // namespace reprise::lab
