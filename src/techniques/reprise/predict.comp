// SPDX-License-Identifier: MIT
//
// What history foretells for this frame's samples (eq. 1 and 2 of README.md).
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/frame_inputs.glsl"
#include "core/workgroup.h"
#include "techniques/reprise/prediction.glsl"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

// A neighbour this much nearer than the pixel, beyond what the slope explains, is another surface.
const float kSilhouette = 0.01;
// A silhouette that moves by more than this against what lies behind it (px a frame) leaves a
// mixture behind that is wrong for the latter. At 0.3 `hangar/fly` loses 0.3 dB of tPSNR, at 1 bars
// that move by less smear (AGapMovesWithItsBars).
const float kLeftBehind_px = 0.5;

layout(binding = 0) uniform sampler2D depth_image;
layout(binding = 1) uniform sampler2D motion_image;
layout(binding = 2) uniform sampler2D history_image;         // 2 x 2 texels a pixel
layout(binding = 3) uniform usampler2D history_depth_image;  // packedDepths
layout(binding = 4) writeonly uniform uimage2D next_depth_image;
layout(binding = 5) writeonly uniform image2D predicted_image;  // rgb linear, a: kCross index
layout(binding = 6, std140) uniform Constants {
  RepriseConstants k;
};

void main() {
  ivec2 px = ivec2(gl_GlobalInvocationID.xy);
  ivec2 last_px = ivec2(k.frame.extent_px) - 1;
  if (any(greaterThan(px, last_px))) return;

  // Silhouettes move with what they belong to: the closest surface of the cross. On a slope one
  // neighbour is as much nearer as the opposite one is farther; there the pixel keeps its own
  // motion, since a neighbour's would shift history by the same fraction of a pixel in every frame.
  float near[5];
  for (int i = 0; i < 5; ++i) near[i] = nearness(k.frame, depth_image, px + kCross[i], last_px);
  int closest = 0;
  float surface = near[0];
  for (int i = 1; i < 5; ++i) {
    float slope = max(near[0] - near[((i - 1) ^ 1) + 1], 0.0);
    bool silhouette = near[i] - near[0] > 2.0 * slope + kSilhouette * near[0];
    if (silhouette && near[i] > surface) {
      surface = near[i];
      closest = i;
    }
  }
  float view_depth = 1.0 / surface;
  float slope = closest != 0 ? 0.0
                             : abs(slopeOf(near[1] - surface, surface - near[2])) +
                                   abs(slopeOf(near[3] - surface, surface - near[4]));
  ivec2 surface_px = clamp(px + kCross[closest], ivec2(0), last_px);
  vec2 motion_px = motionPx(k.frame, texelFetch(motion_image, surface_px, 0).xy);

  vec2 sample_px = vec2(px) + 0.5 - k.frame.jitter_px;
  vec2 previous_px = (sample_px + motion_px) * (k.frame.previous_extent_px / k.frame.extent_px);
  vec2 inside_px = clamp(previous_px, vec2(0.5), k.frame.previous_extent_px - 0.5);
  vec2 uv = inside_px * k.frame.history_texel_uv;
  float expected =
      expectedPreviousDepth(k.frame.previous_depth_coefficients, sample_px, view_depth);
  uvec4 then = textureGather(history_depth_image, uv, 0);
  float nearest = max(max(unpackedDepths(then.x).x, unpackedDepths(then.y).x),
                      max(unpackedDepths(then.z).x, unpackedDepths(then.w).x));
  bool valid = k.frame.has_history > 0.5 && isOnScreen(previous_px, k.frame.previous_extent_px) &&
               1.0 / expected + slope >= (1.0 - k.depth_tolerance) * nearest;
  vec2 history_px = inside_px * (k.previous_output_extent_px / k.frame.previous_extent_px);
  vec3 predicted = sanitizedColor(
      textureLod(history_image, history_px * k.output_texel_uv, 0.0).rgb * k.frame.exposure_ratio);

  // What lay farthest here lately, as it would be seen now.
  bool seen = k.frame.has_history > 0.5 && isOnScreen(previous_px, k.frame.previous_extent_px);
  vec2 center_px = (vec2(px) + 0.5 + motion_px) * (k.frame.previous_extent_px / k.frame.extent_px);
  ivec2 then_px = clamp(ivec2(center_px), ivec2(0), ivec2(k.frame.previous_extent_px) - 1);
  uint lately = texelFetch(history_depth_image, then_px, 0).x;
  float far = unpackedDepths(lately).x;
  vec4 c = k.frame.previous_depth_coefficients;
  float turned = dot(c.xy, sample_px) + c.z;
  float far_then = far * turned / max(1.0 - c.w * far, 1.0e-3);
  vec2 apart_px = motionPx(k.frame, texelFetch(motion_image, px, 0).xy) - motion_px;
  float apart_square = dot(apart_px, apart_px);
  bool leaves = apart_square > kLeftBehind_px * kLeftBehind_px;
  bool keep = !leaves && seen && farAge(lately) < uint(k.far_frames) && far_then < near[0];
  // Left behind, the farthest is no more than the closest: what lies there begins anew.
  bool parting = apart_square > kStillMotion_px * kStillMotion_px || (keep && areParting(lately));
  imageStore(next_depth_image, px,
             uvec4(keep ? packedDepths(surface, far_then, farAge(lately) + 1u, parting)
                        : packedDepths(surface, leaves ? surface : near[0], 0u, parting)));
  bool still = dot(motion_px, motion_px) < kStillMotion_px * kStillMotion_px;
  imageStore(
      predicted_image, px,
      vec4(predicted, float(closest) + (valid ? 0.0 : kNoPrediction) + (still ? 0.0 : kMoves)));
}
