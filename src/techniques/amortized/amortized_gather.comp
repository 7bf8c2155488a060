// SPDX-License-Identifier: MIT
//
// Before shading: gathers the history, finds the pixels whose reprojection to some buffer fails
// (Yang et al. 2009, section 5.3), and counts the evaluations that they want by how much each would
// help: a budget is then spent on the worst first.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/half_rounding.glsl"
#include "core/workgroup.h"
const uint kConstantsBinding = 12u;
#include "techniques/amortized/gather.glsl"
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
layout(binding = 15) uniform sampler2D residual_image;
layout(binding = 16) uniform sampler2D smoothed_residual_image;
// For amortized_blend.comp. rgb: pixel; a: its weight, negative where the buffer begins.
layout(binding = 17) writeonly uniform image2D gathered_image;
layout(binding = 18) writeonly uniform image2D target_image;  // the buffer's own texel: rgb, depth
layout(binding = 19) writeonly uniform image2D next_count_image;  // N before this frame's sample
layout(binding = 20) writeonly uniform image2D next_motion_image_0;
layout(binding = 21) writeonly uniform image2D next_motion_image_1;
layout(binding = 22) writeonly uniform image2D next_residual_image;
layout(binding = 23) writeonly uniform image2D change_bound_image;

// Noise of another rounding than the blend's.
const float kOtherRounding = 524288.0;

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
  ivec2 last_px = ivec2(k.frame.extent_px) - 1;
  if (any(greaterThan(px, last_px))) return;
  Surface s = surfaceAt(px);
  Way ways[4];
  vec4 chained[2];
  waysToBuffers(s, ways, chained);
  Previous previous = previousOf(newest_image, s, ways);
  Gathered g = gatherHistory(s, ways, previous, count_image);

  imageStore(gathered_image, px, vec4(g.pixel, g.begins ? -g.pixel_weight : g.pixel_weight));
  // Rounded as buffers are: always to the nearest, a value that moves by less than half a step a
  // frame would stand still.
  vec3 target = roundedToHalf(g.target, px, k.frame.frame_number + kOtherRounding, true);
  imageStore(target_image, px, vec4(target, storedDepth(px, last_px)));
  imageStore(next_count_image, px, vec4(g.count));
  if (kExactMotion == 0u) {
    imageStore(next_motion_image_0, px, chained[0]);
    if (kSlots > 2u) imageStore(next_motion_image_1, px, chained[1]);
  }
  if (kResiduals != 0u) {
    Change change = Change(vec4(0.0), 0.0);
    if (g.pixel_weight > kLeastWeight) {
      change = changeBefore(previous, residual_image, smoothed_residual_image);
    }
    imageStore(next_residual_image, px, packedResiduals(vec4(0.0, change.residuals.xyz)));
    imageStore(change_bound_image, px, vec4(change.bound));
  }

  uint mask = k.quality > 0.0 ? maskForQuality(g.quadrants, g.count) : g.quadrants;
  imageStore(failed_image, px, vec4(float(mask) / 16.0));
  if (mask == 0u) return;
  uint bins = uint(entries.length()) - kRequestBins - 1u;
  uint place = requestPlace(px, k.frame.frame_number);
  for (uint level = firstRequestLevel(mask); level < kRequestLevels; ++level) {
    atomicAdd(entries[bins + level * kRequestPlaces + place], 1u);
  }
}
