// SPDX-License-Identifier: MIT
#include "lab/paper/crop.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace reprise::lab {

FloatImage crop(const FloatImage& image, const CropBox& box) {
  FloatImage part(box.width, box.height, image.channels);
  for (uint32_t y = 0; y < box.height; ++y) {
    std::copy_n(image.at(box.x, box.y + y), size_t{box.width} * image.channels, part.at(0, y));
  }
  return part;
}

FloatImage squaredError(const FloatImage& reference, const FloatImage& test) {
  FloatImage error(reference.width, reference.height, 1);
  for (size_t i = 0; i < reference.texels.size(); ++i) {
    const float difference = reference.texels[i] - test.texels[i];
    error.texels[i / reference.channels] += difference * difference;
  }
  return error;
}

CropBox heaviestSquare(const FloatImage& weights, uint32_t side_px) {
  CropBox best{0, 0, std::min(side_px, weights.width), std::min(side_px, weights.height)};
  double heaviest = -1.0;
  // Half overlapping squares: the heaviest one need not be found to the pixel.
  const uint32_t step = std::max(side_px / 2, 1u);
  for (uint32_t y = 0; y + best.height <= weights.height; y += step) {
    for (uint32_t x = 0; x + best.width <= weights.width; x += step) {
      double sum = 0.0;
      for (uint32_t v = 0; v < best.height; ++v) {
        const float* row = weights.at(x, y + v);
        sum = std::accumulate(row, row + best.width, sum);
      }
      if (sum <= heaviest) continue;
      heaviest = sum;
      best.x = x;
      best.y = y;
    }
  }
  return best;
}

CropBox worstSquare(const FloatImage& reference, const FloatImage& test, uint32_t side_px) {
  return heaviestSquare(squaredError(reference, test), side_px);
}

FloatImage differenceImage(const FloatImage& a, const FloatImage& b, float gain) {
  FloatImage difference = a;
  for (size_t i = 0; i < difference.texels.size(); ++i) {
    difference.texels[i] = std::min(gain * std::abs(a.texels[i] - b.texels[i]), 1.0f);
  }
  return difference;
}

}  // namespace reprise::lab
