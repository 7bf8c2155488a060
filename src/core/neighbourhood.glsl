// SPDX-License-Identifier: MIT
// The nine samples around a pixel, in any space: element 3 * (dy + 1) + (dx + 1).
#ifndef REPRISE_CORE_NEIGHBOURHOOD_GLSL
#define REPRISE_CORE_NEIGHBOURHOOD_GLSL

#include "equations/clipping.h"

vec3 weightedSample(vec3 s[9], vec4 weights_0_3, vec4 weights_4_7, float weight_8) {
  return s[0] * weights_0_3.x + s[1] * weights_0_3.y + s[2] * weights_0_3.z + s[3] * weights_0_3.w +
         s[4] * weights_4_7.x + s[5] * weights_4_7.y + s[6] * weights_4_7.z + s[7] * weights_4_7.w +
         s[8] * weight_8;
}

vec3 meanSample(vec3 s[9]) {
  vec3 sum = vec3(0.0);
  for (int i = 0; i < 9; ++i) sum += s[i];
  return sum * (1.0 / 9.0);
}

struct Moments {
  vec3 mean;
  vec3 deviation;
};

Moments moments(vec3 s[9]) {
  // About the centre: the difference of two squares would give a constant a deviation of 3e-4.
  vec3 sum = vec3(0.0);
  vec3 sum_of_squares = vec3(0.0);
  for (int i = 0; i < 9; ++i) {
    vec3 difference = s[i] - s[4];
    sum += difference;
    sum_of_squares += difference * difference;
  }
  vec3 shift = sum * (1.0 / 9.0);
  vec3 variance = max(sum_of_squares * (1.0 / 9.0) - shift * shift, vec3(0.0));
  return Moments(s[4] + shift, sqrt(variance));
}

struct Bound {
  vec3 low;
  vec3 high;
};

Bound crossExtremes(vec3 s[9]) {
  return Bound(min(min(min(s[1], s[3]), min(s[5], s[7])), s[4]),
               max(max(max(s[1], s[3]), max(s[5], s[7])), s[4]));
}

Bound squareExtremes(vec3 s[9]) {
  Bound plus = crossExtremes(s);
  return Bound(min(plus.low, min(min(s[0], s[2]), min(s[6], s[8]))),
               max(plus.high, max(max(s[0], s[2]), max(s[6], s[8]))));
}

// Karis 2014: the mean of both boxes rounds the square neighbourhood's corners.
Bound roundedExtremes(vec3 s[9]) {
  Bound plus = crossExtremes(s);
  Bound square = squareExtremes(s);
  return Bound(roundedBound(square.low, plus.low), roundedBound(square.high, plus.high));
}

// History is stored in halves and so is off by up to 2^-10 of its largest channel. Where the
// samples share a hue (a grey wall) a bound has no extent along it, and clipping along a line would
// then take all of history's detail for that rounding: bounds are grown by twice the error.
const float kBoundSlack = 2.0 / 1024.0;

float boundSlack(vec3 history, vec3 current) {
  vec3 largest = max(abs(history), abs(current));
  return kBoundSlack * max(largest.x, max(largest.y, largest.z));
}

// Antialiases along an edge of the current frame: a Gaussian that is short across the edge (along
// the gradient) and long along it. Where there is no edge the sample stays. `l`: the
// samples' lumas.
vec3 smoothedAlongEdge(vec3 s[9], float l[9], vec3 current) {
  // Sobel gradient of luma, per 8 px.
  vec2 gradient = vec2((l[2] + 2.0 * l[5] + l[8]) - (l[0] + 2.0 * l[3] + l[6]),
                       (l[6] + 2.0 * l[7] + l[8]) - (l[0] + 2.0 * l[1] + l[2]));
  float steepness = length(gradient);
  vec2 across = gradient / max(steepness, 1.0e-6);
  // Squared standard deviations in px^2: a third of a pixel across, one pixel along.
  const float kAcross = 0.11;
  const float kAlong = 1.0;
  vec3 sum = vec3(0.0);
  float weight_sum = 0.0;
  for (int i = 0; i < 9; ++i) {
    vec2 offset_px = vec2(float(i % 3) - 1.0, float(i / 3) - 1.0);
    float a = dot(offset_px, across);
    float weight = exp(-0.5 * (a * a / kAcross + (dot(offset_px, offset_px) - a * a) / kAlong));
    sum += weight * s[i];
    weight_sum += weight;
  }
  // FXAA 3.11's default contrast threshold, 1/8 of full scale, as a ramp: Sobel sums 4 differences.
  float edge = clamp((steepness * 0.25 - 0.0625) * 16.0, 0.0, 1.0);
  return mix(current, sum / weight_sum, edge);
}

#endif
