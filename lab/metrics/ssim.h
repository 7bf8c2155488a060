// SPDX-License-Identifier: MIT
#pragma once

#include "lab/float_image.h"

namespace reprise::lab {

// Structural similarity of two one-channel images in [0, 1]: Wang et al. 2004 with an 11 x 11
// Gaussian window of 1.5 px, K1 = 0.01, K2 = 0.03, population covariance, mean over the windows
// that lie wholly inside. NaN where no window does (a side below 11 px). Equal to scikit-image's
// structural_similarity(gaussian_weights=True, sigma=1.5, use_sample_covariance=False,
// data_range=1).
double ssim(const FloatImage& reference_luma, const FloatImage& test_luma);

}  // namespace reprise::lab
