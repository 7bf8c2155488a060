// SPDX-License-Identifier: MIT
#pragma once

#include "lab/float_image.h"

namespace reprise::lab {

// Sum of |gradient| of the test over that of the reference, one-channel luma, forward differences:
// 1 is as sharp as the reference, below it blurred, above it sharpened or noisy. 1 for flat
// references.
double sharpness(const FloatImage& reference_luma, const FloatImage& test_luma);

}  // namespace reprise::lab
