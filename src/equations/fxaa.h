// SPDX-License-Identifier: MIT
// The decisions of FXAA 3.11, "quality" (Lottes 2011), as functions of perceptual lumas in [0, 1].
// Compass letters are the neighbours in 3x3, y down: n is above.
#ifndef REPRISE_EQUATIONS_FXAA_H
#define REPRISE_EQUATIONS_FXAA_H

#include "equations/language.h"
EQ_BEGIN

// Whether the contrast `range` of the five lumas is worth the rest: relative to the brightest of
// them, and above what the dark hides.
EQ_FN bool fxaaIsEdge(float range, float brightest, float threshold, float threshold_min) {
  return range >= max(threshold_min, brightest * threshold);
}

// Second derivative across one direction, summed over three parallel lines with weights 1, 2, 1;
// (a, b, c) are the lumas along each line. The edge lies along the direction that bends less.
EQ_FN float fxaaBend(vec3 side, vec3 middle, vec3 other_side) {
  return abs(side.x - 2.0f * side.y + side.z) + 2.0f * abs(middle.x - 2.0f * middle.y + middle.z) +
         abs(other_side.x - 2.0f * other_side.y + other_side.z);
}

// Shift in px towards the other side for detail below a pixel: how far the pixel stands out of its
// neighbours' mean (weights 2 on the cross, 1 on the corners), smoothed, squared, times `strength`.
EQ_FN float fxaaSubpixelShift(float cross_sum, float corner_sum, float luma, float range,
                              float strength) {
  float mean = (2.0f * cross_sum + corner_sum) / 12.0f;
  float c = clamp(abs(mean - luma) / range, 0.0f, 1.0f);
  float smooth_c = (3.0f - 2.0f * c) * c * c;
  return smooth_c * smooth_c * strength;
}

// Shift in px from the ends of the edge, found `distance_a` and `distance_b` px away along it: half
// a pixel at the nearer end, 0 in the middle of the span.
EQ_FN float fxaaSpanShift(float distance_a, float distance_b) {
  return 0.5f - min(distance_a, distance_b) / (distance_a + distance_b);
}

EQ_END
#endif
