// SPDX-License-Identifier: MIT
#include "lab/metrics/magma.h"

#include <algorithm>

namespace reprise::lab {
namespace {

// Least-squares fit of c0 + c1 t + ... + c6 t^6 to the 256 colours of matplotlib's "magma" (CC0).
constexpr float kCoefficients[3][7] = {
    {-0.002067f, 0.250486f, 8.345901f, -27.666969f, 52.170684f, -50.758572f, 18.664253f},
    {-0.000688f, 0.694455f, -3.596031f, 14.253853f, -27.944584f, 29.053880f, -11.490027f},
    {-0.009548f, 2.495287f, 0.329057f, -13.646583f, 12.881091f, 4.269936f, -5.570769f},
};

}  // namespace

FloatImage magmaImage(const FloatImage& error) {
  FloatImage image(error.width, error.height, 3);
  for (size_t i = 0; i < error.texels.size(); ++i) {
    const float t = std::clamp(error.texels[i], 0.0f, 1.0f);
    for (size_t c = 0; c < 3; ++c) {
      float value = 0.0f;
      for (size_t k = 7; k-- > 0;) value = value * t + kCoefficients[c][k];
      image.texels[3 * i + c] = std::clamp(value, 0.0f, 1.0f);
    }
  }
  return image;
}

}  // namespace reprise::lab
