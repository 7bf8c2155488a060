// SPDX-License-Identifier: MIT
//
// Jittered reverse reprojection. Nehab et al. 2007, "Accelerating Real-Time Shading with Reverse
// Reprojection Caching"; Scherzer et al. 2007, "Pixel-Correct Shadow Maps with Temporal
// Reprojection and Shadow Test Confidence": one buffer, bilinear fetch, depth test on the
// interpolated depth, constant blending factor.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/frame_inputs.glsl"
#include "core/workgroup.h"
#include "techniques/reprojection/reprojection_shared.h"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

layout(binding = 0) uniform sampler2D color_image;
layout(binding = 1) uniform sampler2D depth_image;
layout(binding = 2) uniform sampler2D motion_image;
layout(binding = 3) uniform sampler2D history_image;  // rgb, a: view depth
layout(binding = 4) writeonly uniform image2D next_history_image;
layout(binding = 5) writeonly uniform image2D output_image;
layout(binding = 6, std140) uniform Constants {
  ReprojectionConstants k;
};

// Depth lies in the alpha of an RGBA16F image; what is farther than a half can say is equally far.
const float kFarthestHalf = 65504.0;

void main() {
  ivec2 px = ivec2(gl_GlobalInvocationID.xy);
  ivec2 extent_px = ivec2(k.frame.extent_px);
  if (any(greaterThanEqual(px, extent_px))) return;

  vec3 current = fetchColor(color_image, px, extent_px - 1);
  float view_depth = viewDepth(k.frame, texelFetch(depth_image, px, 0).x);
  vec2 motion_px = motionPx(k.frame, texelFetch(motion_image, px, 0).xy);
  vec2 center_px = vec2(px) + 0.5;
  vec2 previous_px = (center_px + motion_px) * (k.frame.previous_extent_px / k.frame.extent_px);

  bool hit = k.frame.has_history > 0.5 && isOnScreen(previous_px, k.frame.previous_extent_px);
  vec2 inside_px = clamp(previous_px, vec2(0.5), k.frame.previous_extent_px - 0.5);
  vec4 history = textureLod(history_image, inside_px * k.frame.history_texel_uv, 0.0);
  // The point that this pixel sampled lies at the centre minus the jitter.
  float expected_depth = min(expectedPreviousDepth(k.frame.previous_depth_coefficients,
                                                   center_px - k.frame.jitter_px, view_depth),
                             kFarthestHalf);
  hit = hit && depthsAgree(expected_depth, history.a, k.depth_tolerance);

  vec3 result = current;
  if (hit) result = mix(history.rgb * k.frame.exposure_ratio, current, k.alpha);
  imageStore(next_history_image, px, vec4(result, min(view_depth, kFarthestHalf)));
  imageStore(output_image, px, vec4(result, 1.0));
}
