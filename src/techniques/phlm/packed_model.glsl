// SPDX-License-Identifier: MIT
//
// A model about the pixel's own feature in 256 bits:
//   intercept  3 halves          level    1 half
//   slopes     9 times 14 bits: units of 1/512, [-16, 16)
//   spread     3 times 8 bits: log2, 10 steps an octave, from 2^-12
//   cross      3 times 8 bits and spread_cross 3 times 5 bits: as correlations
// A slope beyond 16 or a correlation's last bits change the prediction by less than the feature
// moves between two frames times those bits; the level and the intercept, which every prediction is
// made of, keep half precision.
#ifndef REPRISE_TECHNIQUES_PHLM_PACKED_MODEL_GLSL
#define REPRISE_TECHNIQUES_PHLM_PACKED_MODEL_GLSL

#include "equations/least_squares.h"

// Variances of slopes: log2 in [-12, 13.5], from kLeastVariance to above what variance_limit
// allows.
const float kSpreadLowest = -12.0;
const float kSpreadSteps = 10.0;
const float kSlopeSteps = 512.0;

uint packedSlope(float slope) {
  return uint(clamp(floor(slope * kSlopeSteps + 0.5), -8191.0, 8191.0) + 8192.0);
}
float unpackedSlope(uint bits) {
  return (float(bits & 16383u) - 8192.0) * (1.0 / kSlopeSteps);
}

uint packedSpread(float spread) {
  float steps = (log2(max(spread, kLeastVariance)) - kSpreadLowest) * kSpreadSteps;
  return uint(clamp(floor(steps + 0.5), 0.0, 255.0));
}
float unpackedSpread(uint bits) {
  return exp2(float(bits & 255u) * (1.0 / kSpreadSteps) + kSpreadLowest);
}

// Towards 0, and so never beyond what the variances allow.
uint packedCorrelation(float covariance, float a, float b, float steps) {
  float r = clamp(covariance / sqrt(max(a * b, 1.0e-12)), -1.0, 1.0) * steps;
  return uint(sign(r) * floor(abs(r)) + steps);
}
float unpackedCovariance(uint bits, float a, float b, float steps) {
  return (float(bits) - steps) * (1.0 / steps) * sqrt(a * b);
}

// Four 14-bit slopes leave 4 bits in each word of a pair; the ninth slope and the spread's
// correlations fill them.
struct PackedModel {
  uvec4 color;
  uvec4 rest;
};

PackedModel packedModel(LinearModel m) {
  uvec3 spread =
      uvec3(packedSpread(m.spread.x), packedSpread(m.spread.y), packedSpread(m.spread.z));
  vec3 kept = vec3(unpackedSpread(spread.x), unpackedSpread(spread.y), unpackedSpread(spread.z));
  // 15 bits.
  uint spread_cross = packedCorrelation(m.spread_cross.x, kept.x, kept.y, 15.0) |
                      packedCorrelation(m.spread_cross.y, kept.x, kept.z, 15.0) << 5u |
                      packedCorrelation(m.spread_cross.z, kept.y, kept.z, 15.0) << 10u;
  uint last_slope = packedSlope(m.slope_b.z);
  PackedModel bits;
  bits.color = uvec4(
      packHalf2x16(m.intercept.xy), packHalf2x16(vec2(m.intercept.z, m.level)),
      packedSlope(m.slope_r.x) | packedSlope(m.slope_r.y) << 14u | (last_slope & 15u) << 28u,
      packedSlope(m.slope_r.z) | packedSlope(m.slope_g.x) << 14u | (last_slope >> 4u & 15u) << 28u);
  bits.rest = uvec4(
      packedSlope(m.slope_g.y) | packedSlope(m.slope_g.z) << 14u | (spread_cross & 15u) << 28u,
      packedSlope(m.slope_b.x) | packedSlope(m.slope_b.y) << 14u |
          (spread_cross >> 4u & 15u) << 28u,
      spread.x | spread.y << 8u | spread.z << 16u | (last_slope >> 8u) << 24u,
      packedCorrelation(m.cross.x, m.level, kept.x, 127.0) |
          packedCorrelation(m.cross.y, m.level, kept.y, 127.0) << 8u |
          packedCorrelation(m.cross.z, m.level, kept.z, 127.0) << 16u |
          (spread_cross >> 8u) << 24u);
  return bits;
}

LinearModel unpackedModel(uvec4 color, uvec4 rest) {
  LinearModel m;
  vec2 blue_level = unpackHalf2x16(color.y);
  m.intercept = vec3(unpackHalf2x16(color.x), blue_level.x);
  m.level = blue_level.y;
  uint last_slope = color.z >> 28u | (color.w >> 28u) << 4u | (rest.z >> 24u) << 8u;
  uint spread_cross = rest.x >> 28u | (rest.y >> 28u) << 4u | (rest.w >> 24u) << 8u;
  m.slope_r = vec3(unpackedSlope(color.z), unpackedSlope(color.z >> 14u), unpackedSlope(color.w));
  m.slope_g =
      vec3(unpackedSlope(color.w >> 14u), unpackedSlope(rest.x), unpackedSlope(rest.x >> 14u));
  m.slope_b = vec3(unpackedSlope(rest.y), unpackedSlope(rest.y >> 14u), unpackedSlope(last_slope));
  m.spread =
      vec3(unpackedSpread(rest.z), unpackedSpread(rest.z >> 8u), unpackedSpread(rest.z >> 16u));
  m.cross = vec3(unpackedCovariance(rest.w & 255u, m.level, m.spread.x, 127.0),
                 unpackedCovariance(rest.w >> 8u & 255u, m.level, m.spread.y, 127.0),
                 unpackedCovariance(rest.w >> 16u & 255u, m.level, m.spread.z, 127.0));
  m.spread_cross =
      vec3(unpackedCovariance(spread_cross & 31u, m.spread.x, m.spread.y, 15.0),
           unpackedCovariance(spread_cross >> 5u & 31u, m.spread.x, m.spread.z, 15.0),
           unpackedCovariance(spread_cross >> 10u & 31u, m.spread.y, m.spread.z, 15.0));
  return m;
}

// sum + weight * m, number by number, as a sampler would mix them.
LinearModel weightedSum(LinearModel sum, LinearModel m, float weight) {
  sum.intercept += weight * m.intercept;
  sum.slope_r += weight * m.slope_r;
  sum.slope_g += weight * m.slope_g;
  sum.slope_b += weight * m.slope_b;
  sum.level += weight * m.level;
  sum.cross += weight * m.cross;
  sum.spread += weight * m.spread;
  sum.spread_cross += weight * m.spread_cross;
  return sum;
}

#endif
