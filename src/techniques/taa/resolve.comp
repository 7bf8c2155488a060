// SPDX-License-Identifier: MIT
//
// Temporal antialiasing with exponential history: reproject, test, filter, bound, blend. Equation
// numbers refer to README.md of this folder.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/frame_inputs.glsl"
#include "core/half_rounding.glsl"
#include "core/workgroup.h"
#include "equations/accumulation.h"
#include "techniques/taa/options.glsl"
#include "techniques/taa/taa_shared.h"
#include "techniques/taa/neighbourhood.glsl"
#include "techniques/taa/history.glsl"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

layout(binding = 0) uniform sampler2D color_image;
layout(binding = 1) uniform sampler2D depth_image;
layout(binding = 2) uniform sampler2D motion_image;
layout(binding = 3) uniform sampler2D reactive_image;
layout(binding = 4) uniform usampler2D id_image;
layout(binding = 5) uniform sampler2D history_image;         // rgb linear, a: samples held
layout(binding = 6) uniform sampler2D history_depth_image;   // r: view depth, dilated like ours
layout(binding = 7) uniform sampler2D history_motion_image;  // rg: px
layout(binding = 8) uniform usampler2D history_id_image;
layout(binding = 9) writeonly uniform image2D next_history_image;
layout(binding = 10) writeonly uniform image2D next_depth_image;
layout(binding = 11) writeonly uniform image2D next_motion_image;
layout(binding = 12) writeonly uniform uimage2D next_id_image;
layout(binding = 13) writeonly uniform image2D output_image;
layout(binding = 14, std140) uniform Constants {
  TaaConstants k;
};

// Motion below this is none: what half-precision motion images leave of a still camera (px).
const float kStillMotion_px = 0.01;

// The pixel whose motion, depth and id this pixel takes (eq. 2).
struct Surface {
  ivec2 px;
  float view_depth;
  vec2 motion_px;
};

Surface dilatedSurface(ivec2 px, ivec2 last_px) {
  ivec2 best_px = px;
  float best = texelFetch(depth_image, px, 0).x;
  if (kDilation == kDilateClosest || kDilation == kDilateCross) {
    float order = k.frame.depth_order;
    for (int i = 0; i < 9; ++i) {
      ivec2 offset = ivec2(i % 3 - 1, i / 3 - 1);
      if (i == 4 || (kDilation == kDilateCross && offset.x * offset.y != 0)) continue;
      ivec2 neighbour_px = clamp(px + offset, ivec2(0), last_px);
      float depth = texelFetch(depth_image, neighbour_px, 0).x;
      if (depth * order < best * order) {
        best = depth;
        best_px = neighbour_px;
      }
    }
  }
  vec2 motion_px = motionPx(k.frame, texelFetch(motion_image, best_px, 0).xy);
  if (kDilation == kDilateLongest) {
    for (int i = 0; i < 9; ++i) {
      ivec2 neighbour_px = clamp(px + ivec2(i % 3 - 1, i / 3 - 1), ivec2(0), last_px);
      vec2 neighbour_motion_px = motionPx(k.frame, texelFetch(motion_image, neighbour_px, 0).xy);
      if (dot(neighbour_motion_px, neighbour_motion_px) > dot(motion_px, motion_px)) {
        motion_px = neighbour_motion_px;
        best_px = neighbour_px;
      }
    }
    // Dilate both or neither: motion of one surface with the depth of another makes halos.
    best = texelFetch(depth_image, best_px, 0).x;
  }
  return Surface(best_px, viewDepth(k.frame, best), motion_px);
}

// 1 for each of the four texels around `px` that this surface may take history from (eq. 4), in the
// order (0,0) (1,0) (0,1) (1,1).
vec4 validTaps(vec2 px, float expected_depth) {
  if (kDepthTest == kDepthTestNone) return vec4(1.0);
  // Gather gives (0,1) (1,1) (1,0) (0,0).
  vec4 depths = textureGather(history_depth_image, px * k.frame.history_texel_uv, 0).wzxy;
  if (kDepthTest == kDepthTestPixel) {
    float farthest = max(max(depths.x, depths.y), max(depths.z, depths.w));
    depths = vec4(farthest);
  }
  return vec4(lessThanEqual(vec4(expected_depth), depths * (1.0 + k.depth_tolerance)));
}

