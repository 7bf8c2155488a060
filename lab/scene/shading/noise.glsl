// SPDX-License-Identifier: MIT
// Procedural noise of integer lattices.
#ifndef REPRISE_LAB_NOISE_GLSL
#define REPRISE_LAB_NOISE_GLSL

#include "equations/hash.h"

float latticeValue(ivec2 cell, uint seed) {
  return unitFloat(hashPcg(uint(cell.x) * 1597334677u ^ uint(cell.y) * 3812015801u ^ seed));
}

float latticeValue(ivec3 cell, uint seed) {
  return latticeValue(cell.xy, seed ^ (uint(cell.z) * 2246822519u));
}

// Value noise in [0, 1] with a cubic fade; one feature a unit.
float valueNoise(vec2 p, uint seed) {
  vec2 base = floor(p);
  vec2 f = p - base;
  f = f * f * (3.0 - 2.0 * f);
  ivec2 cell = ivec2(base);
  float bottom = mix(latticeValue(cell, seed), latticeValue(cell + ivec2(1, 0), seed), f.x);
  float top =
      mix(latticeValue(cell + ivec2(0, 1), seed), latticeValue(cell + ivec2(1, 1), seed), f.x);
  return mix(bottom, top, f.y);
}

float valueNoise(vec3 p, uint seed) {
  vec3 base = floor(p);
  vec3 f = p - base;
  f = f * f * (3.0 - 2.0 * f);
  ivec3 cell = ivec3(base);
  vec4 near =
      vec4(latticeValue(cell, seed), latticeValue(cell + ivec3(1, 0, 0), seed),
           latticeValue(cell + ivec3(0, 1, 0), seed), latticeValue(cell + ivec3(1, 1, 0), seed));
  vec4 far =
      vec4(latticeValue(cell + ivec3(0, 0, 1), seed), latticeValue(cell + ivec3(1, 0, 1), seed),
           latticeValue(cell + ivec3(0, 1, 1), seed), latticeValue(cell + ivec3(1, 1, 1), seed));
  vec4 plane = mix(near, far, f.z);
  return mix(mix(plane.x, plane.y, f.x), mix(plane.z, plane.w, f.x), f.y);
}

// Share of a pattern of `frequency` (features a unit of uv) that a pixel of that footprint shows;
// the rest is its mean. Full up to half a feature a pixel, none above one and a half.
float shownShare(float frequency, float footprint) {
  return clamp(1.5 - frequency * footprint, 0.0, 1.0);
}

#endif
