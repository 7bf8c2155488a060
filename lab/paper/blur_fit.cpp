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

// Weights of the fine texels from `first` on for one output pixel.
struct Taps {
  size_t first = 0;
  std::vector<float> weights;
};

Taps tapsAbout(double center, double deviation, size_t count) {
  Taps taps;
  const double sigma = std::max(deviation, kNarrowest);
  const double reach = std::max(kReach * sigma, 1.0);
  const auto low = static_cast<long>(std::ceil(center - reach - 0.5));
  const auto high = static_cast<long>(std::floor(center + reach - 0.5));
  double sum = 0.0;
  std::vector<double> weights;
  for (long i = low; i <= high; ++i) {
    const double d = (static_cast<double>(i) + 0.5 - center) / sigma;
    weights.push_back(std::exp(-0.5 * d * d));
    sum += weights.back();
  }
  taps.first = static_cast<size_t>(std::clamp<long>(low, 0, static_cast<long>(count) - 1));
  for (double weight : weights) taps.weights.push_back(static_cast<float>(weight / sum));
  return taps;
}

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

// At the border the nearest texel stands for those outside: only what lies a reach inside counts.
FloatImage throughGaussian(const FloatImage& image, double sigma_px) {
  const auto reach = static_cast<int>(std::ceil(kReach * sigma_px));
  std::vector<float> weights;
  float sum = 0.0f;
  for (int i = -reach; i <= reach; ++i) {
    weights.push_back(static_cast<float>(std::exp(-0.5 * i * i / (sigma_px * sigma_px))));
    sum += weights.back();
  }
  const auto pass = [&](const FloatImage& from, bool across) {
    FloatImage to(from.width, from.height, 1);
    const int last = static_cast<int>(across ? from.width : from.height) - 1;
    for (uint32_t y = 0; y < from.height; ++y) {
      for (uint32_t x = 0; x < from.width; ++x) {
        for (int i = -reach; i <= reach; ++i) {
          const int at = std::clamp(static_cast<int>(across ? x : y) + i, 0, last);
          const auto place = static_cast<uint32_t>(at);
          *to.at(x, y) += weights[static_cast<size_t>(i + reach)] / sum *
                          (across ? *from.at(place, y) : *from.at(x, place));
        }
      }
    }
    return to;
  };
  return pass(pass(image, true), false);
}

}  // namespace

BlurFit::BlurFit(FloatImage fine, uint32_t scale, uint32_t margin_px)
    : fine_(std::move(fine)), scale_(scale), margin_px_(margin_px) {
  if (margin_px < kWidestKernel_px || fine_.width <= 2 * margin_px * scale ||
      fine_.height <= 2 * margin_px * scale) {
    throw std::invalid_argument("a blur fit needs a margin of its widest kernel, and an inside");
  }
}

FloatImage BlurFit::blurred(double sigma_px, double shift_x_px, double shift_y_px) const {
  const uint32_t width = fine_.width / scale_ - 2 * margin_px_;
  const uint32_t height = fine_.height / scale_ - 2 * margin_px_;
  const double scale = scale_;
  const auto tapsOf = [&](uint32_t px, double shift_px, uint32_t count) {
    return tapsAbout((px + margin_px_ + 0.5 + shift_px) * scale, sigma_px * scale, count);
  };
  std::vector<Taps> columns;
  for (uint32_t x = 0; x < width; ++x) columns.push_back(tapsOf(x, shift_x_px, fine_.width));
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
  FloatImage blurred(width, height, 1);
  for (uint32_t y = 0; y < height; ++y) {
    const Taps taps = tapsOf(y, shift_y_px, fine_.height);
    for (size_t k = 0; k < taps.weights.size(); ++k) {
      const float* row = rows.at(0, static_cast<uint32_t>(taps.first + k));
      for (uint32_t x = 0; x < width; ++x) *blurred.at(x, y) += taps.weights[k] * row[x];
    }
  }
  return blurred;
}

double BlurFit::error(const FloatImage& image, double sigma_px, double shift_x_px,
                      double shift_y_px) const {
  const FloatImage candidate = blurred(sigma_px, shift_x_px, shift_y_px);
  double sum = 0.0;
  for (uint32_t y = 0; y < candidate.height; ++y) {
    for (uint32_t x = 0; x < candidate.width; ++x) {
      const double d = *candidate.at(x, y) - *image.at(x + margin_px_, y + margin_px_);
      sum += d * d;
    }
  }
  return sum / static_cast<double>(candidate.texelCount());
}

BlurMatch BlurFit::bestSigma(const FloatImage& image, double detail_px) const {
  if (detail_px > kLargestDetail_px) throw std::invalid_argument("the margin is made for less");
  const FloatImage seen = detail_px > 0.0 ? throughGaussian(image, detail_px) : image;
  const auto errorAt = [&](double sigma_px) {
    return error(seen, std::hypot(sigma_px, detail_px), 0.0, 0.0);
  };
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
