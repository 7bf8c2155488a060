// SPDX-License-Identifier: MIT
//
// Lists what coarse.comp shades: each triangle of each coarse pixel. Where there is none, the sky
// is seen.
//
// Items of a workgroup stand by triangle: neighbours in the list are shaded together, and wait for
// whoever looks up most texels. In the order of their pixels it would be the one at a silhouette.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_arithmetic : require

#include "core/workgroup.h"
#include "lab/render/coarse.glsl"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

// One for each thread. Triangles of eight successive numbers, mostly one patch of a surface, share
// one: finer and coarser bins, and ones by instance, gained less (Sponza).
const uint kBins = uint(REPRISE_WORKGROUP_SIZE * REPRISE_WORKGROUP_SIZE);
const uint kTrianglesABin = 8u;

shared uint items_of[kBins];
shared uint first_of[kBins];

uint binOf(uvec2 key) {
  return key.y / kTrianglesABin % kBins;
}

// Room for `count` items in the strip's list: where it begins. Atomic operations once a subgroup.
uint reserve(uint count) {
  uint before = subgroupExclusiveAdd(count);
  uint all_count = subgroupAdd(count);
  uint base = 0u;
  if (subgroupElect() && all_count > 0u) {
    uint strip = gl_WorkGroupID.y / stripGroups(uint(frame.extent_px.y), uint(kSize));
    base = stripBegin(strip) + atomicAdd(strip_counts[strip], all_count);
    // A strip's last workgroup may have a single item.
    uint most = atomicAdd(item_count, all_count) + all_count + kStrips * kCoarseGroup;
    uint a_row = groups_x * kCoarseGroup;
    atomicMax(groups_y, (most + a_row - 1u) / a_row);
  }
  return subgroupAdd(base) + before;
}

void main() {
  uint thread = gl_LocalInvocationIndex;
  uvec2 coarse_pixel = gl_GlobalInvocationID.xy;
  ivec2 base_px = baseOf(coarse_pixel);
  shown_light_layers = push.light_layers;
  items_of[thread] = 0u;
  barrier();

  uvec2 keys[kPixels];  // instance + 1 and triangle
  for (int i = 0; i < kPixels; ++i) {
    ivec2 px = pixelOf(base_px, i);
    bool within = withinFrame(px);
    keys[i] = within ? texelFetch(visibility_image, px, 0).xy : uvec2(0u);
    if (within && keys[i].x == 0u) imageStore(color_image, px, vec4(background(), 1.0));
  }
  // Of the first pixel of each triangle: all that show it, and its place in its bin.
  uint shown_in[kPixels];
  uint place[kPixels];
  for (int i = 0; i < kPixels; ++i) {
    uint same = 0u;
    for (int k = 0; k < kPixels; ++k) same |= uint(keys[k] == keys[i]) << k;
    bool first = keys[i].x != 0u && (same & ((1u << i) - 1u)) == 0u;
    shown_in[i] = first ? same : 0u;
    place[i] = 0u;
    if (first) place[i] = atomicAdd(items_of[binOf(keys[i])], 1u);
  }
  barrier();
  first_of[thread] = reserve(items_of[thread]);
  barrier();
  for (int i = 0; i < kPixels; ++i) {
    if (shown_in[i] == 0u) continue;
    items[first_of[binOf(keys[i])] + place[i]] =
        uvec2(coarse_pixel.x | coarse_pixel.y << 16, shown_in[i]);
  }
}
