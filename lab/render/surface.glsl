// SPDX-License-Identifier: MIT
//
// The one function from which everything that a paper asks of a renderer follows: the surface of a
// triangle at any screen position, with exact derivatives.
#ifndef REPRISE_LAB_SURFACE_GLSL
#define REPRISE_LAB_SURFACE_GLSL

// Perspective-correct barycentrics at a position in NDC, and their derivatives by NDC. With
// clip-space corners c_i = (x, y, w), the barycentrics solve  sum b_i c_i = s (ndc.x, ndc.y, 1) for
// some s, so
//   b_i ~ dot(cross(c_j, c_k), (ndc, 1)),
// normalized to sum 1. Corners behind the eye need no clipping.
struct Barycentrics {
  vec3 b;
  vec3 b_dx;  // d b / d ndc.x
  vec3 b_dy;
};

Barycentrics barycentricsAt(vec4 clip_0, vec4 clip_1, vec4 clip_2, vec2 ndc) {
  vec3 e0 = cross(clip_1.xyw, clip_2.xyw);
  vec3 e1 = cross(clip_2.xyw, clip_0.xyw);
  vec3 e2 = cross(clip_0.xyw, clip_1.xyw);
  vec3 q = vec3(ndc, 1.0);
  vec3 raw = vec3(dot(e0, q), dot(e1, q), dot(e2, q));
  vec3 raw_dx = vec3(e0.x, e1.x, e2.x);
  vec3 raw_dy = vec3(e0.y, e1.y, e2.y);
  float sum = raw.x + raw.y + raw.z;
  float sum_dx = raw_dx.x + raw_dx.y + raw_dx.z;
  float sum_dy = raw_dy.x + raw_dy.y + raw_dy.z;
  vec3 b = raw / sum;
  return Barycentrics(b, (raw_dx - b * sum_dx) / sum, (raw_dy - b * sum_dy) / sum);
}

// The sum of the unnormalized barycentrics: proportional to 1 / view depth of the triangle's plane.
float perspectiveSum(vec4 clip_0, vec4 clip_1, vec4 clip_2, vec2 ndc) {
  vec3 q = vec3(ndc, 1.0);
  return dot(
      cross(clip_1.xyw, clip_2.xyw) + cross(clip_2.xyw, clip_0.xyw) + cross(clip_0.xyw, clip_1.xyw),
      q);
}

vec3 interpolate(vec3 b, vec3 a0, vec3 a1, vec3 a2) {
  return a0 * b.x + a1 * b.y + a2 * b.z;
}
vec2 interpolate(vec3 b, vec2 a0, vec2 a1, vec2 a2) {
  return a0 * b.x + a1 * b.y + a2 * b.z;
}

#endif
