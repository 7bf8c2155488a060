// SPDX-License-Identifier: MIT
#pragma once

#include "lab/float_image.h"

namespace reprise::lab {

struct CropBox {
  uint32_t x = 0, y = 0, width = 0, height = 0;
};

// Per pixel, one channel: squared error summed over channels.
FloatImage squaredError(const FloatImage& reference, const FloatImage& test);
// The square of `side_px` (at most the image) with the largest sum of `weights`, one channel.
CropBox heaviestSquare(const FloatImage& weights, uint32_t side_px);
FloatImage crop(const FloatImage& image, const CropBox& box);
// The one in which `test` is farthest from `reference`.
CropBox worstSquare(const FloatImage& reference, const FloatImage& test, uint32_t side_px);
// `gain` |a - b|, RGB.
FloatImage differenceImage(const FloatImage& a, const FloatImage& b, float gain);

}  // namespace reprise::lab
