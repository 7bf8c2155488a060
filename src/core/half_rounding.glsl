// SPDX-License-Identifier: MIT
//
// Half precision holds 11 bits: in a mean of more than 2048 samples, and long before, a new
// sample's step is lost when every store rounds to nearest. Rounding up with the probability of the
// remainder keeps the mean right (stochastic rounding). A value that a half can hold is stored as
// it is. Done by hand, since whether a store truncates or rounds is the device's choice.
#ifndef REPRISE_CORE_HALF_ROUNDING_GLSL
#define REPRISE_CORE_HALF_ROUNDING_GLSL

#include "equations/hash.h"

// To the multiple of half's last bit below value + threshold * bit. `value` in [0, 65504].
vec3 roundedToHalfAt(vec3 value, vec3 threshold) {
  const float kSmallestStep = 1.0 / 16777216.0;  // 2^-24, the subnormal half
  vec3 power = uintBitsToFloat(floatBitsToUint(value) & uvec3(0x7f800000u));
  vec3 ulp = max(power * (1.0 / 1024.0), vec3(kSmallestStep));
  return min(floor(value / ulp + threshold) * ulp, vec3(65504.0));
}

// Three numbers in (0, 1): ten bits each, centred in their intervals.
vec3 unitFromBits(uint h) {
  return (vec3(h & 1023u, (h >> 10) & 1023u, (h >> 20) & 1023u) + 0.5) * (1.0 / 1024.0);
}

// `frame` varies the noise from frame to frame.
vec3 roundedToHalf(vec3 value, ivec2 px, float frame, bool stochastic) {
  vec3 threshold = vec3(0.5);
  if (stochastic) {
    threshold = unitFromBits(hashPcg(hashPcg(uint(px.x) + 65536u * uint(px.y)) + uint(frame)));
  }
  return roundedToHalfAt(value, threshold);
}

// The same with thresholds that a pixel steps through by the golden ratio. Errors of successive
// frames cancel, where independent ones add up to a random walk: 2.5 last bits deep for a feedback
// of 0.02.
vec3 evenlyRoundedToHalf(vec3 value, ivec2 px, float frame) {
  vec3 start = unitFromBits(hashPcg(uint(px.x) + 65536u * uint(px.y)));
  // 0.618034 * 1024, odd: steps through all 1024 before it repeats.
  uint turn = (uint(frame) * 633u) & 1023u;
  return roundedToHalfAt(value, fract(start + float(turn) * (1.0 / 1024.0)));
}

#endif
