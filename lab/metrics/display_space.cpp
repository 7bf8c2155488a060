// SPDX-License-Identifier: MIT
#include "lab/metrics/display_space.h"

#include <cmath>

#include "equations/color_space.h"

namespace reprise::lab {
namespace {

template <typename Transform>
FloatImage rgbOf(const FloatImage& image, const Transform& transform) {
  FloatImage rgb(image.width, image.height, 3);
  for (size_t i = 0; i < rgb.texelCount(); ++i) {
    for (uint32_t c = 0; c < 3; ++c) {
      const float x = image.texels[i * image.channels + c];
      rgb.texels[3 * i + c] = std::isinf(x) && x > 0.0f ? 1.0f : transform(x > 0.0f ? x : 0.0f);
    }
  }
  return rgb;
}

}  // namespace

FloatImage displayImage(const FloatImage& linear) {
  return rgbOf(linear, [](float x) { return eq::displayFromLinear(x); });
}

FloatImage tonemappedImage(const FloatImage& linear) {
  return rgbOf(linear, [](float x) { return x / (1.0f + x); });
}

FloatImage lumaImage(const FloatImage& display) {
  FloatImage luma(display.width, display.height, 1);
  for (size_t i = 0; i < luma.texels.size(); ++i) {
    const float* rgb = &display.texels[display.channels * i];
    luma.texels[i] = 0.2126f * rgb[0] + 0.7152f * rgb[1] + 0.0722f * rgb[2];
  }
  return luma;
}

}  // namespace reprise::lab
