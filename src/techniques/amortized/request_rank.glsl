// SPDX-License-Identifier: MIT
//
// The order in which evaluations are worth their cost. A pixel that has n estimates gains
// 1 / n - 1 / (n + 1) of the variance of one by another: the fewer it has, the more. So the first
// evaluation of every pixel that has nothing comes before the second of any.
#ifndef REPRISE_AMORTIZED_REQUEST_RANK_GLSL
#define REPRISE_AMORTIZED_REQUEST_RANK_GLSL

#include "equations/hash.h"
#include "techniques/amortized/amortized_shared.h"

// Quadrants that hold something: the level of the first evaluation asked for; each one more raises
// it by one.
uint firstRequestLevel(uint mask) {
  return kRequestLevels - uint(bitCount(mask));
}

// Pixels of one level in an order without pattern, another one each frame.
uint requestPlace(ivec2 px, float frame_number) {
  return hashPixel(uint(px.x), uint(px.y), uint(frame_number)) & (kRequestPlaces - 1u);
}

#endif
