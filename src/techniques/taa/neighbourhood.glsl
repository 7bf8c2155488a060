// SPDX-License-Identifier: MIT
// The nine samples around a pixel, in working space: its reconstruction and the bound of believable
// history. Element 3 * (dy + 1) + (dx + 1).
#ifndef REPRISE_TECHNIQUES_TAA_NEIGHBOURHOOD_GLSL
#define REPRISE_TECHNIQUES_TAA_NEIGHBOURHOOD_GLSL

#include "core/neighbourhood.glsl"
#include "equations/clipping.h"
#include "techniques/taa/working_space.glsl"

vec3 filteredSample(vec3 s[9], TaaConstants k) {
  return weightedSample(s, k.filter_weights_0_3, k.filter_weights_4_7, k.filter_weight_8);
}

Bound extremes(vec3 s[9]) {
  if (kClip == kClipCross) return crossExtremes(s);
  return kClip == kClipRounded ? roundedExtremes(s) : squareExtremes(s);
}

// Along the line from the current sample, to where it leaves the slabs that hold all nine samples
// along each of 16 axes (eq. 5c). `widen` scales each slab about its centre.
vec3 clipToKdop(vec3 history, vec3 current, vec3 s[9], float widen) {
  vec3 travel = history - current;
  float slack = boundSlack(history, current);
  float t = 1.0;
  for (uint a = 0u; a < kKdopAxes; ++a) {
    vec3 axis = kdopAxis(a);
    float low = dot(axis, s[0]);
    float high = low;
    for (int i = 1; i < 9; ++i) {
      float along = dot(axis, s[i]);
      low = min(low, along);
      high = max(high, along);
    }
    float grow = 0.5 * (high - low) * (widen - 1.0) + slack;
    t = min(t, slabExit(dot(axis, current), dot(axis, travel), low - grow, high + grow));
  }
  return current + travel * t;
}

// Moves `history` into the bound of the neighbourhood. `widen` >= 1 scales the bound about its
// centre.
vec3 rectified(vec3 history, vec3 current, vec3 s[9], float gamma, float widen) {
  if (kClip == kClipNone) return history;
  if (kClip == kClipKdop) return clipToKdop(history, current, s, widen);
  vec3 low;
  vec3 high;
  if (kClip == kClipVariance) {
    Moments m = moments(s);
    low = m.mean - gamma * m.deviation;
    high = m.mean + gamma * m.deviation;
  } else {
    Bound bound = extremes(s);
    vec3 centre = 0.5 * (bound.low + bound.high);
    vec3 half_size = 0.5 * (bound.high - bound.low) * widen;
    low = centre - half_size;
    high = centre + half_size;
  }
  float slack = boundSlack(history, current);
  low -= slack;
  high += slack;
  if (kClipToward == kTowardCentre) return clipTowardBoxCentre(low, high, history);
  if (kClipToward == kTowardSample) return clipTowardSample(low, high, current, history);
  return clampToBox(low, high, history);
}

vec3 smoothedAlongEdge(vec3 s[9], vec3 current) {
  float l[9];
  for (int i = 0; i < 9; ++i) l[i] = workingLuma(s[i]);
  return smoothedAlongEdge(s, l, current);
}

#endif
