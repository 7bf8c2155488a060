// SPDX-License-Identifier: MIT
// Depth conventions, where a point was, and whether that was the same surface.
#ifndef REPRISE_EQUATIONS_REPROJECTION_H
#define REPRISE_EQUATIONS_REPROJECTION_H

#include "equations/language.h"
EQ_BEGIN

// view_depth = (k.x d + k.y) / (k.z d + k.w); one form for every RepriseDepthKind.
EQ_FN float viewDepthFromDepth(vec4 k, float depth) {
  return (k.x * depth + k.y) / (k.z * depth + k.w);
}

// |d(1 / view_depth) / d(depth)|: what turns a slope of depths into one of inverse view depths. A
// constant in perspective.
EQ_FN float inverseDepthSlope(vec4 k, float depth) {
  float numerator = k.x * depth + k.y;
  return abs(k.z * k.y - k.x * k.w) / max(numerator * numerator, 1.0e-24f);
}

// View depth in the previous frame of a point that did not move in the world and is now at `px`
// with `view_depth` (previousDepthCoefficients).
EQ_FN float expectedPreviousDepth(vec4 k, vec2 px, float view_depth) {
  return view_depth * (k.x * px.x + k.y * px.y + k.z) + k.w;
}

// Screen spaces: x right, y down; pixels with centres at + 0.5, uv [0, 1], NDC [-1, 1] (Vulkan).
EQ_FN vec2 uvFromPx(vec2 px, vec2 extent_px) {
  return px / extent_px;
}
EQ_FN vec2 pxFromUv(vec2 uv, vec2 extent_px) {
  return uv * extent_px;
}
EQ_FN vec2 ndcFromUv(vec2 uv) {
  return uv * 2.0f - vec2(1.0f);
}
EQ_FN vec2 uvFromNdc(vec2 ndc) {
  return ndc * 0.5f + vec2(0.5f);
}
// What a jitter adds to clip.xy / clip.w; y changes sign where clip space has y up.
EQ_FN vec2 ndcFromJitter(vec2 jitter_px, vec2 extent_px) {
  return jitter_px * 2.0f / extent_px;
}

// One-sided: false only if the point now seen lies behind what the history saw there, so that it
// was hidden. A point in front may be the same one: history depth of a silhouette can be the
// background's.
EQ_FN bool wasVisible(float expected_depth, float history_depth, float tolerance) {
  return expected_depth <= history_depth * (1.0f + tolerance);
}

// The same on surfaces seen at a slant, whose depth a history sample has somewhere within a few
// pixels: in inverse depth, which is linear over a plane's pixels, it may be nearer by
// `slope_inverse`, the plane's change over that distance.
EQ_FN bool wasVisibleOnPlane(float expected_depth, float history_depth, float tolerance,
                             float slope_inverse) {
  // 1 / history <= (1 + tolerance) / expected + slope, times both depths.
  float expected = max(expected_depth, 0.0f);
  return expected <= history_depth * (1.0f + tolerance + slope_inverse * expected);
}

// Nehab et al. 2007: both depths of one surface, up to a relative tolerance of the farther.
EQ_FN bool depthsAgree(float a, float b, float tolerance) {
  return abs(a - b) <= tolerance * max(a, b);
}

// Inside the frame, half a pixel of border included: the outermost texels are still to be had
// there.
EQ_FN bool isOnScreen(vec2 px, vec2 extent_px) {
  return px.x >= 0.0f && px.y >= 0.0f && px.x <= extent_px.x && px.y <= extent_px.y;
}

// Bilinear weights of the texels (0,0) (1,0) (0,1) (1,1) for the fraction (fx, fy), with those
// whose `valid` is 0 left out and the rest renormalized. Valid texels that bilinear gives no weight
// share it.
EQ_FN vec4 validTapWeights(float fx, float fy, vec4 valid) {
  vec4 w = vec4((1.0f - fx) * (1.0f - fy), fx * (1.0f - fy), (1.0f - fx) * fy, fx * fy);
  w = (w + vec4(1.0e-4f)) * valid;
  float sum = w.x + w.y + w.z + w.w;
  return w / max(sum, 1.0e-8f);
}

// Lopez 2022, trick 1: distrust by the length of the difference of the motion now and of the motion
// that the history pixel had, 0 up to `tolerance_px`, 1 at ten times it.
EQ_FN float motionDifferenceRamp(vec2 now_px, vec2 then_px, float tolerance_px) {
  vec2 difference_px = vec2(now_px.x - then_px.x, now_px.y - then_px.y);
  return clamp((length(difference_px) - tolerance_px) / (9.0f * max(tolerance_px, 1.0e-6f)), 0.0f,
               1.0f);
}

EQ_END

#ifdef __cplusplus
namespace reprise::eq {

// C++ only: evaluated once a frame. `kind` is a RepriseDepthKind; the formulas are in reprise.h,
// divided by the far plane, which may be infinite (not for orthographic).
inline vec4 viewDepthCoefficients(int kind, float near_plane, float far_plane) {
  const float n = near_plane;
  const float f = far_plane;
  const float ratio = n / f;
  switch (kind) {
    case 0:
      return vec4(0.0f, n, ratio - 1.0f, 1.0f);  // device
    case 1:
      return vec4(0.0f, n, 1.0f - ratio, ratio);  // device, reversed
    case 2:
      return vec4(0.0f, n, -1.0f, 1.0f);  // device, infinite
    case 3:
      return vec4(0.0f, n, 1.0f, 0.0f);  // reversed, infinite
    case 5:
      return vec4(f - n, n, 0.0f, 1.0f);  // orthographic
    default:
      return vec4(1.0f, 0.0f, 0.0f, 1.0f);  // planar
  }
}

// Coefficients of expectedPreviousDepth. All matrices column-major; views map the world to camera
// space with -z forward; `projection` is this frame's, without jitter, to clip space with y down.
// With p = (2 px.x / w - 1, 2 px.y / h - 1) in NDC the view-space point of depth z is
//   x = z (p.x + P8) / P0,  y = z (p.y + P9) / P5,  -z   (perspective: clip.w = z),
// and its previous depth is minus the third row of previous_view * inverse(view) applied to it. The
// rotation of a view matrix is orthonormal, so the inverse is its transpose.
inline vec4 previousDepthCoefficients(const float* view, const float* projection,
                                      const float* previous_view, float width_px, float height_px) {
  const bool orthographic = projection[15] == 1.0f && projection[11] == 0.0f;
  // In double: both translations can be large and nearly cancel.
  double row[3];  // third row of the rotation part of previous_view * inverse(view)
  for (int column = 0; column < 3; ++column) {
    row[column] = 0.0;
    for (int i = 0; i < 3; ++i) {
      row[column] += static_cast<double>(previous_view[4 * i + 2]) * view[4 * i + column];
    }
  }
  // Third component of the translation: t' - R' R^T t, with row = third row of R' R^T.
  const auto offset = static_cast<float>(
      previous_view[14] - (row[0] * view[12] + row[1] * view[13] + row[2] * view[14]));
  const auto turn = static_cast<float>(row[2]);
  if (orthographic) {
    // x and y do not scale with z: the affine form in z holds only for views that do not turn.
    return vec4(0.0f, 0.0f, turn, -offset);
  }
  const float ax = -static_cast<float>(row[0]) / projection[0];
  const float ay = -static_cast<float>(row[1]) / projection[5];
  return vec4(ax * 2.0f / width_px, ay * 2.0f / height_px,
              ax * (projection[8] - 1.0f) + ay * (projection[9] - 1.0f) + turn, -offset);
}

}  // namespace reprise::eq
#endif

#endif
