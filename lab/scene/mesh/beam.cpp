// SPDX-License-Identifier: MIT
#include "lab/scene/mesh/beam.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace reprise::lab {
namespace {

constexpr float kTau = 6.28318531f;
constexpr uint32_t kCableSpans = 24;
constexpr uint32_t kCableSides = 5;

glm::vec3 acrossOf(glm::vec3 along) {
  const glm::vec3 helper =
      std::abs(along.y) < 0.9f ? glm::vec3(0.0f, 1.0f, 0.0f) : glm::vec3(1.0f, 0.0f, 0.0f);
  return glm::normalize(glm::cross(along, helper));
}

}  // namespace

void appendBeam(Mesh& mesh, glm::vec3 a, glm::vec3 b, float thickness_m) {
  const glm::vec3 along = glm::normalize(b - a);
  const glm::vec3 side = acrossOf(along);
  const glm::vec3 up = glm::cross(side, along);
  const float half = 0.5f * thickness_m;
  const glm::vec3 normals[] = {side, up, -side, -up};
  for (uint32_t face = 0; face < 4; ++face) {
    const glm::vec3 normal = normals[face];
    const glm::vec3 edge = glm::cross(along, normal);
    const auto base = static_cast<uint32_t>(mesh.vertices.size());
    for (const glm::vec3 end : {a, b}) {
      const float v = glm::distance(a, end);
      for (const float s : {-1.0f, 1.0f}) {
        mesh.vertices.push_back(
            {glm::vec4(end + half * (normal + s * edge), half * (s + 1.0f)), glm::vec4(normal, v)});
      }
    }
    for (const uint32_t corner : {0u, 3u, 1u, 0u, 2u, 3u}) mesh.indices.push_back(base + corner);
  }
}

void appendTube(Mesh& mesh, std::span<const glm::vec3> points, float radius_m, uint32_t sides) {
  const auto base = static_cast<uint32_t>(mesh.vertices.size());
  glm::vec3 side = acrossOf(glm::normalize(points[1] - points[0]));
  float along_m = 0.0f;
  for (size_t i = 0; i < points.size(); ++i) {
    const glm::vec3 along =
        glm::normalize(points[std::min(i + 1, points.size() - 1)] - points[i == 0 ? 0 : i - 1]);
    side = glm::normalize(side - along * glm::dot(side, along));
    const glm::vec3 other = glm::cross(along, side);
    if (i > 0) along_m += glm::distance(points[i], points[i - 1]);
    for (uint32_t k = 0; k <= sides; ++k) {
      const float turn = static_cast<float>(k) / static_cast<float>(sides);
      const glm::vec3 normal = std::cos(kTau * turn) * side + std::sin(kTau * turn) * other;
      mesh.vertices.push_back(
          {glm::vec4(points[i] + normal * radius_m, turn), glm::vec4(normal, along_m)});
    }
  }
  const uint32_t row = sides + 1;
  for (uint32_t i = 0; i + 1 < points.size(); ++i) {
    for (uint32_t k = 0; k < sides; ++k) {
      const uint32_t a = base + i * row + k;
      mesh.indices.insert(mesh.indices.end(), {a, a + 1, a + row + 1, a, a + row + 1, a + row});
    }
  }
}

void appendCable(Mesh& mesh, glm::vec3 a, glm::vec3 b, float sag_m, float radius_m) {
  std::vector<glm::vec3> points;
  for (uint32_t i = 0; i <= kCableSpans; ++i) {
    const float s = static_cast<float>(i) / kCableSpans;
    points.push_back(glm::mix(a, b, s) - glm::vec3(0.0f, 4.0f * sag_m * s * (1.0f - s), 0.0f));
  }
  appendTube(mesh, points, radius_m, kCableSides);
}

void appendGirder(Mesh& mesh, const Girder& girder) {
  const glm::vec3 up = girder.up * girder.depth_m;
  const glm::vec3 step = (girder.to - girder.from) / static_cast<float>(girder.bays);
  appendBeam(mesh, girder.from, girder.to, girder.chord_m);
  appendBeam(mesh, girder.from + up, girder.to + up, girder.chord_m);
  for (uint32_t i = 0; i <= girder.bays; ++i) {
    const glm::vec3 foot = girder.from + step * static_cast<float>(i);
    appendBeam(mesh, foot, foot + up, girder.brace_m);
    if (i == girder.bays) break;
    const bool rising = i % 2 == 0;
    appendBeam(mesh, rising ? foot : foot + up, foot + step + (rising ? up : glm::vec3(0.0f)),
               girder.brace_m);
  }
}

}  // namespace reprise::lab
