// SPDX-License-Identifier: MIT
// Reconstruction filters. Unless said otherwise: even, of a distance in px, not normalized.
#ifndef REPRISE_EQUATIONS_FILTERS_H
#define REPRISE_EQUATIONS_FILTERS_H

#include "equations/language.h"
EQ_BEGIN

// 1 within `radius` (its edge belongs to it on one side only, so that boxes tile).
EQ_FN float boxFilter(float x, float radius) {
  return x >= -radius && x < radius ? 1.0f : 0.0f;
}

EQ_FN float tentFilter(float x, float radius) {
  return max(0.0f, 1.0f - abs(x) / radius);
}

// Mitchell, Netravali 1988, with B = C = 1/3; support 2.
EQ_FN float mitchellFilter(float x) {
  float a = abs(x);
  if (a < 1.0f) return ((7.0f * a - 12.0f) * a * a + 16.0f / 3.0f) / 6.0f;
  if (a < 2.0f) {
    return (((-7.0f / 3.0f * a + 12.0f) * a - 20.0f) * a + 32.0f / 3.0f) / 6.0f;
  }
  return 0.0f;
}

// Karis 2014: a Gaussian that fits a Blackman-Harris window of 3.3 px support, standard deviation
// sqrt(1 / 4.58) = 0.467 px.
EQ_FN float blackmanHarrisFilter(float x) {
  return exp(-2.29f * x * x);
}

// The window itself: four-term Blackman-Harris (Harris 1978) over `width`.
EQ_FN float blackmanHarrisWindow(float x, float width) {
  float t = 6.28318530718f * (x / width + 0.5f);
  if (abs(x) >= 0.5f * width) return 0.0f;
  return 0.35875f - 0.48829f * cos(t) + 0.14128f * cos(2.0f * t) - 0.01168f * cos(3.0f * t);
}

// Of x^2, which a distance in two dimensions has without a root.
EQ_FN float gaussianOfSquare(float square, float sigma) {
  return exp(-0.5f / (sigma * sigma) * square);
}
EQ_FN float gaussianFilter(float x, float sigma) {
  return gaussianOfSquare(x * x, sigma);
}

// sinc(x) sinc(x / lobes), support `lobes`; Duchon 1979.
EQ_FN float lanczosFilter(float x, float lobes) {
  float a = abs(x);
  if (a >= lobes) return 0.0f;
  if (a < 1.0e-4f) return 1.0f;
  float t = 3.14159265359f * a;
  return sin(t) * sin(t / lobes) * lobes / (t * t);
}

// Weights of the four texels at -1, 0, 1, 2 for a position `f` in [0, 1) past texel 0: Keys 1981
// with a = -c. c = 0.5 is Catmull-Rom; they sum to 1 for every c.
EQ_FN vec4 cubicWeights(float f, float c) {
  float f2 = f * f;
  float f3 = f2 * f;
  return vec4(c * (2.0f * f2 - f3 - f), (2.0f - c) * f3 - (3.0f - c) * f2 + 1.0f,
              (c - 2.0f) * f3 + (3.0f - 2.0f * c) * f2 + c * f, c * (f3 - f2));
}

// Weights of the texels at a distance of f, 1 + f and 2 + f, f in [0, 1]: lanczosFilter with three
// lobes by angle addition. A position f past texel 0 takes those of f to its left, which it is on,
// and those of 1 - f to its right; their sum differs from 1 by up to 1 %.
EQ_FN vec3 lanczosHalfWeights(float f) {
  float t = 3.14159265359f * max(f, 1.0e-4f);
  float s = sin(t / 3.0f);
  float c = 0.86602540378f * cos(t / 3.0f);
  float turn = 3.0f * sin(t);
  float t1 = t + 3.14159265359f;
  float t2 = t + 6.28318530718f;
  return turn * vec3(s / (t * t), (-0.5f * s - c) / (t1 * t1), (c - 0.5f * s) / (t2 * t2));
}

// The cubic's with the two inner texels merged into one linear fetch: weights at -1,
// mergedCubicOffset and 2. Jimenez 2016; Karis 2014.
EQ_FN vec3 mergedCubicWeights(vec4 weights) {
  return vec3(weights.x, weights.y + weights.z, weights.w);
}
EQ_FN float mergedCubicOffset(vec4 weights) {
  return weights.z / (weights.y + weights.z);
}

// What is left of the nine fetches' weight, 1, when the four corners are dropped: at least 63/64
// for c = 0.5.
EQ_FN float fiveTapWeight(vec3 x, vec3 y) {
  return 1.0f - (x.x + x.z) * (y.x + y.z);
}

EQ_END
#endif
