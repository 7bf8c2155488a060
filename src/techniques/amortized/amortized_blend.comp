// SPDX-License-Identifier: MIT
//
// The resolve of a frame whose request has gathered: the rest of amortized_resolve.comp. Where the
// request left something in an image that this pass writes, the invocation that overwrites a texel
// reads it first, and no other reads it.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/workgroup.h"
const uint kConstantsBinding = 13u;
#include "techniques/amortized/blend.glsl"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

layout(binding = 2) uniform sampler2D color_image;
layout(binding = 3) uniform sampler2D extra_image;
// As amortized_gather.comp left them.
layout(binding = 4) uniform sampler2D gathered_image;
layout(binding = 5) uniform sampler2D target_image;
layout(binding = 6) uniform sampler2D count_image;
layout(binding = 7) uniform sampler2D residual_image;
layout(binding = 8) uniform sampler2D change_bound_image;
layout(binding = 9) writeonly uniform image2D next_buffer_image;
layout(binding = 10) writeonly uniform image2D next_count_image;
layout(binding = 11) writeonly uniform image2D next_residual_image;
layout(binding = 12) writeonly uniform image2D output_image;

void main() {
  ivec2 px = ivec2(gl_GlobalInvocationID.xy);
  ivec2 last_px = ivec2(k.frame.extent_px) - 1;
  if (any(greaterThan(px, last_px))) return;

  vec4 gathered = texelFetch(gathered_image, px, 0);
  vec4 target = texelFetch(target_image, px, 0);
  Gathered g;
  g.target = target.rgb;
  g.begins = gathered.a <= kLeastWeight;
  g.pixel = gathered.rgb;
  g.pixel_weight = abs(gathered.a);
  g.count = texelFetch(count_image, px, 0).x;
  g.quadrants = 0u;
  vec3 residuals = vec3(0.0);
  float change_bound = 0.0;
  if (kResiduals != 0u) {
    residuals = unpackedResiduals(texelFetch(residual_image, px, 0)).yzw;
    change_bound = texelFetch(change_bound_image, px, 0).x;
  }
  Seen seen = seenIn(px, last_px);
  Blended result = blended(g, fetchColor(color_image, px, last_px), servedRequests(extra_image, px),
                           motionAt(seen.px, last_px), change_bound, px);

  imageStore(next_buffer_image, px, vec4(result.estimate, target.a));
  imageStore(next_count_image, px, vec4(result.count));
  if (kResiduals != 0u) {
    imageStore(next_residual_image, px, packedResiduals(vec4(result.residual, residuals)));
  }
  imageStore(output_image, px, vec4(result.pixel, 1.0));
}
