// SPDX-License-Identifier: MIT
#pragma once

#include "lab/float_image.h"
#include "lab/paper/masked_error.h"

namespace reprise::lab {

// Pixels whose surface was seen in the frame before and looked otherwise there. References in
// display values, motion as prev_px = px + motion; pixels of `unseen` are left out.
PixelMask changedShading(const FloatImage& reference, const FloatImage& previous,
                         const FloatImage& motion_px, const PixelMask& unseen);

}  // namespace reprise::lab
