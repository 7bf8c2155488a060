// SPDX-License-Identifier: MIT
//
// What the two passes of coarse pixel shading share: the grid, and the list of what is to be
// shaded.
#ifndef REPRISE_LAB_COARSE_GLSL
#define REPRISE_LAB_COARSE_GLSL

#include "core/workgroup.h"
#include "lab/render/shade_triangle.glsl"
#include "lab/render/coarse_pixel.glsl"

// Evaluations a workgroup of coarse.comp. Not in frame_data.h: a new constant there renumbers the
// ids of every shader, and with them the hashes of references.
const uint kCoarseGroup = 64u;

// Strips of the frame, a list each. CPU drivers have threads list far parts of a frame at once: in
// one list for all, pieces of both would alternate, and a subgroup between two pieces waits for
// whichever light tile has more lamps. Neighbours of one strip have much the same.
const uint kStrips = 4u;

// As vkCmdDispatchIndirect reads it; then how many items all strips have, and each; then the items:
// a coarse pixel (x, y from bit 16), and those of its pixels that show one triangle.
layout(binding = kFirstPassBinding + 1u, std430) buffer Items {
  uint groups_x;
  uint groups_y;
  uint groups_z;
  uint item_count;
  uint strip_counts[kStrips];
  uvec2 items[];  // of each strip from its number times stripCapacity() on
};

layout(binding = kFirstPassBinding) writeonly uniform image2D color_image;
layout(push_constant) uniform Push {
  CoarseConstants push;
};

// Workgroups of coarse_list.comp (listExtent of coarse_shading.cpp): one more coarse pixel than the
// frame is wide where the grid begins inside the first, and one for the rest of a division.
uvec2 listGroups() {
  uvec2 coarse_pixels = uvec2(frame.extent_px) / uint(kSize) + 2u;
  return (coarse_pixels + uint(REPRISE_WORKGROUP_SIZE) - 1u) / uint(REPRISE_WORKGROUP_SIZE);
}
uint stripGroups() {  // of listGroups().y
  return (listGroups().y + kStrips - 1u) / kStrips;
}
uint stripCapacity() {
  uint groups = stripGroups() * listGroups().x;
  return groups * uint(REPRISE_WORKGROUP_SIZE * REPRISE_WORKGROUP_SIZE * kPixels);
}

ivec2 baseOf(uvec2 coarse_pixel) {
  ivec2 origin_px = ivec2(push.origin_x_px, push.origin_y_px);
  // The first coarse pixels may begin outside the frame.
  return origin_px - kSize * ivec2(greaterThan(origin_px, ivec2(0))) + kSize * ivec2(coarse_pixel);
}

#endif
