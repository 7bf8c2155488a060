// SPDX-License-Identifier: MIT
// A checkered floor of marble that is veined through and through: a net of veins at every scale,
// down to hairs of a millimetre, dark in white slabs and white in black ones. Honed, not polished.
// Textured by world x and z (m). parameters.x: side of a tile (m).
#ifndef REPRISE_LAB_VEINED_MARBLE_GLSL
#define REPRISE_LAB_VEINED_MARBLE_GLSL

#include "lab/scene/shading/lighting.glsl"
#include "lab/scene/shading/marble.glsl"
#include "lab/scene/shading/noise.glsl"
#include "lab/scene/shading/surface_point.glsl"

vec3 veinedMarble(vec2 at_m, float tile_m) {
  vec2 tile = floor(at_m / tile_m);
  vec2 to_edge = tile_m * (0.5 - abs(fract(at_m / tile_m) - 0.5));
  if (min(to_edge.x, to_edge.y) < kMarbleJoint_m) return vec3(0.09, 0.085, 0.08);
  // Every slab is cut from another place.
  uint hash = hashPixel(uint(int(tile.x)), uint(int(tile.y)), 41u);
  vec2 p = at_m + vec2(hash & 1023u, (hash >> 10) & 1023u) * 0.37;
  vec2 warped = p + 0.16 * vec2(valueNoise(p * 5.0, 43u), valueNoise(p * 5.0, 44u)) +
                0.030 * vec2(valueNoise(p * 23.0, 45u), valueNoise(p * 23.0, 46u));
  // Each finer net is denser where a noise of its own lets it be: stone is not veined evenly.
  float veins = vein(warped * 5.0, 0.12, 47u);
  veins = max(veins, 0.9 * vein(warped * 19.0, 0.16, 48u));
  veins = max(veins, vein(warped * 90.0, 0.20, 49u));
  float open = smoothstep(0.20, 0.50, valueNoise(warped * 11.0, 50u));
  veins = max(veins, open * vein(warped * 480.0, 0.30, 51u));
  bool dark = (int(tile.x) + int(tile.y) & 1) != 0;
  vec3 stone = dark ? vec3(0.020, 0.027, 0.025) : vec3(0.86, 0.84, 0.79);
  vec3 ore = dark ? vec3(0.86, 0.86, 0.78) : vec3(0.038, 0.035, 0.039);
  return mix(stone, ore, smoothstep(0.25, 0.55, veins));
}

Appearance veinedMarbleAppearance(SurfacePoint s) {
  return Appearance(s.normal_world, veinedMarble(s.position_world.xz, s.parameters.x), 1.0, 0.0,
                    1.0, vec3(0.0));
}

#endif
