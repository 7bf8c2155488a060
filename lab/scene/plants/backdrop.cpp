// SPDX-License-Identifier: MIT
#include "lab/scene/plants/backdrop.h"

#include <cmath>

namespace reprise::lab {
namespace {

constexpr float kTau = 6.28318531f;
constexpr uint32_t kHillColumns = 96;
constexpr uint32_t kHillRows = 12;
constexpr float kCanopySide_m = 22.0f;  // of the picture on the hills
constexpr float kCrest = 0.75f;         // of the way from a hill's foot to its far side
constexpr uint32_t kCardsAPicture = 4;
// The dome's rim lies below the horizon, behind the hills.
constexpr float kLowestSky_rad = -0.05f;

glm::vec2 around(float turn) {
  return {std::sin(kTau * turn), -std::cos(kTau * turn)};
}

// Of the crest above the ground, m.
float crestHeight(float turn) {
  const float a = kTau * turn;
  return 11.0f + 4.0f * std::sin(3.0f * a + 0.6f) + 2.5f * std::sin(7.0f * a + 2.0f) +
         1.2f * std::sin(17.0f * a) + 0.5f * std::sin(39.0f * a + 1.0f);
}

}  // namespace

Mesh treeLineMesh(float radius_m, float height_m, uint32_t cards, float first_u) {
  Mesh mesh = gridMesh(cards, 1, [=](uint32_t column, uint32_t row) {
    const float turn = static_cast<float>(column) / static_cast<float>(cards);
    // Every second edge is nearer: a wood's edge is no circle.
    const float radius = radius_m * (column % 2 == 0 ? 1.0f : 0.93f);
    const glm::vec2 at = around(turn) * radius;
    const auto up = static_cast<float>(row);
    return GridPoint{{at.x, height_m * up - 0.3f, at.y},
                     {first_u + static_cast<float>(column) / kCardsAPicture, up}};
  });
  makeSmooth(mesh, kNoCrease);
  return mesh;
}

Mesh hillsMesh(float from_m, float to_m) {
  Mesh mesh = gridMesh(kHillColumns, kHillRows, [=](uint32_t column, uint32_t row) {
    const float turn = static_cast<float>(column) / kHillColumns;
    const float out = static_cast<float>(row) / kHillRows;
    const glm::vec2 at = around(turn) * (from_m + (to_m - from_m) * out);
    const float rise = std::sin(0.25f * kTau * std::min(out / kCrest, 1.0f / kCrest));
    return GridPoint{{at.x, crestHeight(turn) * rise - 0.8f, at.y}, at / kCanopySide_m};
  });
  makeSmooth(mesh, kNoCrease);
  return mesh;
}

Mesh skyMesh(float radius_m) {
  Mesh mesh = gridMesh(32, 8, [=](uint32_t column, uint32_t row) {
    const float turn = static_cast<float>(column) / 32.0f;
    const float up = static_cast<float>(row) / 8.0f;
    const float elevation = kLowestSky_rad + (0.25f * kTau - kLowestSky_rad) * up;
    const glm::vec2 at = around(turn) * (radius_m * std::cos(elevation));
    return GridPoint{{at.x, radius_m * std::sin(elevation), at.y}, {turn, up}};
  });
  makeSmooth(mesh, kNoCrease);
  return mesh;
}

}  // namespace reprise::lab
