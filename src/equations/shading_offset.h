// SPDX-License-Identifier: MIT
// Per-pixel offset of the shading position from the pixel centre (Yang et al. 2009, section 5.1).
#ifndef REPRISE_EQUATIONS_SHADING_OFFSET_H
#define REPRISE_EQUATIONS_SHADING_OFFSET_H

#include "equations/hash.h"
EQ_BEGIN

// Centre of quadrant 0..3, in px from the pixel centre: (-,-), (-,+), (+,-), (+,+) quarters.
EQ_FN vec2 quadrantOffset(uint quadrant) {
  return vec2((quadrant & 2u) != 0u ? 0.25f : -0.25f, (quadrant & 1u) != 0u ? 0.25f : -0.25f);
}

// REPRISE_SHADING_OFFSET_HASH_GAUSSIAN: the quadrant's centre plus a normal deviate of `sigma_px` a
// component, independent for each pixel and seed.
EQ_FN vec2 shadingOffset(uint x, uint y, uint seed, float sigma_px, uint quadrant) {
  uint a = hashPixel(x, y, seed);
  vec2 g = gaussianPair(a, hashPcg(a));
  return quadrantOffset(quadrant) + g * sigma_px;
}

EQ_END
#endif
