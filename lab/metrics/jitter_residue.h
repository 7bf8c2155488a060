// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lab/float_image.h"

namespace reprise::lab {

// A window of this many frames holds whole periods of the usual jitter sequences (8, 16, 32); below
// the least there is none.
constexpr size_t kResidueFrames = 64;
constexpr size_t kLeastResidueFrames = 8;
// Where flicker is seen best.
constexpr double kEyeBandFrom_hz = 4.0;
constexpr double kEyeBandTo_hz = 15.0;

// What keeps changing in a view that stands still: the jitter that a technique lets through. Luma
// of display values, test minus reference; equal to the test's own changes where the reference
// stands still too.
struct JitterResidue {
  uint32_t frames = 0;
  uint64_t pixels = 0;
  double sigma_mean = 0.0;  // over pixels, of the deviation over time
  double sigma_p99 = 0.0;
  double peak_mean = 0.0;  // of largest minus smallest over time
  double peak_p99 = 0.0;
  double eye_band_rms = 0.0;  // over pixels, of what lies between 4 and 15 Hz
  double strongest_hz = 0.0;  // where the mean power over pixels is largest; 0 without any change
};

// `differences`: test - reference, a frame each, one channel, of one shape. `at_rest`: pixels that
// count, not 0. Works on all threads. nullopt for fewer than kLeastResidueFrames or no pixel.
std::optional<JitterResidue> jitterResidue(const std::vector<FloatImage>& differences,
                                           const std::vector<uint8_t>& at_rest, double frame_rate);

}  // namespace reprise::lab
