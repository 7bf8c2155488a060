// SPDX-License-Identifier: MIT
// Per-pixel offset of the shading position from the pixel centre (Yang et al. 2009, section 5.1).
#ifndef REPRISE_EQUATIONS_SHADING_OFFSET_H
#define REPRISE_EQUATIONS_SHADING_OFFSET_H

#include "equations/hash.h"
EQ_BEGIN

// Centre of quadrant 0..3, in px from the pixel centre: (-,-), (-,+), (+,-), (+,+) quarters; 4 is
// the pixel centre itself.
EQ_CONST uint kQuadrantCentre = 4u;
EQ_FN vec2 quadrantOffset(uint quadrant) {
  if (quadrant >= kQuadrantCentre) return vec2(0.0f, 0.0f);
  return vec2((quadrant & 2u) != 0u ? 0.25f : -0.25f, (quadrant & 1u) != 0u ? 0.25f : -0.25f);
}

// The quadrant that a frame updates: the paper's order of period 32 (its section 5.1), two bits a
// frame from the lowest. Round robin lets the image drift (its Figure 6).
EQ_CONST uint kQuadrantPeriod = 32u;
EQ_FN uint quadrantOfFrame(uint frame_index) {
  uint phase = frame_index % kQuadrantPeriod;
  uint order = phase < 16u ? 0x8db1d8e4u : 0x271b724eu;
  return (order >> (2u * (phase % 16u))) & 3u;
}

// With this deviation (px a component) the four quadrants nearly make the wanted pixel filter.
EQ_CONST float kShadingOffsetSigma_px = 0.2575f;

// REPRISE_SHADING_OFFSET_HASH_GAUSSIAN: the quadrant's centre plus a normal deviate of `sigma_px` a
// component, independent for each pixel and seed.
EQ_FN vec2 shadingOffset(uint x, uint y, uint seed, float sigma_px, uint quadrant) {
  uint a = hashPixel(x, y, seed);
  vec2 g = gaussianPair(a, hashPcg(a));
  return quadrantOffset(quadrant) + g * sigma_px;
}

EQ_END
#endif
