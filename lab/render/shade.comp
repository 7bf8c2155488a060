// SPDX-License-Identifier: MIT
//
// Shades the surface that visibility saw in each pixel, at a position of our choice.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_ballot : require

#include "core/workgroup.h"
#include "equations/shading_offset.h"
#include "lab/render/scene_buffers.glsl"
#include "lab/scene/shading/brick.glsl"
#include "lab/scene/shading/chart.glsl"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

// Bit k: materials of kind k occur. CPU drivers run every branch that is compiled in.
layout(constant_id = 0) const uint kKinds = 0xffffffffu;
// 1: add to the sum image; 0: write the colour image.
layout(constant_id = 1) const uint kAccumulate = 0u;

layout(binding = 5, std430) readonly buffer Materials { GpuMaterial materials[]; };
layout(binding = 6, std430) readonly buffer InstanceMaterials { uint instance_materials[]; };
layout(binding = 7) writeonly uniform image2D color_image;
layout(binding = 8, rgba32f) uniform image2D sum_image;
layout(binding = 9, std430) buffer Counter { uint evaluations; };
layout(push_constant) uniform Push { ShadeConstants push; };

// Seen where there is no surface: a dull sky, linear.
const vec3 kBackground = vec3(0.18, 0.24, 0.33);

bool occurs(uint kind) { return (kKinds & (1u << kind)) != 0u; }

vec3 shadeTriangle(Triangle triangle, vec2 sample_px) {
  GpuVertex v0 = vertices[triangle.vertices.x];
  GpuVertex v1 = vertices[triangle.vertices.y];
  GpuVertex v2 = vertices[triangle.vertices.z];
  mat4 model = transformOf(triangle.instance, 0u);
  vec3 p0 = (model * vec4(v0.position_u.xyz, 1.0)).xyz;
  vec3 p1 = (model * vec4(v1.position_u.xyz, 1.0)).xyz;
  vec3 p2 = (model * vec4(v2.position_u.xyz, 1.0)).xyz;
  mat4 vp = frame.view_projection[0];
  vec2 ndc = sample_px / frame.extent_px * 2.0 - 1.0;
  Barycentrics at = barycentricsAt(vp * vec4(p0, 1.0), vp * vec4(p1, 1.0), vp * vec4(p2, 1.0), ndc);

  SurfacePoint s;
  s.position_world = interpolate(at.b, p0, p1, p2);
  s.to_eye_world = normalize(frame.eye_world.xyz - s.position_world);
  vec3 normal = interpolate(at.b, v0.normal_v.xyz, v1.normal_v.xyz, v2.normal_v.xyz);
  // Scenes scale uniformly, so that normals turn as positions do.
  normal = normalize(mat3(model) * normal);
  s.normal_world = dot(normal, s.to_eye_world) < 0.0 ? -normal : normal;
  vec2 uv0 = vec2(v0.position_u.w, v0.normal_v.w);
  vec2 uv1 = vec2(v1.position_u.w, v1.normal_v.w);
  vec2 uv2 = vec2(v2.position_u.w, v2.normal_v.w);
  s.uv = interpolate(at.b, uv0, uv1, uv2);
  s.uv_dx = interpolate(at.b_dx, uv0, uv1, uv2) * (2.0 / frame.extent_px.x);
  s.uv_dy = interpolate(at.b_dy, uv0, uv1, uv2) * (2.0 / frame.extent_px.y);
  s.mip_bias = frame.mip_bias;
  GpuMaterial material = materials[instance_materials[triangle.instance]];
  s.parameters = material.parameters;
  if (occurs(kMaterialChart) && material.kind == kMaterialChart) return shadeChart(s);
  if (occurs(kMaterialBrick) && material.kind == kMaterialBrick) return shadeBrick(s, frame.light);
  return vec3(0.0);
}

void main() {
  ivec2 px = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(px, ivec2(frame.extent_px)))) return;

  vec2 sample_px = vec2(px) + 0.5;
  if (push.unjitter == 0u) sample_px -= push.jitter_px;
  if (push.offset_on != 0u) {
    sample_px += shadingOffset(uint(px.x), uint(px.y), push.offset_seed, push.offset_sigma_px,
                               push.offset_quadrant);
  }
  Triangle triangle;
  bool covered = fetchTriangle(px, triangle);
  vec3 color = kBackground;
  if (covered) color = shadeTriangle(triangle, sample_px);

  uint count = subgroupBallotBitCount(subgroupBallot(covered));
  if (subgroupElect() && count > 0u) atomicAdd(evaluations, count);
  if (kAccumulate != 0u) {
    imageStore(sum_image, px, imageLoad(sum_image, px) + vec4(color, 1.0));
  } else {
    imageStore(color_image, px, vec4(color, 1.0));
  }
}
