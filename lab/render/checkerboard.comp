// SPDX-License-Identifier: MIT
//
// Shades every other pixel of a row, each at its own sample. The rest is written as 0 with alpha 0.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_arithmetic : require

#include "core/workgroup.h"
#include "lab/render/shade_triangle.glsl"
#include "lab/render/work_order.glsl"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

layout(binding = kFirstPassBinding) writeonly uniform image2D color_image;
layout(push_constant) uniform Push {
  CoarseConstants push;
};

void main() {
  uint group_y = everySecond(gl_WorkGroupID.y, gl_NumWorkGroups.y);
  int row = int(group_y * gl_WorkGroupSize.y + gl_LocalInvocationID.y);
  int first = 2 * int(gl_GlobalInvocationID.x);
  ivec2 extent_px = ivec2(frame.extent_px);
  if (row >= extent_px.y || first >= extent_px.x) return;
  // 1: even sums of x and y.
  int shaded = (row + int(push.checkerboard) + 1) & 1;
  ivec2 left_out = ivec2(first + 1 - shaded, row);
  if (left_out.x < extent_px.x) imageStore(color_image, left_out, vec4(0.0));

  shown_light_layers = push.light_layers;
  ivec2 px = ivec2(first + shaded, row);
  bool within = px.x < extent_px.x;
  selectLightTile(px);
  VisibleTriangle seen;
  bool covered = within && fetchTriangle(px, seen);
  vec3 color = background();
  if (covered) color = shadeTriangle(seen, vec2(px) + 0.5 - push.jitter_px);
  countEvaluations(covered ? 1u : 0u);
  if (within) imageStore(color_image, px, vec4(color, 1.0));
}
