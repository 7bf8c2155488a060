// SPDX-License-Identifier: MIT
#include "equations/blue_noise.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "equations/void_and_cluster.h"

namespace reprise::eq {
namespace {

constexpr uint32_t kGrid = 64;
constexpr uint32_t kCells = kGrid * kGrid;
// Width of a point's energy over the mean distance of the points; Ulichney's 1.5 cells at his
// density of one cell in ten. It follows the count: few points must repel across the whole pixel.
constexpr float kWidthPerDistance = 0.474f;
// 1 in the fixed point of an energy's two factors. Integers, so that every compiler finds the same
// clusters and voids.
constexpr float kOne = 1048576.0f;

// Energy that a point adds at a toroidal offset in cells.
class Energy {
 public:
  explicit Energy(size_t count) {
    const float sigma = kWidthPerDistance * kGrid / std::sqrt(static_cast<float>(count));
    for (uint32_t d = 0; d < kGrid; ++d) {
      const auto distance = static_cast<float>(std::min(d, kGrid - d));
      falloff_[d] = std::llround(kOne * std::exp(-0.5f * distance * distance / (sigma * sigma)));
    }
  }
  int64_t operator()(uint32_t a, uint32_t b) const {
    return falloff_[(a % kGrid + kGrid - b % kGrid) % kGrid] *
           falloff_[(a / kGrid + kGrid - b / kGrid) % kGrid];
  }

 private:
  std::array<int64_t, kGrid> falloff_{};
};

// Last first: the point of the tightest cluster leaves (his phase I).
std::vector<uint32_t> ranked(std::vector<uint32_t> points) {
  std::vector<uint32_t> order(points.size());
  while (!points.empty()) {
    const Energy energy(points.size());
    size_t tightest = 0;
    int64_t highest = -1;
    for (size_t i = 0; i < points.size(); ++i) {
      int64_t sum = 0;
      for (const uint32_t other : points) sum += energy(points[i], other);
      if (sum > highest) {
        highest = sum;
        tightest = i;
      }
    }
    order[points.size() - 1] = points[tightest];
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(tightest));
  }
  return order;
}

std::vector<vec2> offsets() {
  const std::vector<uint32_t> order =
      ranked(spreadPoints(kMaxBlueNoise, kCells, 0, Energy(kMaxBlueNoise)));
  std::vector<vec2> result;
  for (const uint32_t cell : order) {
    // On a torus the whole pattern may move: the first point goes to the centre.
    const uint32_t x = (cell + kGrid - order[0] % kGrid + kGrid / 2) % kGrid;
    const uint32_t y = (cell / kGrid + kGrid - order[0] / kGrid + kGrid / 2) % kGrid;
    result.emplace_back((static_cast<float>(x) + 0.5f) / kGrid - 0.5f,
                        (static_cast<float>(y) + 0.5f) / kGrid - 0.5f);
  }
  return result;
}

}  // namespace

const std::vector<vec2>& blueNoiseSequence() {
  static const std::vector<vec2> sequence = offsets();
  return sequence;
}

}  // namespace reprise::eq
