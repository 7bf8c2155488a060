// SPDX-License-Identifier: MIT
// Decoupled samples: visibility at every pixel, shading at coarse pixels. Xiao, Liktor,
// Vaidyanathan 2018, "Coarse pixel shading with temporal supersampling"; numbers are that paper's.
#ifndef REPRISE_EQUATIONS_COARSE_H
#define REPRISE_EQUATIONS_COARSE_H

#include "equations/language.h"
EQ_BEGIN

// Centre (px), along an axis, of the coarse pixel of `size` pixels that holds pixel `px`; coarse
// pixels begin at `origin_px`, 0 <= origin_px < size.
EQ_FN float coarseCentre(int px, int size, int origin_px) {
  // In floats, since CPU drivers divide integers lane by lane. Half a pixel in, so that no rounding
  // of the quotient reaches a border.
  float block = floor((float(px - origin_px) + 0.5f) * (1.0f / float(size)));
  return (block + 0.5f) * float(size) + float(origin_px);
}

// Weight of a new sample in a mean that holds samples of the summed weight `held`. With held =
// (1 / alpha - 1) * w and a weight of w this is alpha: equation (3) up to the normalization of the
// shading filter, which the paper does not give.
EQ_FN float weightedMeanAlpha(float weight, float held) {
  return weight / max(held + weight, 1.0e-8f);
}

// Section 3.2: a pixel lies at a silhouette where its motion differs from that of the front-most
// surface two pixels around by more than a share of the longest motion there, here that motion's
// square (px^2).
EQ_FN bool isSilhouette(vec2 own_px, vec2 front_px, float longest_square, float share) {
  vec2 difference_px = vec2(own_px.x - front_px.x, own_px.y - front_px.y);
  return dot(difference_px, difference_px) > share * share * longest_square;
}

// How much of a difference of means is change, not error: James and Stein 1961, "Estimation with
// quadratic loss", the positive part of their factor.
EQ_FN float changeCertainty(float difference, float error) {
  float square = difference * difference;
  return square > error * error ? 1.0f - error * error / square : 0.0f;
}

// What scales a mean of `before` to before + change, at most `most` times up or down.
EQ_FN float changeGain(float before, float change, float most) {
  const float kLeastMean = 1.0e-4f;  // halves hold no ratio of less: their normal ones end at 6e-5
  return clamp(1.0f + change / max(before, kLeastMean), 1.0f / most, most);
}

EQ_END
#endif
