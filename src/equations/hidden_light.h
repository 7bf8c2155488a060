// SPDX-License-Identifier: MIT
// Light that is shaded apart, with few samples, while the rest of the shading is antialiased.
#ifndef REPRISE_EQUATIONS_HIDDEN_LIGHT_H
#define REPRISE_EQUATIONS_HIDDEN_LIGHT_H

#include "equations/language.h"
EQ_BEGIN

// Below this radiance the shown light says nothing about the surface, and hidden light is added as
// it is: a hundredth of a mid-grey.
EQ_CONST float kLeastShownLight = 0.002f;
// Gleam has nothing of the surface's colour in it: so many times its radiance in the base makes
// gleaming pixels add their hidden light as it is.
EQ_CONST float kGleamWeight = 4.0f;

// Both lights fall on one surface, so their quotient is free of its colour, and with it of most of
// what aliases. Added as it is, hidden light would bring the aliasing of its few samples along.
// After section 6 of Yang et al. 2009, which amortizes what does not depend on the light.
// The hidden light in the base keeps the gain below 1: where little light is shown, its deviation
// from its mean would be multiplied, and the result be too bright on average.
EQ_FN float hiddenBase(vec3 shown_gleam, vec3 hidden) {
  vec3 parts = kGleamWeight * shown_gleam + hidden;
  return kLeastShownLight + max(max(parts.x, parts.y), parts.z);
}
EQ_FN vec3 hiddenGain(vec3 shown, vec3 hidden, float base) {
  return hidden / (shown + vec3(base, base, base));
}

// The antialiased shown light with the hidden one; given the one that the gain was made of, their
// sum.
EQ_FN vec3 withHiddenLight(vec3 shown, vec3 gain, float base) {
  return shown + (shown + vec3(base, base, base)) * gain;
}

EQ_END
#endif
