// SPDX-License-Identifier: MIT
#include "lab/metrics/ssim.h"

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace reprise::lab {
namespace {

constexpr uint32_t kTaps = 11;
constexpr double kSigma_px = 1.5;
constexpr double kC1 = 0.01 * 0.01;
constexpr double kC2 = 0.03 * 0.03;

std::array<double, kTaps> window() {
  std::array<double, kTaps> weights{};
  double sum = 0.0;
  for (uint32_t i = 0; i < kTaps; ++i) {
    const double x = static_cast<double>(i) - (kTaps - 1) / 2;
    weights[i] = std::exp(-0.5 * x * x / (kSigma_px * kSigma_px));
    sum += weights[i];
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

// Means over every window that lies inside: (width - 10) x (height - 10).
template <typename Value>
std::vector<double> windowMeans(uint32_t width, uint32_t height, const Value& value) {
  static const std::array<double, kTaps> weights = window();
  const uint32_t columns = width - kTaps + 1;
  const uint32_t rows = height - kTaps + 1;
  std::vector<double> across(size_t{columns} * height);
  std::vector<double> line(width);
  for (uint32_t y = 0; y < height; ++y) {
    for (uint32_t x = 0; x < width; ++x) line[x] = value(size_t{y} * width + x);
    for (uint32_t x = 0; x < columns; ++x) {
      double sum = 0.0;
      for (uint32_t k = 0; k < kTaps; ++k) sum += weights[k] * line[x + k];
      across[size_t{y} * columns + x] = sum;
    }
  }
  std::vector<double> means(size_t{columns} * rows, 0.0);
  for (uint32_t y = 0; y < rows; ++y) {
    for (uint32_t k = 0; k < kTaps; ++k) {
      const double* from = &across[size_t{y + k} * columns];
      double* to = &means[size_t{y} * columns];
      for (uint32_t x = 0; x < columns; ++x) to[x] += weights[k] * from[x];
    }
  }
  return means;
}

}  // namespace

double ssim(const FloatImage& reference_luma, const FloatImage& test_luma) {
  const uint32_t w = reference_luma.width;
  const uint32_t h = reference_luma.height;
  if (w < kTaps || h < kTaps) return std::numeric_limits<double>::quiet_NaN();
  const auto r = [&](size_t i) { return double{reference_luma.texels[i]}; };
  const auto t = [&](size_t i) { return double{test_luma.texels[i]}; };
  const std::vector<double> mean_r = windowMeans(w, h, r);
  const std::vector<double> mean_t = windowMeans(w, h, t);
  const std::vector<double> mean_rr = windowMeans(w, h, [&](size_t i) { return r(i) * r(i); });
  const std::vector<double> mean_tt = windowMeans(w, h, [&](size_t i) { return t(i) * t(i); });
  const std::vector<double> mean_rt = windowMeans(w, h, [&](size_t i) { return r(i) * t(i); });
  double sum = 0.0;
  for (size_t i = 0; i < mean_r.size(); ++i) {
    const double a = mean_r[i];
    const double b = mean_t[i];
    const double variance_r = mean_rr[i] - a * a;
    const double variance_t = mean_tt[i] - b * b;
    const double covariance = mean_rt[i] - a * b;
    sum += ((2.0 * a * b + kC1) * (2.0 * covariance + kC2)) /
           ((a * a + b * b + kC1) * (variance_r + variance_t + kC2));
  }
  return sum / static_cast<double>(mean_r.size());
}

}  // namespace reprise::lab
