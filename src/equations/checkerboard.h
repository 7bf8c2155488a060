// SPDX-License-Identifier: MIT
// Checkerboard rendering: which half of the pixels a frame shades, and what fills the other.
#ifndef REPRISE_EQUATIONS_CHECKERBOARD_H
#define REPRISE_EQUATIONS_CHECKERBOARD_H

#include "equations/language.h"
EQ_BEGIN

// Whether a frame shades pixel (x, y): `half_shaded` 1: even sums of x and y, 2: odd ones, 0: all
// (RepriseFrame::checkerboard).
EQ_FN bool isShaded(int x, int y, int half_shaded) {
  return half_shaded == 0 || ((x + y + half_shaded) & 1) == 1;
}

// The half that frame `index` shades, 1 or 2: first, second, second, first. Strict alternation
// locks to content that moves by an odd number of pixels a frame, which is then seen in one half of
// its points for ever. This order shows it both, and lets no pixel wait for more than two frames.
EQ_FN uint pairedHalf(uint index) {
  uint turn = index & 3u;
  return turn == 1u || turn == 2u ? 2u : 1u;
}

// Jimenez 2016, Wihlidal 2017, "differential blend": of two opposite pairs of neighbours the one
// whose ends agree fills the gap; `difference` is the pair's. 0.001 as in public versions.
EQ_FN float differentialWeight(float difference) {
  return 1.0f / max(difference, 0.001f);
}

EQ_END
#endif
