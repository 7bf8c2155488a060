// SPDX-License-Identifier: MIT
// Noise that is a pure function of integers.
#ifndef REPRISE_EQUATIONS_HASH_H
#define REPRISE_EQUATIONS_HASH_H

#include "equations/language.h"
EQ_BEGIN

// One step of a 32-bit PCG with its output permutation (RXS-M-XS). O'Neill 2014; Jarzynski, Olano
// 2020, "Hash Functions for GPU Rendering", JCGT 9(3).
EQ_FN uint hashPcg(uint v) {
  uint state = v * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

EQ_FN uint hashPixel(uint x, uint y, uint seed) {
  return hashPcg(x + hashPcg(y + hashPcg(seed)));
}

// [0, 1): the upper 24 bits, so that the result is exact and never rounds to 1.
EQ_FN float unitFloat(uint bits) {
  return float(bits >> 8u) * (1.0f / 16777216.0f);
}

// Two independent normal deviates from two words, by Box and Muller 1958. The first uniform number
// is in (0, 1].
EQ_FN vec2 gaussianPair(uint a, uint b) {
  float u = (float(a >> 8u) + 1.0f) * (1.0f / 16777216.0f);
  float angle = 6.28318530718f * unitFloat(b);
  float radius = sqrt(-2.0f * log(u));
  return vec2(radius * cos(angle), radius * sin(angle));
}

EQ_END
#endif
