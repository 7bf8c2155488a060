// SPDX-License-Identifier: MIT
#include "lab/scene/mesh/utah_teapot.h"

#include <glm/gtc/matrix_transform.hpp>

namespace reprise::lab {
namespace {

// Newell's control points, told by their symmetry: his body, rim, lid and bottom are profiles
// (radius, y) turned in four quarters, each quarter with control points at
// (1, 0), (1, k), (k, 1), (0, 1); his circles have k = 0.56.
constexpr float kQuarter = 0.56f;

using Profile = std::array<glm::vec2, 4>;
const Profile kProfiles[] = {
    {{{0.0f, 0.0f}, {1.425f, 0.0f}, {1.5f, 0.075f}, {1.5f, 0.15f}}},           // bottom
    {{{1.5f, 0.15f}, {1.5f, 0.225f}, {2.0f, 0.45f}, {2.0f, 0.9f}}},            // body
    {{{2.0f, 0.9f}, {2.0f, 1.35f}, {1.75f, 1.875f}, {1.5f, 2.4f}}},            // body
    {{{1.5f, 2.4f}, {1.4375f, 2.53125f}, {1.3375f, 2.53125f}, {1.4f, 2.4f}}},  // rim
    {{{1.3f, 2.4f}, {1.3f, 2.55f}, {0.4f, 2.55f}, {0.2f, 2.7f}}},              // lid
    {{{0.2f, 2.7f}, {0.0f, 2.85f}, {0.8f, 3.15f}, {0.0f, 3.15f}}}};            // knob

// Handle and spout are tubes: every row of control points goes from `inner` round the side at
// half_width to `outer`, mirrored in z.
struct TubeRow {
  glm::vec2 inner;
  glm::vec2 outer;
  float half_width;
};
using Tube = std::array<TubeRow, 4>;
const Tube kTubes[] = {
    // handle, upper and lower
    {{{{-1.6f, 2.025f}, {-1.5f, 2.25f}, 0.3f},
      {{-2.3f, 2.025f}, {-2.5f, 2.25f}, 0.3f},
      {{-2.7f, 2.025f}, {-3.0f, 2.25f}, 0.3f},
      {{-2.7f, 1.8f}, {-3.0f, 1.8f}, 0.3f}}},
    {{{{-2.7f, 1.8f}, {-3.0f, 1.8f}, 0.3f},
      {{-2.7f, 1.575f}, {-3.0f, 1.35f}, 0.3f},
      {{-2.5f, 1.125f}, {-2.65f, 0.9375f}, 0.3f},
      {{-2.0f, 0.9f}, {-1.9f, 0.6f}, 0.3f}}},
    // spout, lower and upper
    {{{{1.7f, 1.425f}, {1.7f, 0.6f}, 0.66f},
      {{2.6f, 1.425f}, {3.1f, 0.825f}, 0.66f},
      {{2.3f, 2.1f}, {2.4f, 2.025f}, 0.25f},
      {{2.7f, 2.4f}, {3.3f, 2.4f}, 0.25f}}},
    {{{{2.7f, 2.4f}, {3.3f, 2.4f}, 0.25f},
      {{2.8f, 2.475f}, {3.525f, 2.49375f}, 0.25f},
      {{2.9f, 2.475f}, {3.45f, 2.5125f}, 0.15f},
      {{2.8f, 2.4f}, {3.2f, 2.4f}, 0.15f}}}};

BezierPatch turned(const Profile& profile, int quarter) {
  // (x, z) of a quarter's control points, turned by right angles.
  const glm::vec2 first[4] = {{1.0f, 0.0f}, {1.0f, kQuarter}, {kQuarter, 1.0f}, {0.0f, 1.0f}};
  BezierPatch patch;
  for (size_t i = 0; i < 4; ++i) {
    for (size_t j = 0; j < 4; ++j) {
      glm::vec2 at = first[j];
      for (int k = 0; k < quarter; ++k) at = {-at.y, at.x};
      patch[i][j] = {profile[i].x * at.x, profile[i].y, profile[i].x * at.y};
    }
  }
  return patch;
}

BezierPatch half(const Tube& tube, float side) {
  BezierPatch patch;
  for (size_t row = 0; row < 4; ++row) {
    const TubeRow& r = tube[row];
    const glm::vec3 around[4] = {{r.inner, 0.0f},
                                 {r.inner, side * r.half_width},
                                 {r.outer, side * r.half_width},
                                 {r.outer, 0.0f}};
    // u goes around so that the outside is out: the other way on the other side.
    for (size_t k = 0; k < 4; ++k) patch[side > 0.0f ? k : 3 - k][row] = around[k];
  }
  return patch;
}

}  // namespace

std::vector<BezierPatch> utahTeapotPatches() {
  std::vector<BezierPatch> patches;
  for (const Profile& profile : kProfiles) {
    for (int quarter = 0; quarter < 4; ++quarter) patches.push_back(turned(profile, quarter));
  }
  for (const Tube& tube : kTubes) {
    for (const float side : {1.0f, -1.0f}) patches.push_back(half(tube, side));
  }
  return patches;
}

Mesh utahTeapotMesh(uint32_t cells, float scale) {
  Mesh mesh;
  for (const BezierPatch& patch : utahTeapotPatches()) append(mesh, bezierMesh(patch, cells));
  // Neighbours evaluate their common edge with other sums: nearly the same places.
  constexpr float kWeld = 1.0e-4f;
  weld(mesh, kWeld);
  constexpr float kCrease = 1.2f;  // the bottom's edge and the lid's stay
  makeSmooth(mesh, kCrease);
  return transformed(mesh, glm::scale(glm::mat4(1.0f), glm::vec3(scale)));
}

}  // namespace reprise::lab
