// SPDX-License-Identifier: MIT
//
// How long each pixel's surface has been in view. Ages come from the truth's geometry alone: they
// are computed once a sequence and serve every technique.
#pragma once

#include <cstdint>
#include <vector>

#include "lab/frame_geometry.h"

namespace reprise::lab {

// What a pixel's age says beyond frames: 1 where something in front has just moved away, counting
// up along motion.
constexpr uint8_t kAgeEntered = 0;           // outside the frame before, or before the first frame
constexpr uint8_t kAgeLongest = 254;         // as old or older
constexpr uint8_t kAgeNeverUncovered = 255;  // nothing has covered it since it entered

using Ages = std::vector<uint8_t>;  // a pixel, rows from top to bottom

inline bool hasPreviousSurface(uint8_t age) {
  return age > 1;
}

class AgeTracker {
 public:
  // Frames in order. A point was hidden where all texels of the frame before around its previous
  // position, those that bilinear reads, are nearer than the point was then by more than
  // kHiddenTolerance and what the surface's slope accounts for.
  Ages next(const FrameGeometry& geometry);

 private:
  Ages ages_;
  FloatImage view_depth_;
};

// The one of the frame before is 2 % nearer: rounding of half a pixel on surfaces seen at an angle
// is left to the slope term.
constexpr float kHiddenTolerance = 0.02f;

// Of the pixels of one age, or of a range of ages.
struct AgeError {
  uint64_t pixels = 0;
  double squared_error = 0.0;  // summed over pixels, mean over channels
};
// Images of one shape, display values.
AgeError errorAtAges(const FloatImage& reference, const FloatImage& test, const Ages& ages,
                     uint8_t youngest, uint8_t oldest);

}  // namespace reprise::lab
