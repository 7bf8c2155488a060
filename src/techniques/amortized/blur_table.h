// SPDX-License-Identifier: MIT
//
// alpha_tau_b(v): the smallest weight of a new sample in its buffer whose blur stays within a
// threshold at a fractional velocity (Yang et al. 2009, section 5.2), as a table over velocity and
// threshold. The build computes it (blur_table_generator.cpp) from blur_moments.h.
#pragma once

#include <array>
#include <cstdint>

namespace reprise::amortized {

constexpr uint32_t kTableSize = 64;  // a side; 64^3 after the paper
// Thresholds grow as the square of the index, since blur does as the inverse of alpha: entry j is
// for sample_variance + kWidestBlur_px2 * (j / 63)^2.
constexpr double kWidestBlur_px2 = 4.0;
// Smallest weight in the table. Steps of 1/255, rounded up: the threshold holds.
constexpr double kSmallestAlpha = 1.0 / 255.0;

constexpr double blurThreshold(uint32_t j, double sample_variance) {
  const double t = static_cast<double>(j) / (kTableSize - 1);
  return sample_variance + kWidestBlur_px2 * t * t;
}

// One threshold's slice: [vy * 64 + vx], velocity index / 63 in [0, 1] px a frame.
using BlurSlice = std::array<uint8_t, kTableSize * kTableSize>;

// Weights * 255 for `buffers` in {1, 2, 4} at a threshold in px^2, clamped to the table's range.
BlurSlice blurSlice(uint32_t buffers, double threshold_px2);

// What the table holds, computed here and now: a few milliseconds a velocity.
std::array<uint8_t, kTableSize> blurColumn(uint32_t buffers, double vx, double vy);

}  // namespace reprise::amortized
