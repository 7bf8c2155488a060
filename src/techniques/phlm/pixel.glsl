// SPDX-License-Identifier: MIT
// What both passes must agree on: a pixel's samples, where it was, and its temporal feature.
#ifndef REPRISE_TECHNIQUES_PHLM_PIXEL_GLSL
#define REPRISE_TECHNIQUES_PHLM_PIXEL_GLSL

#include "core/frame_inputs.glsl"
#include "core/neighbourhood.glsl"
#include "equations/accumulation.h"
#include "equations/color_space.h"
#include "equations/least_squares.h"
#include "techniques/phlm/options.glsl"
#include "techniques/phlm/phlm_shared.h"

// Motion below this is none: what half-precision motion images leave of a still camera (px).
const float kStillMotion_px = 0.01;
// Depth lies in the alpha of a half image; what is farther than a half can say is equally far.
const float kFarthestHalf = 65504.0;

vec3 toWorking(vec3 linear) {
  return kCompressed != 0u ? compressByLuma(linear) : linear;
}
vec3 fromWorking(vec3 working) {
  vec3 c = max(working, vec3(0.0));
  return kCompressed != 0u ? expandByLuma(c) : c;
}
// A colour of the frame before in this frame's exposure.
vec3 exposed(vec3 working, float ratio) {
  return kCompressed != 0u ? toWorking(fromWorking(working) * ratio) : working * ratio;
}
// Luma in [0, 1), as the published rule takes it: tone mapped.
float toneMappedLuma(vec3 working) {
  float luma = lumaYCoCg(working);
  return kCompressed != 0u ? luma : luma / (1.0 + luma);
}

struct Origin {
  vec2 px;  // in the previous frame, inside it
  float view_depth;
  float speed_px;
  bool valid;
  bool still;
};

// Where the pixel was (README.md, eq. 1), before the depth test.
Origin originOf(sampler2D depth_image, sampler2D motion_image, PhlmConstants k, ivec2 px,
                ivec2 last_px) {
  ivec2 surface_px = px;
  if (kDilation != 0u) {
    float best = texelFetch(depth_image, px, 0).x * k.frame.depth_order;
    for (int i = 0; i < 4; ++i) {
      ivec2 arm_px = i < 2 ? ivec2(2 * i - 1, 0) : ivec2(0, 2 * i - 5);
      ivec2 at_px = clamp(px + arm_px, ivec2(0), last_px);
      float depth = texelFetch(depth_image, at_px, 0).x * k.frame.depth_order;
      if (depth < best) {
        best = depth;
        surface_px = at_px;
      }
    }
  }
  Origin origin;
  vec2 motion_px = motionPx(k.frame, texelFetch(motion_image, surface_px, 0).xy);
  vec2 previous_px =
      (vec2(px) + 0.5 + motion_px) * (k.frame.previous_extent_px / k.frame.extent_px);
  origin.px = clamp(previous_px, vec2(0.5), k.frame.previous_extent_px - 0.5);
  origin.view_depth =
      min(viewDepth(k.frame, texelFetch(depth_image, surface_px, 0).x), kFarthestHalf);
  origin.speed_px = length(motion_px);
  origin.valid = k.frame.has_history > 0.5 && isOnScreen(previous_px, k.frame.previous_extent_px);
  origin.still = kStill != 0u && origin.speed_px < kStillMotion_px;
  return origin;
}

// Nehab et al. 2007: the surface that the history saw there is this one.
bool sameSurface(PhlmConstants k, Origin origin, ivec2 px, float history_depth) {
  if (k.depth_tolerance <= 0.0) return true;
  float expected = expectedPreviousDepth(k.frame.previous_depth_coefficients,
                                         vec2(px) + 0.5 - k.frame.jitter_px, origin.view_depth);
  return depthsAgree(min(expected, kFarthestHalf), history_depth, k.depth_tolerance);
}

vec3 lowPassed(vec3 s[9]) {
  if (kLowPass == kLowPassNone) return s[4];
  if (kLowPass == kLowPassBox) return meanSample(s);
  return (s[0] + s[2] + s[6] + s[8] + 2.0 * (s[1] + s[3] + s[5] + s[7]) + 4.0 * s[4]) *
         (1.0 / 16.0);
}

// Section 5.1 of the paper (eq. 2); `previous` is the feature where the pixel was.
vec3 temporalFeature(PhlmConstants k, vec3 s[9], vec3 previous, Origin origin) {
  vec3 fresh = lowPassed(s);
  if (!origin.valid) return fresh;
  float low = toneMappedLuma(s[0]);
  float high = low;
  for (int i = 1; i < 9; ++i) {
    float luma = toneMappedLuma(s[i]);
    low = min(low, luma);
    high = max(high, luma);
  }
  float luma = toneMappedLuma(previous);
  float distance = min(abs(luma - low), abs(high - luma));
  float alpha = featureAlpha(distance, high - low, origin.speed_px, k.feature_a, k.feature_b);
  if (kFeatureWeight == kWeightOld) alpha = 1.0 - alpha;
  return mix(previous, fresh, clamp(alpha, k.feature_floor, 1.0));
}

#endif