void main() {
  ivec2 px = ivec2(gl_GlobalInvocationID.xy);
  ivec2 last_px = ivec2(k.frame.extent_px) - 1;
  if (any(greaterThan(px, last_px))) return;

  vec3 samples[9];
  for (int i = 0; i < 9; ++i) {
    ivec2 offset = ivec2(i % 3 - 1, i / 3 - 1);
    samples[i] = vec3(0.0);
    if (kCorners == 0u && offset.x * offset.y != 0) continue;
    samples[i] = toWorking(fetchColor(color_image, px + offset, last_px));
  }
  vec3 current = filteredSample(samples, k);

  Surface surface = dilatedSurface(px, last_px);
  vec2 center_px = vec2(px) + 0.5;
  vec2 previous_extent_px = k.frame.previous_extent_px;
  vec2 previous_px = (center_px + surface.motion_px) * (previous_extent_px / k.frame.extent_px);
  vec2 inside_px = clamp(previous_px, vec2(0.5), previous_extent_px - 0.5);

  float trust = k.frame.has_history;
  if (kExtendOffscreen == 0u && !isOnScreen(previous_px, previous_extent_px)) trust = 0.0;

  float expected_depth = expectedPreviousDepth(k.frame.previous_depth_coefficients,
                                               center_px - k.frame.jitter_px, surface.view_depth);
  vec4 valid = validTaps(inside_px, min(expected_depth, kMaxViewDepth));
  uint id = 0u;
  if (kIdTest != 0u) {
    id = texelFetch(id_image, surface.px, 0).x;
    uvec4 ids = textureGather(history_id_image, inside_px * k.frame.history_texel_uv, 0).wzxy;
    valid *= vec4(equal(ids, uvec4(id)));
  }
  float valid_count = dot(valid, vec4(1.0));
  if (valid_count < 0.5) trust = 0.0;

  vec2 texel_uv = k.frame.history_texel_uv;
  vec2 last_center_px = previous_extent_px - 0.5;
  vec4 history =
      filteredHistory(history_image, inside_px, texel_uv, last_center_px, k.history_sharpness);
  // A loop, not a branch: CPU drivers run both sides of a branch for every pixel.
  for (int mixed = valid_count > 3.5 || valid_count < 0.5 ? 1 : 0; mixed < 1; ++mixed) {
    history = validHistory(history_image, inside_px, last_center_px, valid);
  }
  float count = max(history.a, 1.0);

  if (kMotionTest != 0u) {
    vec2 motion_then_px =
        texelFetch(history_motion_image, ivec2(min(inside_px, last_center_px)), 0).xy;
    trust *= 1.0 - motionDifferenceRamp(surface.motion_px, motion_then_px, k.motion_tolerance_px);
  }
  if (kReactive != 0u && k.frame.reactive_given > 0.5) {
    trust *= 1.0 - clamp(texelFetch(reactive_image, px, 0).x, 0.0, 1.0);
  }

  float speed_px = length(surface.motion_px);
  bool still = kStill != 0u && speed_px < kStillMotion_px;
  vec3 previous = toWorking(sanitizedColor(history.rgb * k.frame.exposure_ratio));
  float gamma = still ? k.gamma_still : k.gamma;
  vec3 bounded = rectified(previous, current, samples, gamma, gamma / k.gamma);
  float clipped = length(bounded - previous) / (length(previous - current) + 1.0e-4);

  // The running mean's count (eq. 6): bounded in motion by alpha, at rest by the still mode.
  float count_limit = still ? k.still_frames : 1.0 / k.alpha - 1.0;
  count = min(count, count_limit) * (1.0 - k.clip_forget * clamp(clipped, 0.0, 1.0));
  float alpha = 1.0 / (count + 1.0);
  float luma_now = workingLuma(current);
  float luma_then = workingLuma(bounded);
  if (kAntiFlicker == kAntiFlickerContrast) {
    alpha *= mix(1.0, contrastFeedback(luma_now, luma_then), k.anti_flicker);
  }
  if (kAntiFlicker == kAntiFlickerBounds) {
    Bound bound = extremes(samples);
    float low = workingLuma(bound.low);
    float high = workingLuma(bound.high);
    alpha *= mix(1.0, boundsFeedback(luma_then, low, high), k.anti_flicker);
  }
  alpha = max(alpha, k.speed_alpha * clamp(speed_px / k.speed_px, 0.0, 1.0));
  alpha = mix(1.0, alpha, trust);

  float held = trust * count;
  if (kSpatial != 0u && held + 1.0 <= k.spatial_frames + 0.5) {
    current = smoothedAlongEdge(samples, current);
  }
  vec3 shown = current;
  if (kRejectedBlur != 0u) {
    // Only what history would have smoothed: not the first frame after a cut.
    shown = mix(current, meanSample(samples), (1.0 - trust) * k.frame.has_history);
  }
  vec3 result = fromWorking(mix(bounded, shown, alpha));

  imageStore(
      next_history_image, px,
      vec4(roundedToHalf(min(result, vec3(kMaxColor)), px, k.frame.frame_number, kDither != 0u),
           min(held + 1.0, 2048.0)));
  if (kDepthTest != kDepthTestNone) {
    imageStore(next_depth_image, px, vec4(surface.view_depth, 0.0, 0.0, 0.0));
  }
  if (kMotionTest != 0u) {
    imageStore(next_motion_image, px, vec4(surface.motion_px, 0.0, 0.0));
  }
  if (kIdTest != 0u) imageStore(next_id_image, px, uvec4(id));
  if (kWriteOutput != 0u) imageStore(output_image, px, vec4(result, 1.0));
}
