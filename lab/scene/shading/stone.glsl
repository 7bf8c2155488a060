// SPDX-License-Identifier: MIT
// Polished courses of stone about the instance's y axis. parameters.x: radius (m) at which a stone
// has its nominal width, y: height of a course, z: width of a stone.
#ifndef REPRISE_LAB_STONE_GLSL
#define REPRISE_LAB_STONE_GLSL

#include "equations/hash.h"
#include "lab/scene/shading/lighting.glsl"
#include "lab/scene/shading/noise.glsl"
#include "lab/scene/shading/object_space.glsl"

const float kStoneRelief_m = 0.006;
const float kStoneRound_m = 0.012;  // how far from its edge a stone is rounded

Appearance stoneAppearance(SurfacePoint s) {
  vec3 p = positionObject(s);
  float radius = max(length(p.xz), 1.0e-4);
  // Whole stones around: the course closes.
  float around = max(round(6.2831853 * s.parameters.x / s.parameters.z), 1.0);
  float course = floor(p.y / s.parameters.y);
  float turn = (atan(p.z, p.x) / 6.2831853 + 0.5) * around + fract(0.5 * course);
  float column = floor(turn);
  // From the stone's middle, in metres at the nominal radius; to its edge along both ways.
  vec2 within = vec2((turn - column - 0.5) * s.parameters.z, p.y - (course + 0.5) * s.parameters.y);
  vec2 to_edge = 0.5 * s.parameters.zy - abs(within);
  vec2 share = clamp(to_edge / kStoneRound_m, 0.0, 1.0);
  vec2 rounded = share * (2.0 - share);
  // Gradient of relief * rounded.x * rounded.y, along the circle and up.
  vec2 slope = kStoneRelief_m / kStoneRound_m * (2.0 - 2.0 * share) * rounded.yx * -sign(within);
  vec3 circle = vec3(-p.z, 0.0, p.x) / radius;
  float grain = valueNoise(p * 300.0, 61u);
  vec3 gradient = slope.x * (s.parameters.x / radius) * circle + vec3(0.0, slope.y, 0.0);

  uint hash = hashPixel(uint(int(column) % int(around)), uint(int(course)), 63u);
  float shade = unitFloat(hash);
  vec3 stone = mix(vec3(0.26, 0.28, 0.31), vec3(0.52, 0.48, 0.40), shade) * (0.75 + 0.5 * grain);
  float on_stone = smoothstep(0.12, 0.35, rounded.x * rounded.y);
  return Appearance(bumpedNormal(s, gradient), mix(vec3(0.10, 0.095, 0.09), stone, on_stone),
                    0.5 + 0.5 * on_stone, 0.07 * on_stone, 160.0, vec3(0.55 * on_stone));
}

#endif
