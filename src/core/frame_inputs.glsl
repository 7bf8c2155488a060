// SPDX-License-Identifier: MIT
//
// Reading a frame's inputs safely. Conventions and units are those of reprise.h.
#ifndef REPRISE_CORE_FRAME_INPUTS_GLSL
#define REPRISE_CORE_FRAME_INPUTS_GLSL

#include "core/frame_constants.h"
#include "equations/reprojection.h"

// Largest finite half: what history and most colour targets can hold.
const float kMaxColor = 65504.0;
// History keeps view depth; farther than this counts as equally far (sky, clear values, infinity).
const float kMaxViewDepth = 1.0e9;
// Motion longer than this is no motion (px): a NaN, or a buffer that was never written.
const float kMaxMotion_px = 1.0e5;

// A NaN is the one value that is neither below nor at least 0; infinities and negatives are no
// light.
vec3 sanitizedColor(vec3 color) {
  bvec3 valid = bvec3(color.x >= 0.0 && color.x <= 3.0e38, color.y >= 0.0 && color.y <= 3.0e38,
                      color.z >= 0.0 && color.z <= 3.0e38);
  return min(mix(vec3(0.0), color, valid), vec3(kMaxColor));
}

bool isFinite(vec3 color) {
  return all(lessThanEqual(abs(color), vec3(3.0e38)));
}

vec3 fetchColor(sampler2D image, ivec2 px, ivec2 last_px) {
  return sanitizedColor(texelFetch(image, clamp(px, ivec2(0), last_px), 0).rgb);
}

float viewDepth(FrameConstants frame, float depth) {
  float view = viewDepthFromDepth(frame.view_depth_coefficients, depth);
  // Infinite (reversed 0), negative by rounding at infinity, or NaN: as far as can be.
  return view >= 0.0 && view < kMaxViewDepth ? view : kMaxViewDepth;
}

// Motion in px; a value that cannot be one sends the reprojection off screen.
vec2 motionPx(FrameConstants frame, vec2 texel) {
  vec2 motion_px = texel * frame.motion_scale + frame.motion_offset_px;
  bool valid = abs(motion_px.x) < kMaxMotion_px && abs(motion_px.y) < kMaxMotion_px;
  return valid ? motion_px : vec2(2.0 * kMaxMotion_px);
}

#endif
