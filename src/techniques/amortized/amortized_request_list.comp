// SPDX-License-Identifier: MIT
//
// Lists the pixels and quadrants that deserve more shading samples and are within the budget.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/workgroup.h"
#include "techniques/amortized/request_rank.glsl"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

layout(constant_id = 0) const uint kRequestGroup = 64u;

layout(binding = 0) uniform sampler2D failed_image;
// The layout is that of RepriseSampleRequests in reprise.h.
layout(binding = 1, std430) buffer Requests {
  uint groups_x;
  uint groups_y;
  uint groups_z;
  uint count;
  uint entries[];
};
layout(binding = 2, std140) uniform Constants {
  RequestConstants k;
};

void main() {
  ivec2 px = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(px, ivec2(k.frame.extent_px)))) return;
  uint failed = uint(texelFetch(failed_image, px, 0).x * 16.0 + 0.5);
  if (failed == 0u) return;
  uint reached = entries[k.capacity + kRequestBins];
  uint place = requestPlace(px, k.frame.frame_number);
  // One quadrant a level, from one that differs from pixel to pixel.
  uint mask = 0u;
  uint quadrant = place;
  for (uint level = firstRequestLevel(failed); level < kRequestLevels; ++level) {
    if (level * kRequestPlaces + place >= reached) break;
    while ((failed & (1u << (quadrant & 3u))) == 0u) ++quadrant;
    mask |= 1u << (quadrant & 3u);
    ++quadrant;
  }
  if (mask == 0u) return;
  uint index = atomicAdd(count, 1u);
  entries[index] = uint(px.x) | (uint(px.y) << 14) | (mask << 28);
  atomicMax(groups_x, index / kRequestGroup + 1u);
}
