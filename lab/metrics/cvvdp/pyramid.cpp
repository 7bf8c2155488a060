// SPDX-License-Identifier: MIT
#include "lab/metrics/cvvdp/pyramid.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace reprise::lab {
namespace {

constexpr std::array<float, 5> kKernel = {0.05f, 0.25f, 0.4f, 0.25f, 0.05f};
constexpr int kBlurRadius = 6;
constexpr double kBlurSigma_px = 3.0;

// A line of texels: `count` of them, `step` apart.
struct Line {
  const float* texels;
  size_t step;
  uint32_t count;

  float operator[](uint32_t i) const { return texels[i * step]; }
};

// `odd` says how the last texel's edge is treated; not always by the line's own count.
void reduceLine(const Line& in, bool odd, float* out, size_t out_step) {
  const uint32_t n = in.count;
  const uint32_t half = (n + 1) / 2;
  for (uint32_t i = 0; i < half; ++i) {
    float sum = 0.0f;
    for (uint32_t k = 0; k < 5; ++k) {
      // Zeros outside: below 0 wraps around to more than n.
      const uint32_t at = 2 * i + k - 2;
      if (at < n) sum += kKernel[k] * in[at];
    }
    out[i * out_step] = sum;
  }
  out[0] += in[0] * kKernel[1] + in[1] * kKernel[0];
  float& last = out[(half - 1) * out_step];
  last += odd ? in[n - 1] * kKernel[3] + in[n - 2] * kKernel[4] : in[n - 1] * kKernel[4];
}

void expandLine(const Line& in, uint32_t n, std::vector<float>& spread, float* out,
                size_t out_step) {
  spread.assign(n + 4, 0.0f);
  for (uint32_t i = 0; i < in.count; ++i) spread[2 + 2 * i] = in[i];
  spread[0] = in[0];
  spread[n + 2 + n % 2] = in[in.count - 1];
  for (uint32_t i = 0; i < n; ++i) {
    float sum = 0.0f;
    for (uint32_t k = 0; k < 5; ++k) sum += kKernel[k] * spread[i + k];
    out[i * out_step] = 2.0f * sum;
  }
}

std::array<float, 2 * kBlurRadius + 1> blurTaps() {
  std::array<float, 2 * kBlurRadius + 1> taps{};
  double sum = 0.0;
  for (int i = -kBlurRadius; i <= kBlurRadius; ++i) {
    sum += std::exp(-0.5 * i * i / (kBlurSigma_px * kBlurSigma_px));
  }
  for (int i = -kBlurRadius; i <= kBlurRadius; ++i) {
    taps[static_cast<size_t>(i + kBlurRadius)] =
        static_cast<float>(std::exp(-0.5 * i * i / (kBlurSigma_px * kBlurSigma_px)) / sum);
  }
  return taps;
}

// The edge texel itself is not repeated.
uint32_t reflected(int i, uint32_t count) {
  const int last = static_cast<int>(count) - 1;
  return static_cast<uint32_t>(last - std::abs(last - std::abs(i)));
}

}  // namespace

FloatImage reduced(const FloatImage& image) {
  const bool odd_rows = image.height % 2 != 0;
  FloatImage rows(image.width, (image.height + 1) / 2, 1);
  for (uint32_t x = 0; x < image.width; ++x) {
    reduceLine({image.at(x, 0), image.width, image.height}, odd_rows, rows.at(x, 0), rows.width);
  }
  FloatImage result((image.width + 1) / 2, rows.height, 1);
  for (uint32_t y = 0; y < rows.height; ++y) {
    reduceLine({rows.at(0, y), 1, image.width}, odd_rows, result.at(0, y), 1);
  }
  return result;
}

FloatImage expanded(const FloatImage& image, uint32_t width, uint32_t height) {
  std::vector<float> spread;
  FloatImage rows(image.width, height, 1);
  for (uint32_t x = 0; x < image.width; ++x) {
    expandLine({image.at(x, 0), image.width, image.height}, height, spread, rows.at(x, 0),
               rows.width);
  }
  FloatImage result(width, height, 1);
  for (uint32_t y = 0; y < height; ++y) {
    expandLine({rows.at(0, y), 1, image.width}, width, spread, result.at(0, y), 1);
  }
  return result;
}

FloatImage maskingBlur(const FloatImage& image) {
  static const auto kTaps = blurTaps();
  FloatImage across(image.width, image.height, 1);
  FloatImage result(image.width, image.height, 1);
  std::vector<float> line(image.width + 2 * kBlurRadius);
  for (uint32_t y = 0; y < image.height; ++y) {
    for (size_t i = 0; i < line.size(); ++i) {
      line[i] = *image.at(reflected(static_cast<int>(i) - kBlurRadius, image.width), y);
    }
    float* to = across.at(0, y);
    for (size_t k = 0; k < kTaps.size(); ++k) {
      for (uint32_t x = 0; x < image.width; ++x) to[x] += kTaps[k] * line[x + k];
    }
  }
  for (uint32_t y = 0; y < image.height; ++y) {
    float* to = result.at(0, y);
    for (size_t k = 0; k < kTaps.size(); ++k) {
      const int from_y = static_cast<int>(y + k) - kBlurRadius;
      const float* from = across.at(0, reflected(from_y, image.height));
      for (uint32_t x = 0; x < image.width; ++x) to[x] += kTaps[k] * from[x];
    }
  }
  return result;
}

}  // namespace reprise::lab
