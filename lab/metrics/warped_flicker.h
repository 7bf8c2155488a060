// SPDX-License-Identifier: MIT
#pragma once

#include "lab/metrics/disocclusion.h"

namespace reprise::lab {

// Changes of luma below this are not seen: one step of an 8-bit display, a Weber fraction of 1.7 %
// at mid grey.
constexpr float kJustNoticeableLuma = 1.0f / 255.0f;

// Two frames of one sequence, luma of display values.
struct LumaStep {
  const FloatImage& now;
  const FloatImage& before;
};

// Flicker along motion, after Yang, Boyce and Stein 2008: the mean over pixels whose surface the
// frame before shows (hasPreviousSurface) of
//   e = |T_n - T_n-1(px + motion)| - |R_n - R_n-1(px + motion)|,  0 where e <= kJustNoticeableLuma,
// with the frame before read bilinearly. 0 where the test changes no more than the reference; NaN
// where no pixel has a previous surface.
double warpedFlicker(const LumaStep& reference, const LumaStep& test, const FloatImage& motion_px,
                     const Ages& ages);

}  // namespace reprise::lab
