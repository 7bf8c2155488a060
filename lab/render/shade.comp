// SPDX-License-Identifier: MIT
//
// Shades the surface that visibility saw in each pixel, at a position of our choice.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_arithmetic : require

#include "core/workgroup.h"
#include "equations/shading_offset.h"
#include "lab/render/shade_triangle.glsl"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

// 1: add to the sum image; 0: write the colour image.
layout(constant_id = 1) const uint kAccumulate = 0u;

layout(binding = kFirstPassBinding) writeonly uniform image2D color_image;
layout(binding = kFirstPassBinding + 1u, rgba32f) uniform image2D sum_image;
layout(push_constant) uniform Push {
  ShadeConstants push;
};

void main() {
  ivec2 px = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(px, ivec2(frame.extent_px)))) return;

  shown_light_layers = push.light_layers;
  vec2 sample_px = vec2(px) + 0.5;
  if (push.unjitter == 0u) sample_px -= push.jitter_px;
  if (push.offset_on != 0u) {
    sample_px += shadingOffset(uint(px.x), uint(px.y), push.offset_seed, push.offset_sigma_px,
                               push.offset_quadrant);
  }
  selectLightTile(px);
  VisibleTriangle seen;
  bool covered = fetchTriangle(px, seen);
  vec3 color = background();
  if (covered) color = shadeTriangle(seen, sample_px);

  countEvaluations(covered ? 1u : 0u);
  if (kAccumulate != 0u) {
    imageStore(sum_image, px, imageLoad(sum_image, px) + vec4(color, 1.0));
  } else {
    imageStore(color_image, px, vec4(color, 1.0));
  }
}
