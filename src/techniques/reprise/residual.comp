// SPDX-License-Identifier: MIT
//
// What the history predicted for this frame's sample, and by how much it was wrong (eq. 1 to 4 of
// README.md).
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/frame_inputs.glsl"
#include "core/workgroup.h"
#include "techniques/reprise/reprise_shared.h"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

layout(binding = 0) uniform sampler2D depth_image;
layout(binding = 1) uniform sampler2D motion_image;
layout(binding = 2) uniform sampler2D history_image;        // 2 x 2 texels a pixel
layout(binding = 3) uniform sampler2D history_depth_image;  // view depth, dilated like ours
layout(binding = 4) writeonly uniform image2D next_depth_image;
layout(binding = 5) writeonly uniform image2D predicted_image;  // rgb linear, a: see below
layout(binding = 6, std140) uniform Constants {
  RepriseConstants k;
};

void main() {
  ivec2 px = ivec2(gl_GlobalInvocationID.xy);
  ivec2 last_px = ivec2(k.frame.extent_px) - 1;
  if (any(greaterThan(px, last_px))) return;

  // The closest surface of the cross: silhouettes move with what they belong to.
  const ivec2 kCross[5] =
      ivec2[5](ivec2(0, 0), ivec2(-1, 0), ivec2(1, 0), ivec2(0, -1), ivec2(0, 1));
  float depths_now[5];
  for (int i = 0; i < 5; ++i) {
    ivec2 at_px = clamp(px + kCross[i], ivec2(0), last_px);
    depths_now[i] = viewDepth(k.frame, texelFetch(depth_image, at_px, 0).x);
  }
  int closest = 0;
  float view_depth = depths_now[0];
  for (int i = 1; i < 5; ++i) {
    float opposite = depths_now[((i - 1) ^ 1) + 1];
    float step = depths_now[0] - depths_now[i];
    // A slope falls as much on one side as it rises on the other: no silhouette.
    bool edge = step > 2.0 * abs(opposite - depths_now[0]) + k.x2 * depths_now[0];
    if (edge && depths_now[i] < view_depth) {
      view_depth = depths_now[i];
      closest = i;
    }
  }
  ivec2 surface_px = clamp(px + kCross[closest], ivec2(0), last_px);
  vec2 motion_px = motionPx(k.frame, texelFetch(motion_image, surface_px, 0).xy);

  vec2 sample_px = vec2(px) + 0.5 - k.frame.jitter_px;
  vec2 previous_px = (sample_px + motion_px) * (k.frame.previous_extent_px / k.frame.extent_px);
  vec2 inside_px = clamp(previous_px, vec2(0.5), k.frame.previous_extent_px - 0.5);
  float expected = expectedPreviousDepth(k.frame.previous_depth_coefficients, sample_px, view_depth);
  vec4 depths = textureGather(history_depth_image, inside_px * k.frame.history_texel_uv, 0);
  float nearest = min(min(depths.x, depths.y), min(depths.z, depths.w));
  bool valid = k.frame.has_history > 0.5 && isOnScreen(previous_px, k.frame.previous_extent_px) &&
               min(expected, kMaxViewDepth) <= nearest * (1.0 + k.depth_tolerance);

  vec3 predicted = textureLod(history_image, inside_px * k.frame.history_texel_uv, 0.0).rgb;
  predicted = sanitizedColor(predicted * k.frame.exposure_ratio);
  imageStore(next_depth_image, px, vec4(view_depth, 0.0, 0.0, 0.0));
  imageStore(predicted_image, px, vec4(predicted, float(closest) + (valid ? 0.0 : 8.0)));
}
