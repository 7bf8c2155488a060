// SPDX-License-Identifier: MIT
#include "lab/metrics/warped_flicker.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace reprise::lab {
namespace {

// The four texels around a position and their bilinear weights, edge texels repeated outside.
struct BilinearTaps {
  size_t texels[4];
  float weights[4];

  BilinearTaps(const FloatImage& image, float x_px, float y_px) {
    const float x = std::floor(x_px - 0.5f);
    const float y = std::floor(y_px - 0.5f);
    const float fx = x_px - 0.5f - x;
    const float fy = y_px - 0.5f - y;
    for (int k = 0; k < 4; ++k) {
      const int tx = std::clamp(static_cast<int>(x) + k % 2, 0, static_cast<int>(image.width) - 1);
      const int ty = std::clamp(static_cast<int>(y) + k / 2, 0, static_cast<int>(image.height) - 1);
      texels[k] = static_cast<size_t>(ty) * image.width + static_cast<size_t>(tx);
      weights[k] = (k % 2 != 0 ? fx : 1.0f - fx) * (k / 2 != 0 ? fy : 1.0f - fy);
    }
  }

  float of(const FloatImage& luma) const {
    float sum = 0.0f;
    for (int k = 0; k < 4; ++k) sum += weights[k] * luma.texels[texels[k]];
    return sum;
  }
};

}  // namespace

double warpedFlicker(const LumaStep& reference, const LumaStep& test, const FloatImage& motion_px,
                     const Ages& ages) {
  double sum = 0.0;
  uint64_t pixels = 0;
  const uint32_t width = reference.now.width;
  for (size_t i = 0; i < ages.size(); ++i) {
    if (!hasPreviousSurface(ages[i])) continue;
    ++pixels;
    const BilinearTaps taps(reference.now,
                            static_cast<float>(i % width) + 0.5f + motion_px.texels[2 * i],
                            static_cast<float>(i / width) + 0.5f + motion_px.texels[2 * i + 1]);
    const float excess = std::abs(test.now.texels[i] - taps.of(test.before)) -
                         std::abs(reference.now.texels[i] - taps.of(reference.before));
    if (excess > kJustNoticeableLuma) sum += excess;
  }
  return pixels == 0 ? std::numeric_limits<double>::quiet_NaN() : sum / static_cast<double>(pixels);
}

}  // namespace reprise::lab
