// SPDX-License-Identifier: MIT
#include "lab/metrics/sharpness.h"

#include <cmath>

namespace reprise::lab {
namespace {

double gradientSum(const FloatImage& luma) {
  double sum = 0.0;
  for (uint32_t y = 0; y + 1 < luma.height; ++y) {
    const float* row = luma.at(0, y);
    const float* below = luma.at(0, y + 1);
    for (uint32_t x = 0; x + 1 < luma.width; ++x) {
      sum += std::hypot(row[x + 1] - row[x], below[x] - row[x]);
    }
  }
  return sum;
}

}  // namespace

double sharpness(const FloatImage& reference_luma, const FloatImage& test_luma) {
  const double reference = gradientSum(reference_luma);
  return reference > 0.0 ? gradientSum(test_luma) / reference : 1.0;
}

}  // namespace reprise::lab
