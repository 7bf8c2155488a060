// SPDX-License-Identifier: MIT
#include "lab/paper/blur_fit.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <vector>

namespace reprise::lab {
namespace {

// A Gaussian is cut where it has fallen to 0.2 % of its peak.
constexpr double kReach = 3.5;
// Of the fine texels: narrower kernels fall between them.
constexpr double kNarrowest = 0.25;

// Smallest value of a function with one valley in [low, high], by golden section.
double valley(double low, double high, double tolerance, const std::function<double(double)>& f) {
  const double ratio = 0.5 * (std::sqrt(5.0) - 1.0);
  double a = high - ratio * (high - low);
  double b = low + ratio * (high - low);
  double at_a = f(a);
  double at_b = f(b);
  while (high - low > tolerance) {
    if (at_a < at_b) {
      high = b;
      b = a;
      at_b = at_a;
      a = high - ratio * (high - low);
      at_a = f(a);
    } else {
      low = a;
      a = b;
      at_a = at_b;
      b = low + ratio * (high - low);
      at_b = f(b);
    }
  }
  return 0.5 * (low + high);
}

constexpr double kTolerance_px = 2.0e-3;

}  // namespace

BlurFit::BlurFit(FloatImage fine, uint32_t scale, uint32_t margin_px)
    : fine_(std::move(fine)), scale_(scale), margin_px_(margin_px) {
  if (margin_px < kWidestKernel_px || fine_.width <= 2 * margin_px * scale ||
      fine_.height <= 2 * margin_px * scale) {
    throw std::invalid_argument("a blur fit needs a margin of its widest kernel, and an inside");
  }
}

BlurFit::Taps BlurFit::tapsOf(uint32_t px, double sigma_px,
                              const std::vector<Displacement>& displacements,
                              uint32_t fine_count) const {
  const double sigma = std::max(sigma_px * scale_, kNarrowest);
  const double reach = std::max(kReach * sigma, 1.0);
  const auto centerOf = [&](const Displacement& d) {
    return (px + margin_px_ + 0.5 + d.px) * scale_;
  };
  double low = centerOf(displacements.front());
  double high = low;
  for (const Displacement& d : displacements) {
    low = std::min(low, centerOf(d));
    high = std::max(high, centerOf(d));
  }
  Taps taps;
  // Beyond the image there is nothing; the margin keeps that to the far tails.
  taps.first = std::max(static_cast<long>(std::ceil(low - reach - 0.5)), 0L);
  const long last = std::min(static_cast<long>(std::floor(high + reach - 0.5)),
                             static_cast<long>(fine_count) - 1);
  taps.weights.resize(static_cast<size_t>(last - taps.first + 1));
  double sum = 0.0;
  for (const Displacement& d : displacements) {
    const double center = centerOf(d);
    const long from = std::max(static_cast<long>(std::ceil(center - reach - 0.5)), taps.first);
    const long to = std::min(static_cast<long>(std::floor(center + reach - 0.5)), last);
    for (long i = from; i <= to; ++i) {
      const double z = (static_cast<double>(i) + 0.5 - center) / sigma;
      const double weight = d.weight * std::exp(-0.5 * z * z);
      taps.weights[static_cast<size_t>(i - taps.first)] += static_cast<float>(weight);
      sum += weight;
    }
  }
  for (float& weight : taps.weights) weight = static_cast<float>(weight / sum);
  return taps;
}

FloatImage BlurFit::blurred(double sigma_px, double shift_x_px, double shift_y_px) const {
  return spread(sigma_px, {{shift_x_px, 1.0}}, {{shift_y_px, 1.0}});
}

FloatImage BlurFit::spread(double sigma_px, const std::vector<Displacement>& along_x,
                           const std::vector<Displacement>& along_y) const {
  const uint32_t width = fine_.width / scale_ - 2 * margin_px_;
  const uint32_t height = fine_.height / scale_ - 2 * margin_px_;
  std::vector<Taps> columns;
  for (uint32_t x = 0; x < width; ++x) {
    columns.push_back(tapsOf(x, sigma_px, along_x, fine_.width));
  }
  // Rows of the fine image through the horizontal kernel, then the vertical kernel over them.
  FloatImage rows(width, fine_.height, 1);
  for (uint32_t y = 0; y < fine_.height; ++y) {
    for (uint32_t x = 0; x < width; ++x) {
      const float* texel = fine_.at(static_cast<uint32_t>(columns[x].first), y);
      float sum = 0.0f;
      for (const float weight : columns[x].weights) sum += weight * *texel++;
      *rows.at(x, y) = sum;
    }
  }
  FloatImage image(width, height, 1);
  for (uint32_t y = 0; y < height; ++y) {
    const Taps taps = tapsOf(y, sigma_px, along_y, fine_.height);
    for (size_t k = 0; k < taps.weights.size(); ++k) {
      const float* row = rows.at(0, static_cast<uint32_t>(taps.first) + static_cast<uint32_t>(k));
      for (uint32_t x = 0; x < width; ++x) *image.at(x, y) += taps.weights[k] * row[x];
    }
  }
  return image;
}

double BlurFit::error(const FloatImage& image, double sigma_px, double shift_x_px,
                      double shift_y_px) const {
  const FloatImage candidate = blurred(sigma_px, shift_x_px, shift_y_px);
  // A whole image, or its inside alone as blurred() makes it.
  const uint32_t border_px = image.width == candidate.width ? 0 : margin_px_;
  double sum = 0.0;
  for (uint32_t y = 0; y < candidate.height; ++y) {
    for (uint32_t x = 0; x < candidate.width; ++x) {
      const double d = *candidate.at(x, y) - *image.at(x + border_px, y + border_px);
      sum += d * d;
    }
  }
  return sum / static_cast<double>(candidate.texelCount());
}

BlurMatch BlurFit::bestSigma(const FloatImage& image) const {
  const auto errorAt = [&](double sigma_px) { return error(image, sigma_px, 0.0, 0.0); };
  BlurMatch match;
  match.sigma_px = valley(0.0, kLargestSigma_px, kTolerance_px, errorAt);
  match.mean_squared_error = errorAt(match.sigma_px);
  return match;
}

BlurMatch BlurFit::bestShift(const FloatImage& image) const {
  // One unknown after the other; they hardly depend on each other, so that a few rounds settle.
  constexpr int kRounds = 3;
  BlurMatch match = bestSigma(image);
  for (int round = 0; round < kRounds; ++round) {
    match.shift_x_px = valley(-kLargestShift_px, kLargestShift_px, kTolerance_px, [&](double x) {
      return error(image, match.sigma_px, x, match.shift_y_px);
    });
    match.shift_y_px = valley(-kLargestShift_px, kLargestShift_px, kTolerance_px, [&](double y) {
      return error(image, match.sigma_px, match.shift_x_px, y);
    });
    match.sigma_px = valley(0.0, kLargestSigma_px, kTolerance_px, [&](double sigma_px) {
      return error(image, sigma_px, match.shift_x_px, match.shift_y_px);
    });
  }
  match.mean_squared_error = error(image, match.sigma_px, match.shift_x_px, match.shift_y_px);
  return match;
}

}  // namespace reprise::lab
