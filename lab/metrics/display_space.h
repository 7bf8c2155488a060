// SPDX-License-Identifier: MIT
//
// The space of every figure: v = (x / (1 + x))^(1/2.2) a channel, x = max(0, linear), in [0, 1).
#pragma once

#include "lab/float_image.h"

namespace reprise::lab {

// RGB or RGBA linear in, RGB display out. NaN is read as 0, +infinity as 1.
FloatImage displayImage(const FloatImage& linear);
// The same without the power: what FLIP takes, linear light in [0, 1).
FloatImage tonemappedImage(const FloatImage& linear);
// Rec. 709 luma of an RGB display image, one channel.
FloatImage lumaImage(const FloatImage& display);

}  // namespace reprise::lab
