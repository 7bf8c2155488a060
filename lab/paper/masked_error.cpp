// SPDX-License-Identifier: MIT
#include "lab/paper/masked_error.h"

#include <algorithm>

#include "lab/metrics/psnr.h"

namespace reprise::lab {

size_t pixelsInside(const PixelMask& mask) {
  return mask.size() - static_cast<size_t>(std::count(mask.begin(), mask.end(), uint8_t{0}));
}

void MaskedError::add(const PixelMask& mask, const FloatImage& reference, const FloatImage& image) {
  for (size_t i = 0; i < mask.size(); ++i) {
    const size_t inside = mask[i] > 0 ? 1 : 0;
    for (size_t c = 0; c < 3; ++c) {
      const double d = double{image.texels[3 * i + c]} - double{reference.texels[3 * i + c]};
      sum_[inside] += d * d;
    }
    ++count_[inside];
  }
}

double MaskedError::psnr(size_t inside) const {
  return psnrDb(sum_[inside] / static_cast<double>(std::max<size_t>(3 * count_[inside], 1)));
}

double MaskedError::insideDb() const {
  return psnr(1);
}

double MaskedError::outsideDb() const {
  return psnr(0);
}

double MaskedError::shareInside() const {
  return static_cast<double>(count_[1]) /
         static_cast<double>(std::max<size_t>(count_[0] + count_[1], 1));
}

}  // namespace reprise::lab
