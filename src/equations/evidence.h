// SPDX-License-Identifier: MIT
// Has what a pixel shows changed? A residual's mean against its spread.
#ifndef REPRISE_EQUATIONS_EVIDENCE_H
#define REPRISE_EQUATIONS_EVIDENCE_H

#include "equations/language.h"
EQ_BEGIN

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
