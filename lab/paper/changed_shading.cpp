// SPDX-License-Identifier: MIT
#include "lab/paper/changed_shading.h"

#include <algorithm>
#include <cmath>

namespace reprise::lab {
namespace {

// Of display luma, from one frame to the next: a tenth of the range is a change that is seen.
constexpr float kChange = 0.1f;

float luma(const float* rgb) {
  return 0.2126f * rgb[0] + 0.7152f * rgb[1] + 0.0722f * rgb[2];
}

}  // namespace

PixelMask changedShading(const FloatImage& reference, const FloatImage& previous,
                         const FloatImage& motion_px, const PixelMask& unseen) {
  PixelMask mask(reference.texelCount());
  for (uint32_t y = 0; y < reference.height; ++y) {
    for (uint32_t x = 0; x < reference.width; ++x) {
      const size_t i = size_t{y} * reference.width + x;
      const float* motion = motion_px.at(x, y);
      const float px = static_cast<float>(x) + motion[0];
      const float py = static_cast<float>(y) + motion[1];
      const bool inside = px >= 0.0f && py >= 0.0f &&
                          px <= static_cast<float>(reference.width - 1) &&
                          py <= static_cast<float>(reference.height - 1);
      if (!inside || unseen[i] > 0) continue;
      // The nearest of the four around: a texture under a fraction of a pixel is no change.
      float least = 1.0f;
      for (uint32_t corner = 0; corner < 4; ++corner) {
        const uint32_t cx = std::min(static_cast<uint32_t>(px) + (corner & 1), reference.width - 1);
        const uint32_t cy =
            std::min(static_cast<uint32_t>(py) + (corner >> 1), reference.height - 1);
        least = std::min(least, std::abs(luma(reference.at(x, y)) - luma(previous.at(cx, cy))));
      }
      mask[i] = least > kChange ? 1 : 0;
    }
  }
  return mask;
}

}  // namespace reprise::lab
