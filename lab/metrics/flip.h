// SPDX-License-Identifier: MIT
//
// FLIP, Andersson et al. 2020, for low and (2021) high dynamic range. Checked against figures of
// the authors' implementation in flip_test.cpp.
#pragma once

#include "lab/float_image.h"

namespace reprise::lab {

// Pixels per degree of a 0.7 m wide display of 3840 px seen from 0.7 m: the authors' default.
constexpr float kFlipPixelsPerDegree = 67.0206f;
// Of a display seen from closer by, where aliasing shows: see docs/metrics.md.
constexpr float kFlipNearPixelsPerDegree = 30.0f;

// Error a pixel in [0, 1], one channel. RGB images of one shape, linear light, clamped to [0, 1].
FloatImage flipErrorMap(const FloatImage& reference, const FloatImage& test,
                        float pixels_per_degree);
double meanOf(const FloatImage& one_channel);

enum class HdrTonemapper { kAces, kHable, kReinhard };

struct HdrFlip {
  FloatImage error;             // largest over the exposures
  float first_exposure = 0.0f;  // log2
  float last_exposure = 0.0f;
  uint32_t exposures = 0;
};
// Linear RGB of any range; the exposures come from the reference alone.
HdrFlip hdrFlip(const FloatImage& reference, const FloatImage& test, float pixels_per_degree,
                HdrTonemapper tonemapper = HdrTonemapper::kAces);

}  // namespace reprise::lab
