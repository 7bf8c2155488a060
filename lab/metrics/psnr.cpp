// SPDX-License-Identifier: MIT
#include "lab/metrics/psnr.h"

#include <algorithm>
#include <cmath>

namespace reprise::lab {

double meanSquaredError(const FloatImage& reference, const FloatImage& test) {
  double sum = 0.0;
  for (size_t i = 0; i < reference.texels.size(); ++i) {
    const double d = double{test.texels[i]} - double{reference.texels[i]};
    sum += d * d;
  }
  return sum / static_cast<double>(std::max<size_t>(reference.texels.size(), 1));
}

double psnrDb(double mean_squared_error) {
  if (mean_squared_error <= 0.0) return kMaxPsnr_db;
  return std::min(kMaxPsnr_db, -10.0 * std::log10(mean_squared_error));
}

double withoutNoise(double squared_error, double noise) {
  constexpr double kLeastShare = 0.02;
  return std::max(squared_error - noise, kLeastShare * squared_error);
}

double temporalSquaredError(const FloatImage& reference, const FloatImage& previous_reference,
                            const FloatImage& test, const FloatImage& previous_test) {
  double sum = 0.0;
  for (size_t i = 0; i < reference.texels.size(); ++i) {
    const double test_step = double{test.texels[i]} - double{previous_test.texels[i]};
    const double reference_step =
        double{reference.texels[i]} - double{previous_reference.texels[i]};
    sum += (test_step - reference_step) * (test_step - reference_step);
  }
  return sum / static_cast<double>(std::max<size_t>(reference.texels.size(), 1));
}

}  // namespace reprise::lab
