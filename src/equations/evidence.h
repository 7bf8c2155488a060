// SPDX-License-Identifier: MIT
// Has what a pixel shows changed? A residual's mean against its spread.
#ifndef REPRISE_EQUATIONS_EVIDENCE_H
#define REPRISE_EQUATIONS_EVIDENCE_H

#include "equations/language.h"
EQ_BEGIN

// The scale on which residuals are alike in light and in dark: the tone curve of the figures with
// a square root in the place of the power 1 / 2.2. [0, 1).
EQ_FN vec3 responseFromLinear(vec3 c) {
  return sqrt(c / (c + vec3(1.0f)));
}
// Its inverse; a response of 1, which no colour reaches, comes back as 65504.
EQ_FN vec3 linearFromResponse(vec3 r) {
  vec3 v = r * r;
  return v / max(vec3(1.0f) - v, vec3(1.0f / 65505.0f));
}

// Variance of an exponential mean of weight alpha, as a share of one sample's variance.
EQ_FN float exponentialMeanVariance(float alpha) {
  return alpha / (2.0f - alpha);
}

// Positive-part James-Stein factor (Stein 1966): how much of an observed mean is to be believed
// when `mean_square` is its squared length and `variance` what noise alone gives it. `doubt` is how
// many variances are wholly disbelieved.
EQ_FN float believedShare(float mean_square, float variance, float doubt) {
  return max(0.0f, 1.0f - doubt * variance / max(mean_square, 1.0e-12f));
}

EQ_END
#endif
