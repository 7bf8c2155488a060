// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "lab/float_image.h"

namespace reprise::lab {

// One value a pixel; what is above 0 is inside.
using PixelMask = std::vector<uint8_t>;

size_t pixelsInside(const PixelMask& mask);

// Squared error over many frames, apart for the pixels inside a mask and the others.
class MaskedError {
 public:
  // Display values, RGB.
  void add(const PixelMask& mask, const FloatImage& reference, const FloatImage& image);

  // dB over all pixels added; kMaxPsnr_db where there is none.
  double insideDb() const;
  double outsideDb() const;
  size_t pixelsInside() const { return count_[1]; }
  // Of all pixels, [0, 1].
  double shareInside() const;

 private:
  double psnr(size_t inside) const;
  double sum_[2] = {0.0, 0.0};
  size_t count_[2] = {0, 0};
};

}  // namespace reprise::lab
