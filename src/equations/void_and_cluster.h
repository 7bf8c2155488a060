// SPDX-License-Identifier: MIT
// C++ only: the first phase of void and cluster (Ulichney 1993), for any energy between cells.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "equations/hash.h"

namespace reprise::eq {

// Ulichney's initial pattern: `count` random cells of `cells`, then the point of the tightest
// cluster moves to the largest void until that is where it came from. A start without randomness
// would end in a lattice. `energy(a, b)`: an integer that a point at cell b adds at cell a.
template <typename Energy>
std::vector<uint32_t> spreadPoints(uint32_t count, uint32_t cells, uint32_t seed,
                                   const Energy& energy) {
  std::vector<uint32_t> points;
  std::vector<bool> taken(cells, false);
  for (uint32_t i = 0; points.size() < count; ++i) {
    const uint32_t cell = hashPcg(i + seed) % cells;
    if (!taken[cell]) points.push_back(cell);
    taken[cell] = true;
  }
  std::vector<int64_t> field(cells, 0);
  const auto add = [&](uint32_t point, int64_t sign_of_change) {
    for (uint32_t cell = 0; cell < cells; ++cell) {
      field[cell] += sign_of_change * energy(cell, point);
    }
  };
  for (const uint32_t point : points) add(point, 1);
  while (true) {
    const auto tightest = std::max_element(points.begin(), points.end(),
                                           [&](auto a, auto b) { return field[a] < field[b]; });
    const uint32_t left = *tightest;
    taken[left] = false;
    add(left, -1);
    uint32_t largest_void = left;
    for (uint32_t cell = 0; cell < cells; ++cell) {
      if (!taken[cell] && field[cell] < field[largest_void]) largest_void = cell;
    }
    *tightest = largest_void;
    taken[largest_void] = true;
    add(largest_void, 1);
    if (largest_void == left) return points;
  }
}

}  // namespace reprise::eq
