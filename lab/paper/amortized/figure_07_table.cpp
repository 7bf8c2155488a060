// SPDX-License-Identifier: MIT
//
// Figure 7: the smallest smoothing factor that respects a blur threshold, over the velocity.
#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "lab/paper/amortized/experiments.h"
#include "techniques/amortized/blur_table.h"

namespace reprise::lab::amortized {
namespace {

// The default of the technique, and the paper's two.
constexpr double kThresholds_px2[] = {0.25, 1.0, 2.0};

Surface sliceAt(double threshold_px2) {
  using reprise::amortized::kTableSize;
  const reprise::amortized::BlurSlice slice = reprise::amortized::blurSlice(4, threshold_px2);
  Surface map{fmt::format("tau_b = {} px^2", threshold_px2), {}, {}, {}};
  for (uint32_t i = 0; i < kTableSize; ++i) map.x.push_back(i / double(kTableSize - 1));
  map.y = map.x;
  for (const uint8_t entry : slice) map.z.push_back(entry / 255.0);
  return map;
}

}  // namespace

void figure7(PaperLab&, Outcome& outcome) {
  std::vector<Surface> maps;
  std::vector<double> means;
  for (const double threshold_px2 : kThresholds_px2) {
    maps.push_back(sliceAt(threshold_px2));
    const std::vector<double>& z = maps.back().z;
    means.push_back(std::accumulate(z.begin(), z.end(), 0.0) / static_cast<double>(z.size()));
    outcome.report(fmt::format("mean alpha at tau_b {} px^2", threshold_px2), std::nullopt,
                   means.back(), "");
    outcome.report(fmt::format("largest alpha at tau_b {} px^2", threshold_px2), std::nullopt,
                   *std::max_element(z.begin(), z.end()), "");
  }
  size_t higher = 0;
  for (size_t i = 0; i < maps[1].z.size(); ++i) higher += maps[2].z[i] > maps[1].z[i] ? 1 : 0;
  outcome.claim("velocities whose alpha is larger at tau_b 2 than at 1 px^2", std::nullopt,
                static_cast<double>(higher), "", "none", higher == 0);
  outcome.heatMaps(
      {"Smallest smoothing factor of a buffer", "vx, px a frame", "vy, px a frame", "alpha"}, maps);
  outcome.note("The library's own table, at its default threshold and at the paper's two.");
}

}  // namespace reprise::lab::amortized
