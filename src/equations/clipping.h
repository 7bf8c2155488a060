// SPDX-License-Identifier: MIT
// Bringing history into the bound of what the current neighbourhood makes believable.
#ifndef REPRISE_EQUATIONS_CLIPPING_H
#define REPRISE_EQUATIONS_CLIPPING_H

#include "equations/language.h"
EQ_BEGIN

// Lottes 2011: each channel by itself.
EQ_FN vec3 clampToBox(vec3 low, vec3 high, vec3 history) {
  return clamp(history, low, high);
}

// Standard deviation from the first two moments; rounding can leave the difference below 0. The box
// of Salvi 2016 is mean -+ gamma * deviation, gamma 0.75 to 1.25.
EQ_FN vec3 deviationFromMoments(vec3 mean, vec3 mean_of_squares) {
  return sqrt(max(mean_of_squares - mean * mean, vec3(0.0f)));
}

// Karis 2014: a bound (low or high) of the 3x3 neighbourhood with rounded corners, the mean of the
// square's and of the cross's.
EQ_FN vec3 roundedBound(vec3 square, vec3 cross_shaped) {
  return (square + cross_shaped) * 0.5f;
}

// Pedersen 2016 (INSIDE): along the line to the box's centre, by the axis that leaves it farthest.
EQ_FN vec3 clipTowardBoxCentre(vec3 low, vec3 high, vec3 history) {
  vec3 centre = (low + high) * 0.5f;
  vec3 half_size = (high - low) * 0.5f + vec3(1.0e-6f);
  vec3 offset = history - centre;
  vec3 ratio = abs(offset / half_size);
  float farthest = max(ratio.x, max(ratio.y, ratio.z));
  return farthest > 1.0f ? centre + offset / farthest : history;
}

// How far, 0..1, one can go from `from` by `step` along an axis before leaving [low, high]. A start
// outside (a filtered sample can lie out of its own neighbourhood's box) goes nowhere or all the
// way.
EQ_FN float slabExit(float from, float step, float low, float high) {
  if (abs(step) < 1.0e-7f) return 1.0f;
  float bound = step > 0.0f ? high : low;
  return clamp((bound - from) / step, 0.0f, 1.0f);
}

// Karis 2014: along the line from the current sample to the history, to where it leaves the box.
EQ_FN vec3 clipTowardSample(vec3 low, vec3 high, vec3 current, vec3 history) {
  vec3 step = history - current;
  float t = min(
      slabExit(current.x, step.x, low.x, high.x),
      min(slabExit(current.y, step.y, low.y, high.y), slabExit(current.z, step.z, low.z, high.z)));
  return current + step * t;
}

// Axes of the 32-sided polytope (Ikkala et al. 2024 use 16 axes, three of them canonical). Ours:
// the 3 face, 6 edge and 4 corner directions of the cube, and three more where those leave the
// widest gaps, 27.6 degrees from the nearest: along (sqrt 3 - sqrt 2, sqrt 2 - 1, 1), of whose 24
// images three lie far from each other. Not normalized: slabs scale with their axis.
EQ_CONST uint kKdopAxes = 16u;
EQ_FN vec3 kdopAxis(uint i) {
  if (i == 0u) return vec3(1.0f, 0.0f, 0.0f);
  if (i == 1u) return vec3(0.0f, 1.0f, 0.0f);
  if (i == 2u) return vec3(0.0f, 0.0f, 1.0f);
  if (i == 3u) return vec3(1.0f, 1.0f, 0.0f);
  if (i == 4u) return vec3(1.0f, -1.0f, 0.0f);
  if (i == 5u) return vec3(1.0f, 0.0f, 1.0f);
  if (i == 6u) return vec3(1.0f, 0.0f, -1.0f);
  if (i == 7u) return vec3(0.0f, 1.0f, 1.0f);
  if (i == 8u) return vec3(0.0f, 1.0f, -1.0f);
  if (i == 9u) return vec3(1.0f, 1.0f, 1.0f);
  if (i == 10u) return vec3(1.0f, 1.0f, -1.0f);
  if (i == 11u) return vec3(1.0f, -1.0f, 1.0f);
  if (i == 12u) return vec3(-1.0f, 1.0f, 1.0f);
  if (i == 13u) return vec3(0.317837f, 0.414214f, 1.0f);
  if (i == 14u) return vec3(0.414214f, -1.0f, 0.317837f);
  return vec3(1.0f, 0.317837f, -0.414214f);
}

EQ_END
#endif
