// SPDX-License-Identifier: MIT
// Glazed cells in raised relief, a solid texture. parameters.x: cells a metre, y: height of a cell
// (m), z: 0 coloured glaze, 1 grey stone.
#ifndef REPRISE_LAB_CELLS_GLSL
#define REPRISE_LAB_CELLS_GLSL

#include "equations/hash.h"
#include "lab/scene/shading/lighting.glsl"
#include "lab/scene/shading/object_space.glsl"
#include "lab/scene/shading/surface_point.glsl"
#include "lab/scene/shading/voronoi.glsl"

// Glaze is never flat: ripples of that many a metre.
const float kRipples_per_m = 62.0;
const float kRippleHeight_m = 0.00045;

Appearance cellsAppearance(SurfacePoint s) {
  vec3 p = positionObject(s);
  VoronoiCell cell = voronoiCell(p * s.parameters.x);
  // A cell is a low dome: height grows from its border as a smoothstep does, to its full over 0.4.
  float t = clamp(cell.edge / 0.4, 0.0, 1.0);
  float dome = t * t * (3.0 - 2.0 * t);
  float slope = 6.0 * t * (1.0 - t) / 0.4 * s.parameters.x;
  vec3 k = p * (6.2831853 * kRipples_per_m);
  vec3 ripples = kRippleHeight_m * 6.2831853 * kRipples_per_m *
                 vec3(cos(k.x) * sin(k.y), cos(k.y) * sin(k.z), cos(k.z) * sin(k.x));
  vec3 gradient = s.parameters.y * slope * cell.edge_gradient + dome * ripples;

  float shade = float(cell.hash >> 24) / 255.0;
  float tint = float((cell.hash >> 16) & 255u) / 255.0;
  // Hues of old glazes: from copper red over honey to celadon and cobalt.
  vec3 glaze = 0.5 + 0.5 * cos(6.2831853 * (tint + vec3(0.0, 0.36, 0.62)));
  glaze = mix(glaze, vec3(0.75, 0.70, 0.60), 0.30) * (0.35 + 0.65 * shade);
  vec3 stone = mix(vec3(0.20, 0.19, 0.185), vec3(0.36, 0.34, 0.31), shade);
  bool is_stone = s.parameters.z > 0.5;
  vec3 grout = vec3(0.045, 0.040, 0.038);
  float on_cell = smoothstep(0.02, 0.07, cell.edge);
  Appearance a;
  a.normal_world = bumpedNormal(s, gradient);
  a.albedo = mix(grout, is_stone ? stone : glaze, on_cell);
  a.open = 0.35 + 0.65 * dome;
  a.reflectance = (is_stone ? 0.03 : 0.09) * on_cell + 0.005;
  a.gloss = is_stone ? 60.0 : 180.0;
  a.mirror = vec3(0.0);
  return a;
}

#endif
