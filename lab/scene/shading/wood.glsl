// SPDX-License-Identifier: MIT
// Varnished wood with growth rings, a solid texture. parameters: rgb colour between the rings, w:
// the trunk's axis in the instance's space (0: x, 1: y, 2: z).
#ifndef REPRISE_LAB_WOOD_GLSL
#define REPRISE_LAB_WOOD_GLSL

#include "lab/scene/shading/lighting.glsl"
#include "lab/scene/shading/noise.glsl"
#include "lab/scene/shading/object_space.glsl"
#include "lab/scene/shading/surface_point.glsl"

const float kRings_per_m = 70.0;
const float kFibres_per_m = 420.0;  // across; far fewer along
const float kWoodStep_m = 0.0004;

// x: 0 early wood to 1 late wood, with the hard edge where a year ends; y: fibres.
vec2 woodGrain(vec3 p, float wobble) {
  // The heart of the trunk lies outside the piece, so that rings run out at curved surfaces.
  float years = (length(p.xy + vec2(0.09, 0.14)) + wobble) * kRings_per_m;
  float ring = fract(years);
  // Good years and bad ones.
  float strength = 0.35 + 0.65 * latticeValue(ivec2(int(floor(years)), 0), 37u);
  float late = strength * smoothstep(0.2, 0.88, ring) * (1.0 - smoothstep(0.88, 1.0, ring));
  return vec2(late, valueNoise(p * vec3(kFibres_per_m, kFibres_per_m, 26.0), 31u));
}

float woodHeight(vec2 grain) {
  return 0.0007 * grain.x + 0.0007 * grain.y;
}

Appearance woodAppearance(SurfacePoint s) {
  vec3 p = positionObject(s);
  // z along the trunk.
  bool along_x = s.parameters.w < 0.5;
  bool along_y = s.parameters.w < 1.5;
  p = along_x ? p.yzx : (along_y ? p.zxy : p);
  float wobble = 0.060 * valueNoise(p * vec3(5.5, 5.5, 2.4), 33u);
  vec2 grain = woodGrain(p, wobble);
  float height = woodHeight(grain);
  vec3 gradient = vec3(woodHeight(woodGrain(p + vec3(kWoodStep_m, 0.0, 0.0), wobble)),
                       woodHeight(woodGrain(p + vec3(0.0, kWoodStep_m, 0.0), wobble)), height) -
                  height;
  gradient /= kWoodStep_m;
  gradient = along_x ? gradient.zxy : (along_y ? gradient.yzx : gradient);

  float pores = smoothstep(0.70, 0.78, valueNoise(p * vec3(260.0, 260.0, 14.0), 35u));
  vec3 albedo = s.parameters.rgb * mix(vec3(1.25, 1.2, 1.1), vec3(0.42, 0.33, 0.26), grain.x);
  albedo *= (0.72 + 0.5 * grain.y) * (1.0 - 0.45 * pores);
  return Appearance(bumpedNormal(s, gradient), albedo, 1.0, 0.05, 70.0, vec3(0.0));
}

#endif
