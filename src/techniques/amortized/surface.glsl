// SPDX-License-Identifier: MIT
//
// The surface that a pixel shows: depth, motion, and how both change over it. Included by every
// pass over pixels, with the frame's constants and what a pipeline is specialized for.
#ifndef REPRISE_AMORTIZED_SURFACE_GLSL
#define REPRISE_AMORTIZED_SURFACE_GLSL

#include "core/frame_inputs.glsl"
#include "techniques/amortized/amortized_shared.h"

// Images that hold buffers; how many of them are in use is known when a frame is recorded.
layout(constant_id = 0) const uint kSlots = 4u;
// 0: motion of frame pairs, chained; 1: the host's motion to each buffer's frame.
layout(constant_id = 1) const uint kExactMotion = 0u;
// 1: the projection is jittered, so that surfaces change from frame to frame at silhouettes.
layout(constant_id = 2) const uint kSilhouettes = 0u;
// 1: residuals are kept and bound alpha (26, 27).
layout(constant_id = 3) const uint kResiduals = 0u;
// 1: the pixel is averaged along its motion.
layout(constant_id = 4) const uint kShutter = 0u;

layout(binding = 0) uniform sampler2D depth_image;
layout(binding = 1) uniform sampler2D motion_image;

// A global, not an argument: an argument would be copied, 4 KiB an invocation, wherever a loop over
// slots is not unrolled. The includer says at which binding.
layout(binding = kConstantsBinding, std140) uniform Constants {
  AmortizedConstants k;
};

// Changes of motion from pixel to pixel beyond this are silhouettes, not the surface's own.
const float kSteepestMotion = 0.5;

struct Surface {
  ivec2 px;
  vec2 center_px;
  float view_depth;
  // Inverse depth is linear over a plane's pixels: at `depth_px`, free of jitter, and its change
  // from pixel to pixel.
  float inverse_depth;
  vec2 depth_px;
  vec2 inverse_slope;
  float depth_span;  // silhouettes: how far behind it the farthest of 3x3 lies
  vec2 motion_px;    // to the previous frame
  vec2 motion_dx;    // d motion_px / d px.x on the surface
  vec2 motion_dy;
};

float depthAt(ivec2 px, ivec2 last_px) {
  return viewDepth(k.frame, texelFetch(depth_image, clamp(px, ivec2(0), last_px), 0).x);
}
vec2 motionAt(ivec2 px, ivec2 last_px) {
  return motionPx(k.frame, texelFetch(motion_image, clamp(px, ivec2(0), last_px), 0).xy);
}

// The pixel that says what is seen in `px`.
struct Seen {
  ivec2 px;
  float view_depth;
  float depth_span;
};

Seen seenIn(ivec2 px, ivec2 last_px) {
  Seen seen = Seen(px, depthAt(px, last_px), 0.0);
  if (kSilhouettes == 0u) return seen;
  // The closest of 3x3: motion reaches half a pixel beyond the edge that is jittered across it.
  float farthest = seen.view_depth;
  for (int i = 0; i < 9; ++i) {
    ivec2 neighbour_px = px + ivec2(i % 3 - 1, i / 3 - 1);
    float depth = depthAt(neighbour_px, last_px);
    farthest = max(farthest, depth);
    if (depth < seen.view_depth) {
      seen.view_depth = depth;
      seen.px = clamp(neighbour_px, ivec2(0), last_px);
    }
  }
  seen.depth_span = farthest - seen.view_depth;
  return seen;
}

// Differences to the neighbour of nearer depth: across a silhouette they would not be the
// surface's own.
Surface surfaceAt(ivec2 px) {
  ivec2 last_px = ivec2(k.frame.extent_px) - 1;
  Seen seen = seenIn(px, last_px);
  ivec2 at_px = seen.px;
  Surface s;
  s.px = px;
  s.center_px = vec2(px) + 0.5;
  s.view_depth = seen.view_depth;
  s.depth_span = seen.depth_span;
  s.inverse_depth = 1.0 / s.view_depth;
  s.depth_px = vec2(at_px) + 0.5 - k.frame.jitter_px;
  s.motion_px = motionAt(at_px, last_px);
  vec2 steps[2];
  for (int axis = 0; axis < 2; ++axis) {
    ivec2 step_px = axis == 0 ? ivec2(1, 0) : ivec2(0, 1);
    float ahead = 1.0 / depthAt(at_px + step_px, last_px) - s.inverse_depth;
    float behind = s.inverse_depth - 1.0 / depthAt(at_px - step_px, last_px);
    // At the frame's border the clamped neighbour is the pixel itself: no difference to go by.
    bool first = any(lessThan(at_px - step_px, ivec2(0)));
    bool last = any(greaterThan(at_px + step_px, last_px));
    bool forward = !last && (first || abs(ahead) <= abs(behind));
    s.inverse_slope[axis] = forward ? ahead : behind;
    int direction = forward ? 1 : -1;
    vec2 step_motion_px = motionAt(at_px + direction * step_px, last_px) - s.motion_px;
    steps[axis] = clamp(float(direction) * step_motion_px, -kSteepestMotion, kSteepestMotion);
  }
  s.motion_dx = steps[0];
  s.motion_dy = steps[1];
  return s;
}

#endif
