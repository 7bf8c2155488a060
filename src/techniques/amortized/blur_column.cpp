// SPDX-License-Identifier: MIT
#include <cmath>

#include "techniques/amortized/blur_moments.h"
#include "techniques/amortized/blur_table.h"

namespace reprise::amortized {

std::array<uint8_t, kTableSize> blurColumn(uint32_t buffers, double vx, double vy) {
  const BufferLayout layout = bufferLayout(buffers);
  const double variance = static_cast<double>(layout.sigma_px) * layout.sigma_px;
  const PanningGathers gathers(layout, vx, vy);
  // From fresh samples alone downwards: the first weight that breaks a threshold ends its search,
  // also where less weight would happen to blur less again (drift that cancels).
  std::array<uint8_t, kTableSize> column;
  column.fill(1);
  uint32_t open = 0;  // thresholds below are settled
  constexpr double kStep = 0.94;
  double above = 1.0;
  for (double alpha = kStep; open < kTableSize; alpha *= kStep) {
    const double blur = gathers.moments(alpha, variance).second;
    // Rounding of the tent's floats must not count as blur.
    while (open < kTableSize && blur > blurThreshold(open, variance) + 1.0e-6) {
      // Between `alpha`, which is too small, and `above`, which is not, in 1 / alpha, in which
      // blur is nearly linear.
      const double blur_above = gathers.moments(above, variance).second;
      const double t = (blurThreshold(open, variance) - blur_above) / (blur - blur_above);
      const double limit = 1.0 / (1.0 / above + t * (1.0 / alpha - 1.0 / above));
      column[open++] = static_cast<uint8_t>(std::ceil(std::min(limit, 1.0) * 255.0 - 1.0e-9));
    }
    above = alpha;
    if (alpha < kSmallestAlpha) break;
  }
  return column;
}

}  // namespace reprise::amortized
