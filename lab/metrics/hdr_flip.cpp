// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "lab/metrics/flip.h"

namespace reprise::lab {
namespace {

// (k0 x^2 + k1 x + k2) / (k3 x^2 + k4 x + k5)
using Tonemap = std::array<double, 6>;

constexpr Tonemap kAces{0.36 * 2.51, 0.6 * 0.03, 0.0, 0.36 * 2.43, 0.6 * 0.59, 0.14};
constexpr Tonemap kHable{0.231683, 0.013791, 0.0, 0.18, 0.3, 0.018};
constexpr Tonemap kReinhard{0.0, 1.0, 0.0, 0.0, 1.0, 1.0};

// The exposure range starts where the brightest pixel reaches this value.
constexpr double kExposureTarget = 0.85;

const Tonemap& coefficients(HdrTonemapper tonemapper) {
  switch (tonemapper) {
    case HdrTonemapper::kHable:
      return kHable;
    case HdrTonemapper::kReinhard:
      return kReinhard;
    default:
      return kAces;
  }
}

double apply(const Tonemap& k, double x) {
  return (k[0] * x * x + k[1] * x + k[2]) / (k[3] * x * x + k[4] * x + k[5]);
}

double inverseAtTarget(const Tonemap& k) {
  const double a = k[0] - kExposureTarget * k[3];
  const double b = k[1] - kExposureTarget * k[4];
  const double c = k[2] - kExposureTarget * k[5];
  if (a == 0.0) return -c / b;
  const double root = std::sqrt(std::max(0.0, b * b - 4.0 * a * c));
  return std::max((-b + root) / (2.0 * a), (-b - root) / (2.0 * a));
}

double luminance(const float* rgb) {
  return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
}

FloatImage exposed(const FloatImage& image, double scale, HdrTonemapper tonemapper) {
  const Tonemap& k = coefficients(tonemapper);
  FloatImage out(image.width, image.height, 3);
  for (size_t i = 0; i < image.texelCount(); ++i) {
    const float* rgb = &image.texels[image.channels * i];
    // Reinhard's operator works on luminance, the others a channel.
    const double y = scale * luminance(rgb);
    for (size_t c = 0; c < 3; ++c) {
      const double x = scale * rgb[c];
      const double value = tonemapper == HdrTonemapper::kReinhard ? x / (1.0 + y) : apply(k, x);
      out.texels[3 * i + c] = static_cast<float>(std::clamp(value, 0.0, 1.0));
    }
  }
  return out;
}

}  // namespace

HdrFlip hdrFlip(const FloatImage& reference, const FloatImage& test, float pixels_per_degree,
                HdrTonemapper tonemapper) {
  std::vector<double> luminances(reference.texelCount());
  for (size_t i = 0; i < luminances.size(); ++i) {
    luminances[i] = std::max(1.0e-8, luminance(&reference.texels[reference.channels * i]));
  }
  std::sort(luminances.begin(), luminances.end());
  const double target = inverseAtTarget(coefficients(tonemapper));
  const double start = std::log2(target / luminances.back());
  const double stop = std::log2(target / luminances[luminances.size() / 2]);
  HdrFlip result;
  result.exposures = static_cast<uint32_t>(std::max(2.0, std::ceil(stop - start)));
  result.first_exposure = static_cast<float>(start);
  result.last_exposure = static_cast<float>(stop);
  result.error = FloatImage(reference.width, reference.height, 1);
  for (uint32_t i = 0; i < result.exposures; ++i) {
    const double exponent = start + i * (stop - start) / (result.exposures - 1);
    const double scale = std::exp2(exponent);
    const FloatImage error = flipErrorMap(exposed(reference, scale, tonemapper),
                                          exposed(test, scale, tonemapper), pixels_per_degree);
    for (size_t k = 0; k < error.texels.size(); ++k) {
      result.error.texels[k] = std::max(result.error.texels[k], error.texels[k]);
    }
  }
  return result;
}

}  // namespace reprise::lab
