// SPDX-License-Identifier: MIT
//
// What every pass that shades shares: the surface of a triangle at a screen position, turned into
// light by its material.
#ifndef REPRISE_LAB_SHADE_TRIANGLE_GLSL
#define REPRISE_LAB_SHADE_TRIANGLE_GLSL

#include "lab/render/scene_buffers.glsl"

layout(binding = 4, std430) readonly buffer Materials {
  GpuMaterial materials[];
};
layout(binding = 5, std430) buffer Counter {
  uint evaluations;
};
layout(binding = 6) uniform samplerBuffer object_texels;  // GpuVertex in the instance's space
layout(binding = 7, std430) readonly buffer Transforms {
  mat4 transforms[];
};

const uint kSamplerBinding = kShadeSamplerBinding;
#include "lab/render/lamps.glsl"
#include "lab/render/shadow.glsl"
#include "lab/render/textures.glsl"
#include "lab/scene/shading/shading_list.glsl"

// The kind of a scene's only material; -1: several, looked up for each triangle.
layout(constant_id = 2) const int kOnlyKind = -1;

#include "lab/render/background.h"

SurfacePoint surfaceAt(VisibleTriangle seen, vec2 sample_px) {
  uvec4 triangle = seen.triangle;
  vec4 position_u0 = positionU(triangle.x);
  vec4 position_u1 = positionU(triangle.y);
  vec4 position_u2 = positionU(triangle.z);
  vec4 normal_v0 = normalV(triangle.x);
  vec4 normal_v1 = normalV(triangle.y);
  vec4 normal_v2 = normalV(triangle.z);
  vec3 p0 = position_u0.xyz;
  vec3 p1 = position_u1.xyz;
  vec3 p2 = position_u2.xyz;
  vec2 ndc = sample_px / frame.extent_px * 2.0 - 1.0;
  vec2 ndc_a_px = 2.0 / frame.extent_px;
  Barycentrics at =
      barycentricsAt(clipFromWorld(p0, 0u), clipFromWorld(p1, 0u), clipFromWorld(p2, 0u), ndc);

  SurfacePoint s;
  s.position_world = interpolate(at.b, p0, p1, p2);
  s.position_dx_world = interpolate(at.b_dx, p0, p1, p2) * ndc_a_px.x;
  s.position_dy_world = interpolate(at.b_dy, p0, p1, p2) * ndc_a_px.y;
  s.to_eye_world = normalize(frame.eye_world.xyz - s.position_world);
  vec3 normal = normalize(interpolate(at.b, normal_v0.xyz, normal_v1.xyz, normal_v2.xyz));
  s.normal_world = dot(normal, s.to_eye_world) < 0.0 ? -normal : normal;
  vec2 uv0 = vec2(position_u0.w, normal_v0.w);
  vec2 uv1 = vec2(position_u1.w, normal_v1.w);
  vec2 uv2 = vec2(position_u2.w, normal_v2.w);
  s.uv = interpolate(at.b, uv0, uv1, uv2);
  s.uv_dx = interpolate(at.b_dx, uv0, uv1, uv2) * ndc_a_px.x;
  s.uv_dy = interpolate(at.b_dy, uv0, uv1, uv2) * ndc_a_px.y;
  s.mip_bias = frame.mip_bias;
  s.vertices = triangle.xyz;
  s.barycentrics = at.b;
  s.instance = seen.instance;
  s.material = triangle.w;
  return s;
}

vec3 shadeTriangle(VisibleTriangle seen, vec2 sample_px) {
  SurfacePoint s = surfaceAt(seen, sample_px);
  uint kind = uint(kOnlyKind);
  if (kOnlyKind < 0) {
    s.parameters = materials[seen.triangle.w].parameters;
    kind = materials[seen.triangle.w].kind;
  } else {
    s.parameters = materials[0].parameters;
  }
  return shadeMaterial(kind, s);
}

// What a pass shows where no surface is.
vec3 background() {
  return (shown_light_layers & kLightLayerMain) != 0u ? kBackground : vec3(0.0);
}

// Once an invocation of the whole subgroup.
void countEvaluations(uint mine) {
  uint count = subgroupAdd(mine);
  if (subgroupElect() && count > 0u) atomicAdd(evaluations, count);
}

#endif
