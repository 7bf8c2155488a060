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

layout(local_size_x = 64) in;  // kCoarseGroup

// A plane that is seen edge-on runs through infinity within a few pixels: beyond this ratio of view
// depths to the covered pixel a triangle is shaded where it is covered.
const float kFarthestExtrapolation = 4.0;

// Proportional to 1 / view depth of the triangle's plane at a position.
float inverseDepth(VisibleTriangle seen, vec2 sample_px) {
  vec2 ndc = sample_px / frame.extent_px * 2.0 - 1.0;
  return perspectiveSum(clipFromWorld(positionU(seen.triangle.x).xyz, 0u),
                        clipFromWorld(positionU(seen.triangle.y).xyz, 0u),
                        clipFromWorld(positionU(seen.triangle.z).xyz, 0u), ndc);
}

bool isShownIn(uint shown_in, int i) {
  return (shown_in >> i & 1u) != 0u;
}

vec2 middleOf(ivec2 base_px, uint shown_in) {
  vec2 sum_px = vec2(0.0);
  float count = 0.0;
  for (int i = 0; i < kPixels; ++i) {
    if (!isShownIn(shown_in, i)) continue;
    sum_px += vec2(pixelOf(base_px, i)) + 0.5;
    count += 1.0;
  }
  return sum_px / count;
}

void shadeItem(uvec2 item) {
  ivec2 base_px = baseOf(uvec2(item.x & 0xffffu, item.x >> 16));
  uint shown_in = item.y;
  ivec2 first_px = pixelOf(base_px, findLSB(shown_in));
  vec2 sample_px = vec2(base_px) + 0.5 * float(kSize) - push.jitter_px;
  if (push.shade_covered != 0u) sample_px = middleOf(base_px, shown_in) - push.jitter_px;
  selectLightTile(first_px);
  VisibleTriangle seen;
  fetchTriangle(first_px, seen);
  vec2 own_px = vec2(first_px) + 0.5 - push.jitter_px;
  float ratio = inverseDepth(seen, own_px) / inverseDepth(seen, sample_px);
  bool reachable = ratio > 1.0 / kFarthestExtrapolation && ratio < kFarthestExtrapolation;
  vec3 color = shadeTriangle(seen, reachable ? sample_px : own_px);
  for (int i = 0; i < kPixels; ++i) {
    if (isShownIn(shown_in, i)) imageStore(color_image, pixelOf(base_px, i), vec4(color, 1.0));
  }
}

void main() {
  shown_light_layers = push.light_layers;
  uint index = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * kCoarseGroup +
               gl_LocalInvocationIndex;
  if (index >= item_count) return;
  if (index == 0u) atomicAdd(evaluations, item_count);
  shadeItem(items[index]);
}
