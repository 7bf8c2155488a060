// SPDX-License-Identifier: MIT
#include "lab/paper/crop.h"

#include <algorithm>
#include <cmath>

namespace reprise::lab {

FloatImage crop(const FloatImage& image, const CropBox& box) {
  FloatImage part(box.width, box.height, image.channels);
  for (uint32_t y = 0; y < box.height; ++y) {
    std::copy_n(image.at(box.x, box.y + y), size_t{box.width} * image.channels, part.at(0, y));
  }
  return part;
}

CropBox worstSquare(const FloatImage& reference, const FloatImage& test, uint32_t side_px) {
  CropBox best{0, 0, std::min(side_px, reference.width), std::min(side_px, reference.height)};
  double worst = -1.0;
  // Half overlapping squares: the worst one need not be found to the pixel.
  const uint32_t step = std::max(side_px / 2, 1u);
  for (uint32_t y = 0; y + best.height <= reference.height; y += step) {
    for (uint32_t x = 0; x + best.width <= reference.width; x += step) {
      double sum = 0.0;
      for (uint32_t v = 0; v < best.height; ++v) {
        const float* a = reference.at(x, y + v);
        const float* b = test.at(x, y + v);
        for (uint32_t i = 0; i < best.width * reference.channels; ++i) {
          sum += double{a[i] - b[i]} * double{a[i] - b[i]};
        }
      }
      if (sum <= worst) continue;
      worst = sum;
      best.x = x;
      best.y = y;
    }
  }
  return best;
}

FloatImage differenceImage(const FloatImage& a, const FloatImage& b, float gain) {
  FloatImage difference = a;
  for (size_t i = 0; i < difference.texels.size(); ++i) {
    difference.texels[i] = std::min(gain * std::abs(a.texels[i] - b.texels[i]), 1.0f);
  }
  return difference;
}

}  // namespace reprise::lab
