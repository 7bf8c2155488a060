// SPDX-License-Identifier: MIT
#pragma once

#include "lab/float_image.h"

namespace reprise::lab {

// What equal images are given instead of infinity.
constexpr double kMaxPsnr_db = 200.0;

// Over all texels and channels. Both images of one shape.
double meanSquaredError(const FloatImage& reference, const FloatImage& test);
// 10 log10(1 / mse): values in [0, 1].
double psnrDb(double mean_squared_error);
// A squared error against a reference that is itself off by `noise`, independently of the image:
// what is the image's own. An estimate, it stays above nothing.
double withoutNoise(double squared_error, double noise);
// Mean of ((test - previous test) - (reference - previous reference))^2: flicker, whatever moves,
// and no static bias. Its psnrDb is the "temporal-difference PSNR" of the reports.
double temporalSquaredError(const FloatImage& reference, const FloatImage& previous_reference,
                            const FloatImage& test, const FloatImage& previous_test);

}  // namespace reprise::lab
