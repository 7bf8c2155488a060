// SPDX-License-Identifier: MIT
//
// Moves history of 2 x 2 texels a pixel to this frame, follows what evidence says has changed,
// bounds it, and blends the new sample in. Equation numbers refer to README.md of this folder.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/frame_inputs.glsl"
#include "core/half_rounding.glsl"
#include "core/neighbourhood.glsl"
#include "core/workgroup.h"
#include "equations/color_space.h"
#include "equations/evidence.h"
#include "equations/filters.h"
#include "techniques/reprise/reprise_shared.h"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

layout(binding = 0) uniform sampler2D color_image;
layout(binding = 1) uniform sampler2D motion_image;
layout(binding = 2) uniform sampler2D reactive_image;
layout(binding = 3) uniform sampler2D predicted_image;
layout(binding = 4) uniform sampler2D depth_image;          // this frame's, dilated, view depth
layout(binding = 5) uniform sampler2D history_image;        // rgb linear, a: samples held
layout(binding = 6) uniform sampler2D history_depth_image;
layout(binding = 7) uniform sampler2D change_image;         // rgb mean residual, a its square
layout(binding = 8) uniform sampler2D gain_image;
layout(binding = 9) writeonly uniform image2D next_history_image;
layout(binding = 10) writeonly uniform image2D next_change_image;
layout(binding = 11) writeonly uniform image2D output_image;
layout(binding = 12, std140) uniform Constants {
  RepriseConstants k;
};

