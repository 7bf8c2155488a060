// SPDX-License-Identifier: MIT
//
// Checkerboard rendering: every other pixel was shaded, and nothing is known of the rest. Equation
// numbers refer to README.md of this folder.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/frame_inputs.glsl"
#include "core/half_rounding.glsl"
#include "core/history_filters.glsl"
#include "core/neighbourhood.glsl"
#include "core/workgroup.h"
#include "equations/checkerboard.h"
#include "equations/coarse.h"
#include "equations/color_space.h"
#include "techniques/checkerboard/checkerboard_shared.h"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

layout(constant_id = 0) const uint kBounded = 0u;
layout(constant_id = 1) const uint kSpatial = 0u;
layout(constant_id = 2) const uint kHistoryClamp = 1u;

layout(binding = 0) uniform sampler2D color_image;
layout(binding = 1) uniform sampler2D depth_image;
layout(binding = 2) uniform sampler2D motion_image;
layout(binding = 3) uniform sampler2D history_image;        // rgb linear, a: summed weight
layout(binding = 4) uniform sampler2D history_depth_image;  // r: view depth
layout(binding = 5) writeonly uniform image2D next_history_image;
layout(binding = 6) writeonly uniform image2D next_depth_image;
layout(binding = 7) writeonly uniform image2D output_image;
layout(binding = 8, std140) uniform Constants {
  CheckerboardConstants k;
};

// Motion below this is none (px): what half-precision motion images leave of a still camera.
const float kStillMotion_px = 0.01;
// Narrowest filter among the samples that fill a gap: below it nothing but the nearest would count.
const float kFillSigma_px = 0.5;
// Samples of the shaded half within 5 x 5 pixels without its corners, nearest first: of a pixel
// that was shaded, and of one that was not.
const int kMostSamples = 12;
const ivec2 kAroundShaded[kMostSamples] =
    ivec2[](ivec2(0, 0), ivec2(-1, -1), ivec2(1, -1), ivec2(-1, 1), ivec2(1, 1), ivec2(0, -2),
            ivec2(-2, 0), ivec2(2, 0), ivec2(0, 2), ivec2(0, 0), ivec2(0, 0), ivec2(0, 0));
const ivec2 kAroundMissing[kMostSamples] =
    ivec2[](ivec2(0, -1), ivec2(0, 1), ivec2(-1, 0), ivec2(1, 0), ivec2(-1, -2), ivec2(1, -2),
            ivec2(-2, -1), ivec2(2, -1), ivec2(-2, 1), ivec2(2, 1), ivec2(-1, 2), ivec2(1, 2));
const int kSamplesAroundShaded = 9;
// How far from where a depth was sampled a history tap may have been: one texel, and two jitters of
// half a pixel.
const float kPlaneReach_px = 2.0;
// Share of its own change by which a plane's inverse depths may miss a plane: halves' rounding.
const float kPlaneResidual = 0.25;
// The samples within one pixel's reach, whose nearest surface leads.
const int kNearShaded = 5;
const int kNearMissing = 4;

// Change of inverse depth over a pixel, both axes together, where the samples around lie in a plane
// or on one side of a silhouette; 0 elsewhere.
float inverseSlope(float v[kNearShaded], bool shaded) {
  if (shaded) {
    // Over each diagonal, a step of a pixel along both axes, the smaller of the two sides.
    return min(abs(v[1] - v[0]), abs(v[4] - v[0])) + min(abs(v[2] - v[0]), abs(v[3] - v[0]));
  }
  float change = 0.5 * (abs(v[0] - v[1]) + abs(v[2] - v[3]));
  bool plane = abs(v[0] + v[1] - v[2] - v[3]) <= kPlaneResidual * change + 1.0e-7;
  return plane ? change : 0.0;
}

