// SPDX-License-Identifier: MIT
// The one list of materials: a file and a line each.
#ifndef REPRISE_LAB_SHADING_LIST_GLSL
#define REPRISE_LAB_SHADING_LIST_GLSL

#include "lab/scene/shading/brick.glsl"
#include "lab/scene/shading/chart.glsl"
#include "lab/scene/shading/marble.glsl"
#include "lab/scene/shading/wood.glsl"

// Bit k: materials of kind k occur. CPU drivers run every branch that is compiled in.
layout(constant_id = 0) const uint kKinds = 0xffffffffu;

bool isKind(uint kind, uint wanted) {
  return (kKinds & (1u << wanted)) != 0u && kind == wanted;
}

vec3 shadeMaterial(uint kind, SurfacePoint s) {
  if (isKind(kind, kMaterialChart)) return shadeChart(s);
  if (isKind(kind, kMaterialBrick)) return shadeBrick(s);
  if (isKind(kind, kMaterialWood)) return shadeWood(s);
  if (isKind(kind, kMaterialMarble)) return shadeMarble(s);
  return vec3(0.0);
}

#endif
