// SPDX-License-Identifier: MIT
#pragma once

#include "lab/float_image.h"

namespace reprise::lab {

// Depth of pixels that nothing covers.
constexpr float kBackgroundDepth = 1.0e10f;

// What stands at each pixel and where it was a frame ago: the truth that metrics follow along
// motion. Without jitter, at the pixels' centres, where the source renders; a capture's is that of
// its own, jittered samples.
struct FrameGeometry {
  FloatImage motion_px;            // 2 channels: prev_px = px + motion, free of jitter
  FloatImage view_depth;           // 1 channel
  FloatImage previous_view_depth;  // of the same point in the frame before; 1 channel
  bool reset = false;              // a cut: the frame has no frame before
};

}  // namespace reprise::lab
