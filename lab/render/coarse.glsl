// SPDX-License-Identifier: MIT
//
// What the two passes of coarse pixel shading share: the grid, and the list of what is to be
// shaded.
#ifndef REPRISE_LAB_COARSE_GLSL
#define REPRISE_LAB_COARSE_GLSL

#include "lab/render/shade_triangle.glsl"
#include "lab/render/coarse_pixel.glsl"

// Evaluations a workgroup of coarse.comp. Not in frame_data.h: a new constant there renumbers the
// ids of every shader, and with them the hashes of references.
const uint kCoarseGroup = 64u;

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

#endif
