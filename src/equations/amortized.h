// SPDX-License-Identifier: MIT
// Amortized supersampling: Yang, Nehab, Sander, Sitthi-amorn, Lawrence, Hoppe 2009. Numbers in
// brackets are the paper's equations.
#ifndef REPRISE_EQUATIONS_AMORTIZED_H
#define REPRISE_EQUATIONS_AMORTIZED_H

#include "equations/language.h"
EQ_BEGIN

// Second moment (px^2, mean of x and y) that a converged bilinear history with constant `alpha`
// has at the fractional velocity (vx, vy), its samples having variance `sample_variance` (11).
EQ_FN float bilinearBlurVariance(float sample_variance, float alpha, float vx, float vy) {
  return sample_variance + (1.0f - alpha) / alpha * 0.5f * (vx * (1.0f - vx) + vy * (1.0f - vy));
}

// One axis of the tent (13).
EQ_FN float tentWeight(float distance_px, float radius_px) {
  return clamp(1.0f - abs(distance_px) / radius_px, 0.0f, 1.0f);
}

// Weights of the texels (0,0) (1,0) (0,1) (1,1) around a point at the fraction (fx, fy) of their
// cell (17).
EQ_FN vec4 tentWeights(float fx, float fy, float radius_px) {
  float x0 = tentWeight(fx, radius_px);
  float x1 = tentWeight(1.0f - fx, radius_px);
  float y0 = tentWeight(fy, radius_px);
  float y1 = tentWeight(1.0f - fy, radius_px);
  return vec4(x0 * y0, x1 * y0, x0 * y1, x1 * y1);
}

// Fraction at which one bilinear fetch gives the mean under `w` of tentWeights (18). The paper
// prints its rows exchanged in (19); its derivation (51) decides.
EQ_FN vec2 bilinearFraction(vec4 w) {
  float sum = max(w.x + w.y + w.z + w.w, 1.0e-20f);
  return vec2((w.y + w.w) / sum, (w.z + w.w) / sum);
}

// Radius of the axis-aligned square that holds the reprojected tent (15), as a share of the
// radius without motion. Columns of the Jacobian: d previous_px / d px. Not below 1: with a
// smaller square a buffer could offer no sample at all when the view is magnified.
EQ_FN float tentGrowth(vec2 column_x, vec2 column_y) {
  float x = abs(column_x.x + column_y.x);
  float y = abs(column_x.y + column_y.y);
  return max(max(x, y), 1.0f);
}

// Variance reduction factor N after one sample of weight `beta` joined `count` of them (8).
EQ_FN float varianceReduction(float count, float beta) {
  float rest = 1.0f - beta;
  return 1.0f / (beta * beta + rest * rest / max(count, 1.0e-6f));
}

// Lower bound on the new sample's weight from the residual (27); 0 while it is tolerable.
EQ_FN float residualBound(float residual, float tolerance) {
  return max(1.0f - tolerance / max(abs(residual), 1.0e-20f), 0.0f);
}

EQ_END
#endif
