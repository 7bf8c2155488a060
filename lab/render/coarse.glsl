// SPDX-License-Identifier: MIT
//
// What the two passes of coarse pixel shading share: the grid, and the list of what is to be
// shaded.
#ifndef REPRISE_LAB_COARSE_GLSL
#define REPRISE_LAB_COARSE_GLSL

#include "lab/render/coarse_list.h"
#include "lab/render/shade_triangle.glsl"
#include "lab/render/coarse_pixel.glsl"

// As vkCmdDispatchIndirect reads it; then how many items all strips have, and each; then the items:
// a coarse pixel (x, y from bit 16), and those of its pixels that show one triangle.
layout(binding = kFirstPassBinding + 1u, std430) buffer Items {
  uint groups_x;
  uint groups_y;
  uint groups_z;
  uint item_count;
  uint strip_counts[kStrips];
  uvec2 items[];  // of each strip from stripBegin() on
};

layout(binding = kFirstPassBinding) writeonly uniform image2D color_image;
layout(push_constant) uniform Push {
  CoarseConstants push;
};

uint stripBegin(uint strip) {
  uvec2 extent_px = uvec2(frame.extent_px);
  return strip * stripCapacity(extent_px.x, extent_px.y, uint(kSize));
}

ivec2 baseOf(uvec2 coarse_pixel) {
  ivec2 origin_px = ivec2(push.origin_x_px, push.origin_y_px);
  // The first coarse pixels may begin outside the frame.
  return origin_px - kSize * ivec2(greaterThan(origin_px, ivec2(0))) + kSize * ivec2(coarse_pixel);
}

#endif
