// SPDX-License-Identifier: MIT
//
// Amortized supersampling, one frame: writes one subpixel buffer and the pixel. Yang et al. 2009,
// section 5; numbers in brackets are the paper's equations. Of a frame that recorded a request,
// amortized_blend.comp does this with what the request gathered.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/workgroup.h"
const uint kConstantsBinding = 22u;
#include "techniques/amortized/blend.glsl"
#include "techniques/amortized/gather.glsl"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

layout(binding = 10) uniform sampler2D color_image;
layout(binding = 11) uniform sampler2D extra_image;
layout(binding = 12) uniform sampler2D count_image;     // N of the previous frame
layout(binding = 13) uniform sampler2D newest_image;    // the buffer that it wrote
layout(binding = 14) uniform sampler2D residual_image;  // of the last four updates, signed roots
layout(binding = 15) uniform sampler2D smoothed_residual_image;
layout(binding = 16) writeonly uniform image2D next_buffer_image;
layout(binding = 17) writeonly uniform image2D next_count_image;
layout(binding = 18) writeonly uniform image2D next_motion_image_0;
layout(binding = 19) writeonly uniform image2D next_motion_image_1;
layout(binding = 20) writeonly uniform image2D next_residual_image;
layout(binding = 21) writeonly uniform image2D output_image;

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
  Change change = Change(vec4(0.0), 0.0);
  if (kResiduals != 0u && g.pixel_weight > kLeastWeight) {
    change = changeBefore(previous, residual_image, smoothed_residual_image);
  }
  Blended result = blended(g, fetchColor(color_image, px, last_px), servedRequests(extra_image, px),
                           s.motion_px, change.bound, px);

  imageStore(next_buffer_image, px, vec4(result.estimate, storedDepth(px, last_px)));
  imageStore(next_count_image, px, vec4(result.count));
  if (kExactMotion == 0u) {
    imageStore(next_motion_image_0, px, chained[0]);
    if (kSlots > 2u) imageStore(next_motion_image_1, px, chained[1]);
  }
  if (kResiduals != 0u) {
    vec4 residuals = vec4(result.residual, change.residuals.xyz);
    imageStore(next_residual_image, px, packedResiduals(residuals));
  }
  imageStore(output_image, px, vec4(result.pixel, 1.0));
}
