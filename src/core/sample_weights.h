// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "equations/language.h"

namespace reprise {

// Weights of the nine samples of a 3x3 neighbourhood for the value at the middle pixel's centre,
// sum 1, row by row. The sample of the neighbour at offset d lies at d - jitter from that centre;
// `filter` gives the weight of an offset (dx_px, dy_px). A filter that misses all nine leaves the
// pixel's own sample.
template <typename Filter>
std::array<float, 9> sampleWeights(eq::vec2 jitter_px, Filter filter) {
  std::array<float, 9> weights{};
  float sum = 0.0f;
  for (int i = 0; i < 9; ++i) {
    const float dx_px = static_cast<float>(i % 3 - 1) - jitter_px.x;
    const float dy_px = static_cast<float>(i / 3 - 1) - jitter_px.y;
    weights[static_cast<size_t>(i)] = filter(dx_px, dy_px);
    sum += weights[static_cast<size_t>(i)];
  }
  if (!(sum > 1.0e-6f)) {
    weights.fill(0.0f);
    weights[4] = sum = 1.0f;
  }
  for (float& weight : weights) weight /= sum;
  return weights;
}

}  // namespace reprise
