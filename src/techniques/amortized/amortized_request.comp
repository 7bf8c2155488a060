// SPDX-License-Identifier: MIT
//
// Before shading: which quadrants of which pixels have no history, as a compacted list (Yang et
// al. 2009, section 5.3). Runs on this frame's depth and motion, which need no shading.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/workgroup.h"
#include "techniques/amortized/reproject.glsl"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

layout(constant_id = 3) const uint kRequestGroup = 64u;

// The layout is that of RepriseSampleRequests in reprise.h.
layout(binding = 10, std430) buffer Requests {
  uint groups_x;
  uint groups_y;
  uint groups_z;
  uint count;
  uint entries[];
};
layout(binding = 11, std140) uniform Constants {
  AmortizedConstants k;
};

// Of a buffer, as bits: two buffers lie in the first and last quadrant, one stands for all.
uint quadrantsOf(uint buffer_index) {
  if (kBuffers == 1u) return 15u;
  if (kBuffers == 2u) return buffer_index == 0u ? 1u : 8u;
  return 1u << buffer_index;
}

void main() {
  ivec2 px = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(px, ivec2(k.frame.extent_px)))) return;
  Surface s = surfaceAt(k, px);
  vec2 motions_px[4];
  vec4 chained[2];
  motionsToBuffers(k, s, motions_px, chained);
  uint mask = 0u;
  for (uint b = 0u; b < kBuffers; ++b) {
    Gathered pixel = gatherBuffer(b, k, s, motions_px[b], vec2(0.0), 1.0);
    if (reprojectionFailed(pixel)) mask |= quadrantsOf(b);
  }
  if (mask == 0u) return;
  uint index = atomicAdd(count, 1u);
  entries[index] = uint(px.x) | (uint(px.y) << 14) | (mask << 28);
  atomicMax(groups_x, index / kRequestGroup + 1u);
}
