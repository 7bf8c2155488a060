// SPDX-License-Identifier: MIT
// The space in which samples are bounded and blended: weighted (so that one bright sample does not
// outvote its neighbours), then YCoCg or RGB. Bounds and blend share it: a bound taken elsewhere
// lets through what the blend then shows.
#ifndef REPRISE_TECHNIQUES_TAA_WORKING_SPACE_GLSL
#define REPRISE_TECHNIQUES_TAA_WORKING_SPACE_GLSL

#include "equations/color_space.h"
#include "techniques/taa/taa_shared.h"

vec3 toWorking(vec3 linear) {
  vec3 c = linear;
  if (kWeighting == kWeightingLog) c = logFromLinear(c);
  if (kWeighting == kWeightingLuminance) c = compressByLuma(c);
  if (kClipYCoCg != 0u) c = yCoCgFromRgb(c);
  return c;
}

vec3 fromWorking(vec3 working) {
  vec3 c = working;
  if (kClipYCoCg != 0u) c = rgbFromYCoCg(c);
  if (kWeighting == kWeightingLog) return linearFromLog(c);
  c = max(c, vec3(0.0));
  if (kWeighting == kWeightingLuminance) c = expandByLuma(c);
  return c;
}

float workingLuma(vec3 working) {
  return kClipYCoCg != 0u ? working.x : lumaYCoCg(working);
}

#endif
