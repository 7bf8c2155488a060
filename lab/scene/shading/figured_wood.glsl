// SPDX-License-Identifier: MIT
// Striped, figured wood, oiled: a solid texture that a pixel cannot hold. Dark and light lines run
// along the trunk (zebrano has some ten of each to the centimetre), swing with its figure, and are
// crossed by fibres and pores. No highlight: what aliases is the wood's own colour. After the horse
// of Yang et al. 2009. parameters: rgb colour of the light lines, w: the trunk's axis in the
// instance's space (0: x, 1: y, 2: z).
#ifndef REPRISE_LAB_FIGURED_WOOD_GLSL
#define REPRISE_LAB_FIGURED_WOOD_GLSL

#include "lab/scene/shading/lighting.glsl"
#include "lab/scene/shading/noise.glsl"
#include "lab/scene/shading/object_space.glsl"
#include "lab/scene/shading/surface_point.glsl"

const float kFiguredYears_per_m = 34.0;
const float kFiguredLines_per_m = 560.0;
const float kFiguredFibres_per_m = 1300.0;  // across; far fewer along

Appearance figuredWoodAppearance(SurfacePoint s) {
  vec3 p = positionObject(s);
  // z along the trunk.
  p = s.parameters.w < 0.5 ? p.yzx : (s.parameters.w < 1.5 ? p.zxy : p);
  // The figure: the trunk leans to and fro along its height, and a finer curl with it.
  float sway = 0.050 * valueNoise(p * vec3(6.0, 6.0, 3.1), 33u) +
               0.006 * valueNoise(p * vec3(40.0, 40.0, 22.0), 34u);
  // Its heart lies outside the piece, so that lines run out at curved surfaces.
  float out_m = length(p.xy + vec2(0.09, 0.14)) + sway;
  float year = fract(out_m * kFiguredYears_per_m);
  // Late wood closes each year, and its lines stand closer.
  float late = smoothstep(0.15, 0.85, year) * (1.0 - smoothstep(0.90, 1.0, year));
  float line_at = out_m * kFiguredLines_per_m;
  float wavering = valueNoise(vec3(line_at, p.z * 16.0, p.x * 16.0), 31u);
  float fibre = valueNoise(p * vec3(kFiguredFibres_per_m, kFiguredFibres_per_m, 55.0), 35u);
  float dark = smoothstep(0.40, 0.60, 0.62 * wavering + 0.38 * fibre + 0.22 * (late - 0.5));
  float pores = smoothstep(0.72, 0.78, valueNoise(p * vec3(700.0, 700.0, 26.0), 36u));
  vec3 albedo = s.parameters.rgb * mix(vec3(1.0), vec3(0.085, 0.058, 0.042), dark);
  albedo *= 1.0 - 0.6 * pores;
  return Appearance(s.normal_world, albedo, 1.0, 0.0, 1.0, vec3(0.0));
}

#endif
