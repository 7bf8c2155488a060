// SPDX-License-Identifier: MIT
// Pyramids whose texels lie between four of the finer level: Burt, Adelson 1983 with an even
// kernel. Both directions are one kernel, so that what goes down and up again is smoothed, not
// shifted.
#ifndef REPRISE_EQUATIONS_EVEN_PYRAMID_H
#define REPRISE_EQUATIONS_EVEN_PYRAMID_H

#include "equations/language.h"
EQ_BEGIN

// Coarse texel x is the sum of these over the fine texels 2x - 1 + i, i = 0 to 3: binomial, the
// quadratic B-spline's refinement.
EQ_FN float evenPyramidWeight(int i) {
  return i == 0 || i == 3 ? 0.125f : 0.375f;
}

// The transpose, times 2: fine texel x mixes the coarse texel x / 2, which covers it, with the
// neighbour on its own side.
EQ_CONST float kEvenPyramidNear = 0.75f;
EQ_CONST float kEvenPyramidFar = 0.25f;
// x not negative.
EQ_FN int evenPyramidFarTexel(int x) {
  return x / 2 + (x - 2 * (x / 2) == 0 ? -1 : 1);
}

EQ_END
#endif
