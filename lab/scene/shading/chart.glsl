// SPDX-License-Identifier: MIT
// Resolution chart. uv in metres, 16 x 9 of them; patterns repeat every 1.6 x 0.9 m so that a
// panning camera always sees them. Black and white, unlit, linear values 0.02 and 0.8.
#ifndef REPRISE_LAB_CHART_GLSL
#define REPRISE_LAB_CHART_GLSL

#include "lab/scene/shading/surface_point.glsl"

float chartPattern(vec2 tile_m) {
  const float kTau = 6.28318530718;
  vec2 zone = tile_m - vec2(0.4, 0.45);
  if (dot(zone, zone) < 0.35 * 0.35) {
    // Zone plate: local frequency grows with the radius.
    return 0.5 + 0.5 * cos(kTau * 420.0 * dot(zone, zone));
  }
  vec2 star = tile_m - vec2(1.15, 0.57);
  if (dot(star, star) < 0.26 * 0.26) {
    return sin(36.0 * atan(star.y, star.x)) > 0.0 ? 1.0 : 0.0;
  }
  if (tile_m.y < 0.26 && tile_m.x > 0.8) {
    // Six groups of line pairs, vertical above horizontal, each twice as fine as the one before.
    float group = floor((tile_m.x - 0.8) / 0.8 * 6.0);
    float along = tile_m.y > 0.13 ? tile_m.x : tile_m.y;
    return fract(along * 12.0 * exp2(group)) < 0.5 ? 1.0 : 0.0;
  }
  return 1.0;
}

vec3 shadeChart(SurfacePoint s) {
  vec2 tile_m = fract(s.uv / vec2(1.6, 0.9)) * vec2(1.6, 0.9);
  return vec3(mix(0.02, 0.8, chartPattern(tile_m)));
}

#endif