void main() {
  ivec2 px = ivec2(gl_GlobalInvocationID.xy);
  ivec2 last_px = ivec2(k.frame.extent_px) - 1;
  if (any(greaterThan(px, last_px))) return;
  vec2 center_px = vec2(px) + 0.5;
  bool shaded = isShaded(px.x, px.y, int(k.half_shaded));
  int near = shaded ? kNearShaded : kNearMissing;

  vec3 samples[kMostSamples];
  float inside[kMostSamples];
  vec3 sum = vec3(0.0);
  vec3 sum_of_squares = vec3(0.0);
  float count = 0.0;
  float inverse_depths[kNearShaded];
  ivec2 front_px = px;
  float front = 3.0e38;
  for (int i = 0; i < kMostSamples; ++i) {
    ivec2 at = px + (shaded ? kAroundShaded[i] : kAroundMissing[i]);
    bool used = !shaded || i < kSamplesAroundShaded;
    inside[i] =
        used && all(greaterThanEqual(at, ivec2(0))) && all(lessThanEqual(at, last_px)) ? 1.0 : 0.0;
    samples[i] = yCoCgFromRgb(fetchColor(color_image, at, last_px));
    sum += inside[i] * samples[i];
    sum_of_squares += inside[i] * samples[i] * samples[i];
    count += inside[i];
    if (i < kNearShaded) {
      float depth = texelFetch(depth_image, clamp(at, ivec2(0), last_px), 0).x;
      inverse_depths[i] = inside[i] / viewDepth(k.frame, depth);
      bool nearer = i < near && inside[i] > 0.5 && depth * k.frame.depth_order < front;
      front = nearer ? depth * k.frame.depth_order : front;
      front_px = nearer ? at : front_px;
    }
  }
  bool known = count > 0.5;

  vec2 motion_px = motionPx(k.frame, texelFetch(motion_image, front_px, 0).xy);
  // Frames of one pixel have no neighbour to ask: what was there stays.
  if (!known) motion_px = vec2(0.0);
  float view_depth = viewDepth(k.frame, texelFetch(depth_image, front_px, 0).x);
  vec2 previous_extent_px = k.frame.previous_extent_px;
  vec2 previous_px = (center_px + motion_px) * (previous_extent_px / k.frame.extent_px);
  vec2 inside_px = clamp(previous_px, vec2(0.5), previous_extent_px - 0.5);
  vec2 last_center_px = previous_extent_px - 0.5;
  bool hit = k.frame.has_history > 0.5 && isOnScreen(previous_px, previous_extent_px);

  // History of nearer surfaces is not this one's, tap by tap: (0,0) (1,0) (0,1) (1,1).
  vec4 then = textureGather(history_depth_image, inside_px * k.frame.history_texel_uv, 0).wzxy;
  float expected = expectedPreviousDepth(k.frame.previous_depth_coefficients,
                                         center_px - k.frame.jitter_px, view_depth);
  expected = min(expected, kMaxViewDepth);
  float slope = kPlaneReach_px * inverseSlope(inverse_depths, shaded);
  vec4 valid;
  for (int i = 0; i < 4; ++i) {
    valid[i] = wasVisibleOnPlane(expected, then[i], k.depth_tolerance, slope) ? 1.0 : 0.0;
  }
  if (!known) valid = vec4(1.0);
  float valid_taps = dot(valid, vec4(1.0));
  hit = hit && valid_taps > 0.5;
  vec4 inner[4] = innerTexels(history_image, inside_px, last_center_px);
  vec4 history = cubicAroundInner(inner, history_image, inside_px, k.frame.history_texel_uv,
                                  last_center_px, k.history_sharpness);
  if (kHistoryClamp != 0u) history = withinInner(history, inner);
  if (hit && valid_taps < 3.5) history = validOfInner(inner, inside_px, valid);
  bool still = length(motion_px) < kStillMotion_px;
  float held = hit ? min(history.a, still ? k.held_limit_still : k.held_limit) : 0.0;

  // What this frame says of the pixel (eq. 1), or of the four around it (eq. 2, 3).
  vec3 current = samples[0];
  float weight = gaussianFilter(length(k.frame.jitter_px), k.sigma_px);
  if (!shaded) {
    vec3 mixture = vec3(0.0);
    float weights = 0.0;
    weight = 0.0;
    float steep[2];
    for (int axis = 0; axis < 2; ++axis) {
      vec3 difference = samples[2 * axis] - samples[2 * axis + 1];
      bool both = inside[2 * axis] * inside[2 * axis + 1] > 0.5;
      steep[axis] = both ? length(difference) : 0.0;
    }
    for (int i = 0; i < kNearMissing; ++i) {
      float distance_px = length(vec2(kAroundMissing[i]) - k.frame.jitter_px);
      float near_weight = inside[i] * gaussianFilter(distance_px, k.sigma_px);
      weight = max(weight, near_weight);
      float share = inside[i] * gaussianFilter(distance_px, max(k.sigma_px, kFillSigma_px));
      if (kSpatial == kSpatialDifferential) share *= differentialWeight(steep[i / 2]);
      mixture += share * samples[i];
      weights += share;
    }
    current = mixture / max(weights, 1.0e-8);
  }

  vec3 previous = yCoCgFromRgb(sanitizedColor(history.rgb * k.frame.exposure_ratio));
  vec3 bounded = previous;
  if (kBounded != 0u && known) {
    vec3 mean = sum / count;
    vec3 deviation = deviationFromMoments(mean, sum_of_squares / count);
    vec3 reach = (still ? k.gamma_still : k.gamma) * deviation + boundSlack(previous, current);
    bounded = clipTowardBoxCentre(mean - reach, mean + reach, previous);
  }

  float alpha = known ? weightedMeanAlpha(weight, held) : 0.0;
  // Without history a sample counts, however far from the pixel.
  if (held < 1.0e-6 && known) alpha = 1.0;
  vec3 mixed = held < 1.0e-6 ? current : mix(bounded, current, alpha);
  vec3 result = known || hit ? max(rgbFromYCoCg(mixed), vec3(0.0)) : vec3(0.0);
  vec3 stored = roundedToHalf(min(result, vec3(kMaxColor)), px, k.frame.frame_number, true);
  // Half precision loses small weights beside large sums: no more than 2048 of the smallest.
  imageStore(next_history_image, px, vec4(stored, min(held + weight, 2048.0)));
  imageStore(next_depth_image, px, vec4(known ? view_depth : then.x, 0.0, 0.0, 0.0));
  imageStore(output_image, px, vec4(result, 1.0));
}
