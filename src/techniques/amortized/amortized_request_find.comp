// SPDX-License-Identifier: MIT
//
// Finds, before shading, the pixels whose reprojection to some buffer fails (Yang et al. 2009,
// section 5.3), and counts the evaluations that they want by how much each would help: a budget is
// then spent on the worst first.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/workgroup.h"
const uint kConstantsBinding = 12u;
#include "techniques/amortized/reproject.glsl"
#include "techniques/amortized/request_rank.glsl"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

// The layout is that of RepriseSampleRequests in reprise.h; behind its entries lie the bins, and
// then the number of them that the budget reaches.
layout(binding = 10, std430) buffer Requests {
  uint header[4];
  uint entries[];
};
layout(binding = 11) writeonly uniform image2D failed_image;  // mask / 16
layout(binding = 13) uniform sampler2D count_image;           // N of the previous frame
layout(binding = 14) uniform sampler2D newest_image;          // the buffer that it wrote

// As many quadrants as bring the pixel to k.quality samples: those that failed first.
uint maskForQuality(uint failed, float count) {
  int wanted = clamp(int(ceil(k.quality - count - 1.0)), 0, 4);
  uint mask = 0u;
  for (uint i = 0u; i < 8u && bitCount(mask) < wanted; ++i) {
    uint bit = 1u << (i & 3u);
    if (i >= 4u || (failed & bit) != 0u) mask |= bit;
  }
  return mask;
}

void main() {
  ivec2 px = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(px, ivec2(k.frame.extent_px)))) return;
  Surface s = surfaceAt(px);
  Way ways[4];
  vec4 chained[2];
  waysToBuffers(s, ways, chained);
  uint mask = 0u;
  bool seen = false;
  for (uint b = 0u; b < kSlots; ++b) {
    SlotState state = k.slots[b];
    Footprint f = footprintIn(state, state.place_age.xy, s, ways[b].motion_px, vec2(0.0));
    vec4 w = tentWeights(f.point.x, f.point.y, kPixelTentRadius_px * f.growth);
    float weight = 0.0;
    if (f.readable) weight = dot(w, validTexels(depthsOf(b, f), f, state, s, ways[b]));
    seen = seen || weight > 0.0;
    if (reprojectionFailed(weight, sumOf(w))) mask |= state.quadrants;
  }
  if (k.quality > 0.0) {
    float count = seen ? samplesBefore(count_image, previousOf(newest_image, s, ways)) : 0.0;
    mask = maskForQuality(mask, count);
  }
  imageStore(failed_image, px, vec4(float(mask) / 16.0));
  if (mask == 0u) return;
  uint bins = uint(entries.length()) - kRequestBins - 1u;
  uint place = requestPlace(px, k.frame.frame_number);
  for (uint level = firstRequestLevel(mask); level < kRequestLevels; ++level) {
    atomicAdd(entries[bins + level * kRequestPlaces + place], 1u);
  }
}
