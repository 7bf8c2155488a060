// SPDX-License-Identifier: MIT
//
// What a sequence should look like and how it moves: all that metrics compare with. Made once a
// source, for every technique (lab/run/read_truth.h).
#pragma once

#include <vector>

#include "lab/float_image.h"
#include "lab/metrics/disocclusion.h"

namespace reprise::lab {

struct FrameTruth {
  FloatImage reference;  // linear RGB
  FloatImage motion_px;  // 2 channels, prev_px = px + motion
  Ages ages;
  float median_motion_px = 0.0f;  // of |motion|
  bool reset = false;             // history begins anew here
};

struct SequenceTruth {
  std::vector<FrameTruth> frames;
  double frame_rate = 60.0;  // frames a second
};

// The next frame's truth. `ages` follows the frames in order.
FrameTruth frameTruth(FloatImage reference, FrameGeometry geometry, AgeTracker& ages);

}  // namespace reprise::lab
