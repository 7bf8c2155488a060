// SPDX-License-Identifier: MIT
//
// Half precision holds 11 bits: in a mean of more than 2048 samples, and long before, a new
// sample's step is lost when every store rounds to nearest. Rounding up with the probability of the
// remainder keeps the mean right (stochastic rounding). A value that a half can hold is stored as
// it is. Done by hand, since whether a store truncates or rounds is the device's choice.
#ifndef REPRISE_CORE_HALF_ROUNDING_GLSL
#define REPRISE_CORE_HALF_ROUNDING_GLSL

#include "equations/hash.h"

// `value` in [0, 65504]; `frame` varies the noise from frame to frame.
vec3 roundedToHalf(vec3 value, ivec2 px, float frame, bool stochastic) {
  const float kSmallestStep = 1.0 / 16777216.0;  // 2^-24, the subnormal half
  vec3 power = uintBitsToFloat(floatBitsToUint(value) & uvec3(0x7f800000u));
  vec3 ulp = max(power * (1.0 / 1024.0), vec3(kSmallestStep));
  vec3 threshold = vec3(0.5);
  if (stochastic) {
    uint h = hashPcg(hashPcg(uint(px.x) + 65536u * uint(px.y)) + uint(frame));
    // Ten bits a channel, centred in their intervals: never exactly 0 or 1.
    threshold = (vec3(h & 1023u, (h >> 10) & 1023u, (h >> 20) & 1023u) + 0.5) * (1.0 / 1024.0);
  }
  return min(floor(value / ulp + threshold) * ulp, vec3(65504.0));
}

#endif
