// SPDX-License-Identifier: MIT
// Contrast-adaptive sharpening from a cross of five samples in [0, 1] (AMD 2021, RCAS).
#ifndef REPRISE_EQUATIONS_SHARPEN_H
#define REPRISE_EQUATIONS_SHARPEN_H

#include "equations/language.h"
EQ_BEGIN

// Strongest negative weight of the four neighbours: 1/4 would divide by zero, 1/16 keeps away.
EQ_CONST float kSharpenLimit = 0.25f - 1.0f / 16.0f;

// The weight of each neighbour at which one channel of the result would leave [0, 1]; <= 0.
EQ_FN float sharpenLobe(float low, float high) {
  float to_black = low / max(4.0f * high, 1.0e-5f);
  float to_white = (1.0f - high) / min(4.0f * low - 4.0f, -1.0e-5f);
  return max(-to_black, to_white);
}

// Factor in [1/2, 1] on the lobe, from lumas: a centre unlike all its neighbours is likely noise.
EQ_FN float sharpenNoiseFactor(float up, float left, float centre, float right, float down) {
  float low = min(min(min(up, left), min(right, down)), centre);
  float high = max(max(max(up, left), max(right, down)), centre);
  float outlying = abs(0.25f * (up + left + right + down) - centre) / max(high - low, 1.0e-6f);
  return 1.0f - 0.5f * clamp(outlying, 0.0f, 1.0f);
}

// (lobe * (up + left + right + down) + centre) / (4 lobe + 1), lobe scaled by `strength` in [0, 1].
EQ_FN vec3 sharpened(vec3 up, vec3 left, vec3 centre, vec3 right, vec3 down, float strength) {
  vec3 low = min(min(up, left), min(right, down));
  vec3 high = max(max(up, left), max(right, down));
  float lobe =
      max(sharpenLobe(low.x, high.x), max(sharpenLobe(low.y, high.y), sharpenLobe(low.z, high.z)));
  lobe = clamp(lobe, -kSharpenLimit, 0.0f) * strength;
  return ((up + left + right + down) * lobe + centre) / (4.0f * lobe + 1.0f);
}

EQ_END
#endif
