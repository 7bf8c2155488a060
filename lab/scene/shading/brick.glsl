// SPDX-License-Identifier: MIT
// Bricks in running bond. uv in metres.
#ifndef REPRISE_LAB_BRICK_GLSL
#define REPRISE_LAB_BRICK_GLSL

#include "lab/scene/shading/lighting.glsl"
#include "lab/scene/shading/noise.glsl"
#include "lab/scene/shading/surface_point.glsl"

const vec2 kBrick_m = vec2(0.235, 0.077);  // with its joint: 225 x 65 mm brick, 10 mm mortar
const float kJoint_m = 0.010;
const float kBumpStep_m = 0.0006;

struct BrickCell {
  uint hash;
  float inside_m;  // distance to the brick's edge; negative in the mortar
};

BrickCell brickCell(vec2 uv) {
  float row = floor(uv.y / kBrick_m.y);
  float shift = fract(row * 0.5) * kBrick_m.x;
  float column = floor((uv.x + shift) / kBrick_m.x);
  vec2 within = vec2(uv.x + shift, uv.y) - vec2(column, row) * kBrick_m;
  uint hash = hashPixel(uint(int(column)), uint(int(row)), 11u);
  // Each brick is laid a little off, and its edges are worn.
  vec2 slip = (vec2(hash & 255u, (hash >> 8) & 255u) / 255.0 - 0.5) * 0.003;
  vec2 to_edge = 0.5 * (kBrick_m - kJoint_m) - abs(within - 0.5 * kBrick_m - slip);
  float wear = (valueNoise(uv * 90.0, 3u) - 0.5) * 0.005;
  return BrickCell(hash, min(to_edge.x, to_edge.y) + wear);
}

// Height above the joint's bed in metres.
float brickHeight(vec2 uv) {
  BrickCell cell = brickCell(uv);
  float grain = valueNoise(uv * 320.0, 5u);
  if (cell.inside_m < 0.0) return 0.0012 * grain + 0.0008 * valueNoise(uv * 900.0, 7u);
  float rounded = 0.008 * smoothstep(0.0, 0.008, cell.inside_m);
  float pit = smoothstep(0.72, 0.80, valueNoise(uv * 70.0, cell.hash)) * 0.004;
  return rounded - pit + 0.0006 * grain;
}

vec3 brickAlbedo(vec2 uv, BrickCell cell, float footprint) {
  float grain_share = shownShare(320.0, footprint);
  float grain = mix(0.5, valueNoise(uv * 320.0, 5u), grain_share);
  if (cell.inside_m < 0.0) {
    float speckle =
        mix(0.5, latticeValue(ivec2(floor(uv * 700.0)), 9u), shownShare(700.0, footprint));
    return vec3(0.58, 0.55, 0.49) * (0.65 + 0.3 * grain + 0.35 * speckle);
  }
  float shade = float((cell.hash >> 3) & 255u) / 255.0;
  float tint = float((cell.hash >> 13) & 255u) / 255.0;
  vec3 clay = mix(vec3(0.42, 0.11, 0.06), vec3(0.62, 0.30, 0.15), tint);
  if (((cell.hash >> 24) & 7u) == 0u) clay = vec3(0.13, 0.10, 0.11);  // overfired
  if (((cell.hash >> 24) & 15u) == 3u) clay = vec3(0.72, 0.60, 0.42);
  float stain = valueNoise(uv * 9.0, 21u);
  return clay * (0.55 + 0.5 * shade) * (0.7 + 0.45 * grain) * (0.8 + 0.3 * stain);
}

Appearance brickAppearance(SurfacePoint s) {
  BrickCell cell = brickCell(s.uv);
  vec3 albedo = brickAlbedo(s.uv, cell, uvFootprint(s));
  float height = brickHeight(s.uv);
  vec2 slope = vec2(brickHeight(s.uv + vec2(kBumpStep_m, 0.0)) - height,
                    brickHeight(s.uv + vec2(0.0, kBumpStep_m)) - height) /
               kBumpStep_m;
  // Walls are upright: v goes up.
  const vec3 kUp = vec3(0.0, 1.0, 0.0);
  vec3 along_u = normalize(cross(kUp, s.normal_world));
  vec3 normal = normalize(s.normal_world - slope.x * along_u - slope.y * kUp);

  // Glazed bricks glisten, mortar hardly.
  bool mortar = cell.inside_m < 0.0;
  float gloss = mortar ? 12.0 : (((cell.hash >> 24) & 7u) == 0u ? 220.0 : 45.0);
  float reflectance = mortar ? 0.02 : 0.05;
  // Joints and pits see less of the sky.
  float open = clamp(height / 0.008, 0.25, 1.0);
  return Appearance(normal, albedo, open, reflectance, gloss, vec3(0.0));
}

#endif
