// SPDX-License-Identifier: MIT
#include "equations/blue_noise.h"

#include <array>

namespace reprise::eq {
namespace {

constexpr uint32_t kGrid = 32;
constexpr uint32_t kCells = kGrid * kGrid;
// Ulichney's 1.5 cells suit masks of ranks; here single points must repel across the whole pixel while
// they are few, so the width follows the mean distance of the points so far.
constexpr float kWidthPerDistance = 0.5f;

std::vector<vec2> fillVoids() {
  std::vector<vec2> points;
  std::vector<bool> taken(kCells, false);
  std::vector<uint32_t> cells;
  uint32_t next = (kGrid / 2) * kGrid + kGrid / 2;
  while (true) {
    taken[next] = true;
    cells.push_back(next);
    points.emplace_back((static_cast<float>(next % kGrid) + 0.5f) / kGrid - 0.5f,
                        (static_cast<float>(next / kGrid) + 0.5f) / kGrid - 0.5f);
    if (points.size() == kMaxBlueNoise) return points;

    // Energy that one point adds at a toroidal offset, for the width that suits this many points.
    const float sigma = kWidthPerDistance * kGrid / std::sqrt(static_cast<float>(points.size() + 1));
    std::array<float, kGrid> falloff{};
    for (uint32_t d = 0; d < kGrid; ++d) {
      const auto distance = static_cast<float>(std::min(d, kGrid - d));
      falloff[d] = std::exp(-0.5f * distance * distance / (sigma * sigma));
    }
    float lowest = 0.0f;
    bool found = false;
    for (uint32_t cell = 0; cell < kCells; ++cell) {
      if (taken[cell]) continue;
      float energy = 0.0f;
      for (const uint32_t other : cells) {
        energy += falloff[(cell % kGrid + kGrid - other % kGrid) % kGrid] *
                  falloff[(cell / kGrid + kGrid - other / kGrid) % kGrid];
      }
      if (!found || energy < lowest) {
        lowest = energy;
        next = cell;
        found = true;
      }
    }
  }
}

}  // namespace

const std::vector<vec2>& blueNoiseSequence() {
  static const std::vector<vec2> sequence = fillVoids();
  return sequence;
}

}  // namespace reprise::eq
