// SPDX-License-Identifier: MIT
// The one list of materials: a file and a line each.
#ifndef REPRISE_LAB_SHADING_LIST_GLSL
#define REPRISE_LAB_SHADING_LIST_GLSL

#include "lab/scene/shading/brick.glsl"
#include "lab/scene/shading/cells.glsl"
#include "lab/scene/shading/chart.glsl"
#include "lab/scene/shading/figured_wood.glsl"
#include "lab/scene/shading/glazed.glsl"
#include "lab/scene/shading/hangar.glsl"
#include "lab/scene/shading/leaf.glsl"
#include "lab/scene/shading/marble.glsl"
#include "lab/scene/shading/room.glsl"
#include "lab/scene/shading/rust.glsl"
#include "lab/scene/shading/stone.glsl"
#include "lab/scene/shading/textured.glsl"
#include "lab/scene/shading/veined_marble.glsl"
#include "lab/scene/shading/wood.glsl"

// Bit k: materials of kind k occur. CPU drivers run every branch that is compiled in.
layout(constant_id = 0) const uint kKinds = 0xffffffffu;

bool isKind(uint kind, uint wanted) {
  return (kKinds & (1u << wanted)) != 0u && kind == wanted;
}

// Kinds that say what they are (Appearance) and share one evaluation of the lights, and those of
// them that may mirror the room.
const uint kLitKinds = (1u << kMaterialBrick) | (1u << kMaterialWood) | (1u << kMaterialMarble) |
                       (1u << kMaterialCells) | (1u << kMaterialGlazed) | (1u << kMaterialStone) |
                       (1u << kMaterialRust) | (1u << kMaterialFiguredWood) |
                       (1u << kMaterialVeinedMarble);
const uint kRoomKinds = (1u << kMaterialGlazed) | (1u << kMaterialStone);

vec3 shadeMaterial(uint kind, SurfacePoint s) {
  if (isKind(kind, kMaterialChart)) return shadeChart(s);
  if (isKind(kind, kMaterialTextured)) return shadeTextured(s);
  if (isKind(kind, kMaterialLeaf)) return shadeLeaf(s);
  if (isKind(kind, kMaterialHangar)) return shadeHangar(s);
  if ((kKinds & kLitKinds) == 0u) return vec3(0.0);

  Appearance a = Appearance(s.normal_world, vec3(0.0), 0.0, 0.0, 1.0, vec3(0.0));
  if (isKind(kind, kMaterialBrick)) a = brickAppearance(s);
  if (isKind(kind, kMaterialWood)) a = woodAppearance(s);
  if (isKind(kind, kMaterialMarble)) a = marbleAppearance(s);
  if (isKind(kind, kMaterialCells)) a = cellsAppearance(s);
  if (isKind(kind, kMaterialGlazed)) a = glazedAppearance(s);
  if (isKind(kind, kMaterialStone)) a = stoneAppearance(s);
  if (isKind(kind, kMaterialRust)) a = rustAppearance(s);
  if (isKind(kind, kMaterialFiguredWood)) a = figuredWoodAppearance(s);
  if (isKind(kind, kMaterialVeinedMarble)) a = veinedMarbleAppearance(s);
  vec3 color = litSurface(s, a);
  if ((kKinds & kRoomKinds) != 0u) {
    vec3 mirrored = a.mirror * roomMirrored(s, a.normal_world);
    color += mirrored;
    shown_gleam += mirrored;
  }
  return color;
}

#endif
