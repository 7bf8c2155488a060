// SPDX-License-Identifier: MIT
//
// Temporal antialiasing as Karis 2014 describes it. Equation numbers refer to README.md of this
// folder.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/frame_inputs.glsl"
#include "core/half_rounding.glsl"
#include "core/history_filters.glsl"
#include "core/neighbourhood.glsl"
#include "core/workgroup.h"
#include "equations/accumulation.h"
#include "equations/color_space.h"
#include "techniques/ue4_taa/ue4_taa_shared.h"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

layout(constant_id = 0) const uint kAntiFlicker = 0u;

layout(binding = 0) uniform sampler2D color_image;
layout(binding = 1) uniform sampler2D depth_image;
layout(binding = 2) uniform sampler2D motion_image;
layout(binding = 3) uniform sampler2D reactive_image;
layout(binding = 4) uniform sampler2D history_image;  // rgb linear
layout(binding = 5) writeonly uniform image2D next_history_image;
layout(binding = 6) writeonly uniform image2D output_image;
layout(binding = 7, std140) uniform Constants {
  Ue4TaaConstants k;
};

// Karis 2014: the weight of the current frame.
const float kAlpha = 0.04;
// Arms of the X over which the closest depth is sought (px).
const int kDilation_px = 2;
// Catmull-Rom.
const float kHistorySharpness = 0.5;

// Weighted by 1 / (1 + luma) so that one bright sample does not outvote its neighbours; a sum of
// weighted samples, divided by the sum of their weights, is the inverse of this map (eq. 2).
vec3 toWorking(vec3 linear) {
  return yCoCgFromRgb(compressByLuma(linear));
}
vec3 fromWorking(vec3 working) {
  return expandByLuma(max(rgbFromYCoCg(working), vec3(0.0)));
}

// Motion of the closest surface among the pixel and the four ends of an X (eq. 3).
vec2 dilatedMotion_px(ivec2 px, ivec2 last_px) {
  ivec2 best_px = px;
  float best = texelFetch(depth_image, px, 0).x * k.frame.depth_order;
  for (int i = 0; i < 4; ++i) {
    ivec2 arm_px = kDilation_px * ivec2((i & 1) * 2 - 1, (i >> 1) * 2 - 1);
    ivec2 at_px = clamp(px + arm_px, ivec2(0), last_px);
    float depth = texelFetch(depth_image, at_px, 0).x * k.frame.depth_order;
    if (depth < best) {
      best = depth;
      best_px = at_px;
    }
  }
  return motionPx(k.frame, texelFetch(motion_image, best_px, 0).xy);
}

void main() {
  ivec2 px = ivec2(gl_GlobalInvocationID.xy);
  ivec2 last_px = ivec2(k.frame.extent_px) - 1;
  if (any(greaterThan(px, last_px))) return;

  vec3 samples[9];
  for (int i = 0; i < 9; ++i) {
    samples[i] = toWorking(fetchColor(color_image, px + ivec2(i % 3 - 1, i / 3 - 1), last_px));
  }
  vec3 current =
      weightedSample(samples, k.filter_weights_0_3, k.filter_weights_4_7, k.filter_weight_8.x);

  vec2 motion_px = dilatedMotion_px(px, last_px);
  vec2 previous_extent_px = k.frame.previous_extent_px;
  vec2 previous_px = (vec2(px) + 0.5 + motion_px) * (previous_extent_px / k.frame.extent_px);
  float trust = k.frame.has_history;
  if (!isOnScreen(previous_px, previous_extent_px)) trust = 0.0;
  vec2 last_center_px = previous_extent_px - 0.5;
  vec2 inside_px = clamp(previous_px, vec2(0.5), last_center_px);
  vec3 history = cubicHistory(history_image, inside_px, k.frame.history_texel_uv, last_center_px,
                              kHistorySharpness, true)
                     .rgb;
  history = toWorking(sanitizedColor(history * k.frame.exposure_ratio));

  Bound bound = roundedExtremes(samples);
  float slack = boundSlack(history, current);
  bound.low -= slack;
  bound.high += slack;
  vec3 bounded = clipTowardSample(bound.low, bound.high, current, history);

  float alpha = kAlpha;
  if (kAntiFlicker == kAntiFlickerBounds) {
    alpha *= boundsFeedback(bounded.x, bound.low.x, bound.high.x);
  }
  if (kAntiFlicker == kAntiFlickerContrast) alpha *= contrastFeedback(current.x, bounded.x);
  if (k.frame.reactive_given > 0.5) {
    trust *= 1.0 - clamp(texelFetch(reactive_image, px, 0).x, 0.0, 1.0);
  }
  alpha = mix(1.0, alpha, trust);

  vec3 result = min(fromWorking(mix(bounded, current, alpha)), vec3(kMaxColor));
  // An alpha of 1/25 moves history by less than half's last bit: rounded by a threshold that
  // varies, it still moves.
  imageStore(next_history_image, px,
             vec4(evenlyRoundedToHalf(result, px, k.frame.frame_number), 1.0));
  imageStore(output_image, px, vec4(result, 1.0));
}
