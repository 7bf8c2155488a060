// SPDX-License-Identifier: MIT
#pragma once

#include "lab/float_image.h"

namespace reprise::lab {

// The Gaussian pyramid of ColorVideoVDP, kernel (0.05, 0.25, 0.4, 0.25, 0.05), one channel, sides
// of at least 2 px. As the reference implementation does it, its treatment of the right edge by the
// parity of the number of rows included.
FloatImage reduced(const FloatImage& image);
// `image` at the extent that reduced() made it from.
FloatImage expanded(const FloatImage& image, uint32_t width, uint32_t height);

// Gaussian blur of 3 px deviation, 13 taps, edges reflected; sides above 6 px.
FloatImage maskingBlur(const FloatImage& image);

}  // namespace reprise::lab
