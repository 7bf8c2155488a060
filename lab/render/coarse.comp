// SPDX-License-Identifier: MIT
//
// Coarse pixel shading as hardware does it (Vaidyanathan et al. 2014): visibility at every pixel,
// one evaluation for a coarse pixel and each triangle in it, at the coarse pixel's centre, also
// where the triangle does not cover that.
//
// One invocation an item of coarse_list.comp's, of which few coarse pixels have more than one:
// shaded by the coarse pixels themselves, these would each hold up a whole subgroup.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_arithmetic : require

#include "lab/render/coarse.glsl"
#include "lab/render/work_order.glsl"

layout(local_size_x = 64) in;  // kCoarseGroup

void shadeItem(uvec2 item) {
  ivec2 base_px = baseOf(uvec2(item.x & 0xffffu, item.x >> 16));
  uint shown_in = item.y;
  ivec2 first_px = pixelOf(base_px, findLSB(shown_in));
  selectLightTile(tilePixelOf(base_px, shown_in));
  VisibleTriangle seen;
  fetchTriangle(first_px, seen);
  vec2 sample_px =
      coarsePosition(seen, base_px, shown_in, push.jitter_px, push.shade_covered != 0u);
  vec3 color = shadeTriangle(seen, sample_px);
  for (int i = 0; i < kPixels; ++i) {
    if (isShownIn(shown_in, i)) imageStore(color_image, pixelOf(base_px, i), vec4(color, 1.0));
  }
}

// A workgroup's strip, and which of its workgroups it is.
uvec2 placeOf(uint group) {
  uvec2 place = uvec2(0u, group);
  uint before = 0u;
  for (uint i = 1u; i < kStrips; ++i) {
    before += (strip_counts[i - 1u] + kCoarseGroup - 1u) / kCoarseGroup;
    if (group >= before) place = uvec2(i, group - before);
  }
  return place;
}

void main() {
  shown_light_layers = push.light_layers;
  uint groups = gl_NumWorkGroups.x * gl_NumWorkGroups.y;
  uint group = everySecond(gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x, groups);
  if (group == 0u && gl_LocalInvocationIndex == 0u) atomicAdd(evaluations, item_count);
  uvec2 place = placeOf(group);
  uint index = place.y * kCoarseGroup + gl_LocalInvocationIndex;
  if (index >= strip_counts[place.x]) return;
  shadeItem(items[stripBegin(place.x) + index]);
}