const float kStillMotion_px = 0.01;
void main() {
  ivec2 px = ivec2(gl_GlobalInvocationID.xy);
  ivec2 last_px = ivec2(k.frame.extent_px) - 1;
  if (any(greaterThan(px, last_px))) return;
  const ivec2 kCross[5] =
      ivec2[5](ivec2(0, 0), ivec2(-1, 0), ivec2(1, 0), ivec2(0, -1), ivec2(0, 1));

  // Light that changed over a larger area.
  vec2 tile_uv = (vec2(px) + 0.5) * k.tile_uv;
  vec3 gain = textureLod(gain_image, tile_uv, 0.0).rgb;

  // The residual of this frame, pooled over 3x3.
  vec3 samples[9];
  vec3 mean = vec3(0.0);
  float square = 0.0;
  float pooled = 0.0;
  int code = 0;
  vec3 predicted_here = vec3(0.0);
  for (int i = 0; i < 9; ++i) {
    ivec2 at_px = clamp(px + ivec2(i % 3 - 1, i / 3 - 1), ivec2(0), last_px);
    vec3 color = fetchColor(color_image, at_px, last_px);
    samples[i] = yCoCgFromRgb(color);
    vec4 predicted = texelFetch(predicted_image, at_px, 0);
    vec3 told_here = predicted.rgb * gain;
    if (i == 4) {
      code = int(predicted.a + 0.5);
      predicted_here = told_here;
    }
    float w = predicted.a < 7.5 ? 1.0 : 0.0;
    vec3 residual = (color - told_here) * (w / (lumaYCoCg(told_here) + kDarkest));
    mean += residual;
    square += dot(residual, residual);
    pooled += w;
  }
  mean /= max(pooled, 1.0);
  square /= max(pooled, 1.0);

  // Where the pixel was.
  ivec2 surface_px = clamp(px + kCross[code & 7], ivec2(0), last_px);
  vec2 motion_px = motionPx(k.frame, texelFetch(motion_image, surface_px, 0).xy);
  vec2 center_px = vec2(px) + 0.5;
  vec2 scale = k.frame.previous_extent_px / k.frame.extent_px;
  vec2 previous_px = (center_px + motion_px) * scale;
  vec2 inside_px = clamp(previous_px, vec2(0.5), k.frame.previous_extent_px - 0.5);
  bool on_screen = k.frame.has_history > 0.5 && isOnScreen(previous_px, k.frame.previous_extent_px);
  bool still = dot(motion_px, motion_px) < kStillMotion_px * kStillMotion_px;

  // Evidence.
  vec4 change_then = textureLod(change_image, inside_px * k.frame.history_texel_uv, 0.0);
  float known = on_screen && pooled > 0.5 ? 1.0 : 0.0;
  float noise = max(change_then.a, kResponseFloor) / k.evidence_count;
  float now = known * believedShare(dot(mean, mean), noise, k.doubt_now);
  float weight = max(k.memory, now);
  vec3 change = mix(change_then.rgb, mean, weight) * known;
  float spread = mix(change_then.a, square, change_then.a > 0.0 ? k.memory : 1.0);
  float believed = known * believedShare(dot(change, change),
                                         noise * exponentialMeanVariance(weight), k.doubt_mean);
  vec3 follow = believed * change;
  vec3 offset = follow * (lumaYCoCg(predicted_here) + kDarkest);
  imageStore(next_change_image, px, vec4(change - follow, known > 0.5 ? spread : 0.0));

  // Texels of history, in texels of the double grid: this pixel's are 2 px and 2 px + 1.
  vec2 last_texel = 2.0 * k.frame.previous_extent_px - 1.0;
  vec2 at = 2.0 * (vec2(px) + motion_px) * scale;  // of the texel (0, 0)'s corner
  at = clamp(at, vec2(0.0), last_texel - 1.0);
  vec2 base = floor(at);
  vec2 f = at - base;
  float expected = min(expectedPreviousDepth(k.frame.previous_depth_coefficients,
                                             center_px - k.frame.jitter_px,
                                             texelFetch(depth_image, px, 0).x),
                       kMaxViewDepth);
  // Depth is one a pixel; five texels in a row lie in at most three pixels.
  ivec2 first_px = ivec2(floor((base - 1.0) * 0.5));
  float valid[9];
  float valid_count = 0.0;
  for (int i = 0; i < 9; ++i) {
    ivec2 at_px = clamp(first_px + ivec2(i % 3, i / 3), ivec2(0),
                        ivec2(k.frame.previous_extent_px) - 1);
    float depth = texelFetch(history_depth_image, at_px, 0).x;
    valid[i] = on_screen && expected <= depth * (1.0 + k.depth_tolerance) ? 1.0 : 0.0;
    valid_count += valid[i];
  }
  bool whole = valid_count > 8.5;
  vec4 wx = whole ? cubicWeights(f.x, k.sharpness) : vec4(0.0, 1.0 - f.x, f.x, 0.0);
  vec4 wy = whole ? cubicWeights(f.y, k.sharpness) : vec4(0.0, 1.0 - f.y, f.y, 0.0);
  ivec2 parity = ivec2(base) - 1 - 2 * first_px;  // 0 or 1
  vec4 sum[4] = vec4[4](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
  float weights[4] = float[4](0.0, 0.0, 0.0, 0.0);
  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < 5; ++x) {
      ivec2 texel = ivec2(clamp(base + vec2(x, y) - 1.0, vec2(0.0), last_texel));
      vec4 value = texelFetch(history_image, texel, 0);
      float v = valid[((y + parity.y) >> 1) * 3 + ((x + parity.x) >> 1)];
      for (int j = 0; j < 4; ++j) {
        int tx = x - (j & 1);
        int ty = y - (j >> 1);
        if (tx < 0 || tx > 3 || ty < 0 || ty > 3) continue;
        float w = wx[tx] * wy[ty] * v;
        sum[j] += w * value;
        weights[j] += w;
      }
    }
  }

  float reactive = 0.0;
  if (k.frame.reactive_given > 0.5) {
    reactive = clamp(texelFetch(reactive_image, px, 0).x, 0.0, 1.0);
  }
  Moments m = moments(samples);
  float gamma = mix(k.bound_wide, k.bound_tight, max(believed, now));
  if (still) gamma = max(gamma, mix(k.x0, k.bound_tight, max(believed, now)));
  vec3 current = fetchColor(color_image, px, last_px);
  float limit = still ? k.still_limit : k.history_limit;
  vec3 shown = vec3(0.0);
  for (int j = 0; j < 4; ++j) {
    float has = weights[j] > 1.0e-3 ? 1.0 : 0.0;
    vec4 history = max(sum[j] / max(weights[j], 1.0e-3), vec4(0.0)) * has;
    vec3 then = sanitizedColor(history.rgb * k.frame.exposure_ratio);
    then = max(then * gain + offset, vec3(0.0));
    vec3 previous = yCoCgFromRgb(then);
    float slack = boundSlack(previous, samples[4]);
    vec3 half_size = gamma * m.deviation + slack;
    vec3 bounded = clipTowardBoxCentre(m.mean - half_size, m.mean + half_size, previous);
    float clipped = length(bounded - previous) / (length(previous - samples[4]) + 1.0e-4);
    float count = min(history.a, limit) * (1.0 - reactive);
    count *= 1.0 - k.forget * clamp(clipped, 0.0, 1.0);
    count *= 1.0 - k.x1 * believed;
    float w = k.texel_weights[j];
    float alpha = w / max(count + w, 1.0e-4);
    float kept = k.x3 * (1.0 - clamp(clipped, 0.0, 1.0)) * (code < 8 ? 1.0 : 0.0);
    vec3 base_value = max(rgbFromYCoCg(bounded), vec3(0.0));
    vec3 target = current + kept * (base_value - predicted_here - offset);
    vec3 value = max(mix(base_value, target, alpha), vec3(0.0));
    shown += 0.25 * value;
    ivec2 texel = 2 * px + ivec2(j & 1, j >> 1);
    imageStore(next_history_image, texel,
               vec4(roundedToHalf(min(value, vec3(kMaxColor)), texel, k.frame.frame_number, true),
                    min(count + w, 2048.0)));
  }
  imageStore(output_image, px, vec4(shown, 1.0));
}
