// SPDX-License-Identifier: MIT
#include "techniques/amortized/blur_table.h"

#include <algorithm>
#include <cmath>

#include "equations/amortized.h"
#include "techniques/amortized/buffer_layout.h"

namespace reprise::amortized {
namespace {

constexpr uint8_t kTableOfTwo[] = {
#include "blur_table_2.inc"
};
constexpr uint8_t kTableOfFour[] = {
#include "blur_table_4.inc"
};
static_assert(sizeof(kTableOfFour) == kTableSize * kTableSize * kTableSize);

// One buffer is bilinear reprojection: (11) solved for alpha.
uint8_t alphaOfOne(double variance, double threshold, double vx, double vy) {
  const double spread = 0.5 * (vx * (1.0 - vx) + vy * (1.0 - vy));
  const double room = threshold - variance;
  if (spread <= 0.0) return 1;
  return static_cast<uint8_t>(
      std::clamp(std::ceil(spread / (spread + std::max(room, 0.0)) * 255.0), 1.0, 255.0));
}

}  // namespace

BlurSlice blurSlice(uint32_t buffers, double threshold_px2) {
  const BufferLayout layout = bufferLayout(buffers);
  const double variance = static_cast<double>(layout.sigma_px) * layout.sigma_px;
  BlurSlice slice{};
  const double at = (kTableSize - 1) *
                    std::sqrt(std::clamp((threshold_px2 - variance) / kWidestBlur_px2, 0.0, 1.0));
  const auto low = std::min(static_cast<uint32_t>(at), kTableSize - 2);
  const double share = at - low;
  const uint8_t* table = buffers == 2 ? kTableOfTwo : kTableOfFour;
  for (uint32_t i = 0; i < slice.size(); ++i) {
    if (buffers == 1) {
      slice[i] = alphaOfOne(variance, threshold_px2, (i % kTableSize) / double{kTableSize - 1},
                            (i / kTableSize) / double{kTableSize - 1});
      continue;
    }
    const double a = table[low * slice.size() + i];
    const double b = table[(low + 1) * slice.size() + i];
    slice[i] = static_cast<uint8_t>(std::ceil(a + (b - a) * share - 1.0e-9));
  }
  return slice;
}

}  // namespace reprise::amortized
