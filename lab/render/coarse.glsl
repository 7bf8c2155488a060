// SPDX-License-Identifier: MIT
//
// What the two passes of coarse pixel shading share: the grid, and the list of what is to be
// shaded.
#ifndef REPRISE_LAB_COARSE_GLSL
#define REPRISE_LAB_COARSE_GLSL

#include "lab/render/shade_triangle.glsl"

// Pixels a side of a coarse pixel. Known to the compiler: CPU drivers divide lane by lane, and run
// a loop of unknown length once more than it has turns.
layout(constant_id = 7) const int kSize = 2;
const int kPixels = kSize * kSize;

// As vkCmdDispatchIndirect reads it, then the items: a coarse pixel (x, y from bit 16), and those
// of its pixels that show one triangle.
layout(binding = kFirstPassBinding + 1u, std430) buffer Items {
  uint groups_x;
  uint groups_y;
  uint groups_z;
  uint item_count;
  uvec2 items[];
};

layout(binding = kFirstPassBinding) writeonly uniform image2D color_image;
layout(push_constant) uniform Push {
  CoarseConstants push;
};

ivec2 baseOf(uvec2 coarse_pixel) {
  ivec2 origin_px = ivec2(push.origin_x_px, push.origin_y_px);
  // The first coarse pixels may begin outside the frame.
  return origin_px - kSize * ivec2(greaterThan(origin_px, ivec2(0))) + kSize * ivec2(coarse_pixel);
}

ivec2 pixelOf(ivec2 base_px, int i) {
  return base_px + ivec2(i % kSize, i / kSize);
}

#endif
