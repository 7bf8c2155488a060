// SPDX-License-Identifier: MIT
// Polished checkered marble with veins; a floor: textured by world x and z (m).
// parameters.x: side of a tile (m), y: tilt of its waves (rad), z: waves a metre, w: share
// mirrored.
#ifndef REPRISE_LAB_MARBLE_GLSL
#define REPRISE_LAB_MARBLE_GLSL

#include "lab/scene/shading/lighting.glsl"
#include "lab/scene/shading/noise.glsl"
#include "lab/scene/shading/surface_point.glsl"

const float kMarbleJoint_m = 0.0035;

// Veins are where a noise crosses its middle: 1 there, 0 from `width` of its range away.
float vein(vec2 p, float width, uint seed) {
  return 1.0 - smoothstep(0.0, width, abs(valueNoise(p, seed) - 0.5));
}

struct Marble {
  vec3 albedo;
  float polish;  // 1 on stone, 0 in joints
};

Marble checkeredMarble(vec2 at_m, float tile_m) {
  vec2 tile = floor(at_m / tile_m);
  vec2 to_edge = tile_m * (0.5 - abs(fract(at_m / tile_m) - 0.5));
  if (min(to_edge.x, to_edge.y) < kMarbleJoint_m) return Marble(vec3(0.09, 0.085, 0.08), 0.0);
  // Every slab is cut from another place.
  uint hash = hashPixel(uint(int(tile.x)), uint(int(tile.y)), 41u);
  vec2 p = at_m + vec2(hash & 1023u, (hash >> 10) & 1023u) * 0.37;
  vec2 warped = p + 0.16 * vec2(valueNoise(p * 5.0, 43u), valueNoise(p * 5.0, 44u)) +
                0.035 * valueNoise(p * 21.0, 45u);
  float coarse = vein(warped * 4.5, 0.07, 47u);
  float fine = vein(warped * 17.0, 0.09, 48u);
  float hair = vein(warped * 60.0, 0.13, 49u);
  float veins = clamp(coarse + 0.6 * fine + 0.4 * hair, 0.0, 1.0);
  bool dark = (int(tile.x) + int(tile.y) & 1) != 0;
  vec3 stone = dark ? vec3(0.030, 0.042, 0.038) : vec3(0.80, 0.78, 0.73);
  vec3 ore = dark ? vec3(0.50, 0.53, 0.46) : vec3(0.25, 0.22, 0.21);
  float cloud = 0.85 + 0.3 * valueNoise(warped * 9.0, 50u);
  return Marble(mix(stone * cloud, ore, veins), 1.0);
}

Appearance marbleAppearance(SurfacePoint s) {
  vec2 at_m = s.position_world.xz;
  Marble marble = checkeredMarble(at_m, s.parameters.x);
  // Polished by hand: low waves.
  vec2 wave = at_m * s.parameters.z;
  vec2 tilt = vec2(valueNoise(wave, 51u), valueNoise(wave, 52u)) - 0.5;
  vec3 normal = normalize(s.normal_world + s.parameters.y * vec3(tilt.x, 0.0, tilt.y));
  return Appearance(normal, marble.albedo, 0.5 + 0.5 * marble.polish, 0.06 * marble.polish, 260.0,
                    vec3(s.parameters.w * marble.polish));
}

#endif
