// SPDX-License-Identifier: MIT
//
// Where a pixel's surface was when each subpixel buffer was written, and which of a buffer's texels
// show it there.
#ifndef REPRISE_AMORTIZED_REPROJECT_GLSL
#define REPRISE_AMORTIZED_REPROJECT_GLSL

#include "equations/amortized.h"
#include "techniques/amortized/gathered.glsl"

// Exact: motion to the frame of buffer k. Chained: 0 and 1 hold, two buffers each, the motion from
// the previous frame to that of the buffers.
layout(binding = 2) uniform sampler2D past_motion_0;
layout(binding = 3) uniform sampler2D past_motion_1;
layout(binding = 4) uniform sampler2D past_motion_2;
layout(binding = 5) uniform sampler2D past_motion_3;
// rgb: estimate; a: view depth of the surface, 0: never written.
layout(binding = 6) uniform sampler2D buffer_0;
layout(binding = 7) uniform sampler2D buffer_1;
layout(binding = 8) uniform sampler2D buffer_2;
layout(binding = 9) uniform sampler2D buffer_3;

// A Jacobian flatter than this is not inverted: the surface is seen edge-on.
const float kFlattest = 0.05;
// Depths of one surface may leave the plane through its pixel by this share of its slope.
const float kBend = 0.25;
// Beyond the jitter's own reach motion uncovers what lies behind an edge.
const float kReachOfJitter_px = 0.5;
// The pixel's own tent (20), twice as wide as a buffer's.
const float kPixelTentRadius_px = 1.0;

// The way from a pixel's surface to one of the buffers.
struct Way {
  vec2 motion_px;
  // View depth then, beyond that of a point at rest; where the host does not say it
  // (`shift_known` 0), anything between that and the depth now is the same surface.
  float depth_shift;
  float shift_known;
};

vec2 previousPx(Surface s) {
  return s.center_px + s.motion_px;
}

// Motion of the surface to the frames of the buffers 2 i and 2 i + 1.
vec4 chainedMotion(Surface s, sampler2D past, uint first) {
  vec2 previous_px = clamp(previousPx(s), vec2(0.5), k.frame.extent_px - 0.5);
  vec4 before = textureLod(past, previous_px * k.frame.history_texel_uv, 0.0);
  // A buffer that the previous frame wrote is one step away, whatever the field says.
  if (k.slots[first].place_age.z < 1.5) before.xy = vec2(0.0);
  if (k.slots[first + 1u].place_age.z < 1.5) before.zw = vec2(0.0);
  return s.motion_px.xyxy + before;
}

Way exactWay(Surface s, uint b) {
  vec4 texel = vec4(0.0);
  if (b == 0u) texel = texelFetch(past_motion_0, s.px, 0);
  if (b == 1u) texel = texelFetch(past_motion_1, s.px, 0);
  if (b == 2u) texel = texelFetch(past_motion_2, s.px, 0);
  if (b == 3u) texel = texelFetch(past_motion_3, s.px, 0);
  vec2 motion_px = texel.xy * k.frame.motion_scale;
  bool valid = abs(motion_px.x) < kMaxMotion_px && abs(motion_px.y) < kMaxMotion_px;
  Way way = Way(valid ? motion_px : vec2(2.0 * kMaxMotion_px), 0.0, 0.0);
  // Images of two channels read 0 in the third.
  if (texel.z > 0.0) {
    vec2 at_px = s.center_px - k.frame.jitter_px;
    way.depth_shift =
        texel.w - expectedPreviousDepth(k.slots[b].depth_coefficients, at_px, texel.z);
    way.shift_known = 1.0;
  }
  return way;
}

// pi_{t-a}(center) of each buffer, minus the centre.
void waysToBuffers(Surface s, out Way ways[4], out vec4 chained[2]) {
  chained[0] = vec4(0.0);
  chained[1] = vec4(0.0);
  if (kExactMotion != 0u) {
    for (uint b = 0u; b < kSlots; ++b) ways[b] = exactWay(s, b);
    return;
  }
  chained[0] = chainedMotion(s, past_motion_0, 0u);
  ways[0] = Way(chained[0].xy, 0.0, 0.0);
  ways[1] = Way(chained[0].zw, 0.0, 0.0);
  if (kSlots > 2u) {
    chained[1] = chainedMotion(s, past_motion_1, 2u);
    ways[2] = Way(chained[1].xy, 0.0, 0.0);
    ways[3] = Way(chained[1].zw, 0.0, 0.0);
  }
}

// Four texels of a buffer about the surface's place in it.
struct Footprint {
  vec2 base;      // the first of them
  vec2 point;     // (14), from it
  vec2 column_x;  // of the Jacobian, which is that of one frame, carried on over the buffer's age
  vec2 column_y;
  float growth;  // (15)
  bool readable;
};

Footprint footprintIn(SlotState state, vec2 place_px, Surface s, vec2 motion_px, vec2 offset_px) {
  Footprint f;
  float age = state.place_age.z;
  f.column_x = vec2(1.0, 0.0) + age * s.motion_dx;
  f.column_y = vec2(0.0, 1.0) + age * s.motion_dy;
  vec2 there_px = s.center_px + motion_px + f.column_x * offset_px.x + f.column_y * offset_px.y;
  f.readable = state.place_age.w > 0.5 && isOnScreen(there_px, k.frame.extent_px);
  vec2 point = there_px - place_px - 0.5;
  f.base = floor(point);
  f.point = point - f.base;
  f.growth = tentGrowth(f.column_x, f.column_y);
  return f;
}

// Which of a footprint's texels show the surface; `depths` is what they hold. Each is 1 or 0.
vec4 validTexels(vec4 depths, Footprint f, SlotState state, Surface s, Way way) {
  // Where the texels' depths were sampled, as pixels of this frame: the inverse of the Jacobian
  // takes them there.
  float determinant = f.column_x.x * f.column_y.y - f.column_x.y * f.column_y.x;
  bool upright = determinant > kFlattest;
  vec2 row_x = upright ? vec2(f.column_y.y, -f.column_y.x) / determinant : vec2(1.0, 0.0);
  vec2 row_y = upright ? vec2(-f.column_x.y, f.column_x.x) / determinant : vec2(0.0, 1.0);
  vec2 from_px = f.base + 0.5 - state.jitter_px - s.center_px - way.motion_px;
  float steepness = abs(s.inverse_slope.x) + abs(s.inverse_slope.y);
  vec4 nearest;
  vec4 farthest;
  for (int i = 0; i < 4; ++i) {
    vec2 step_px = from_px + vec2(i & 1, i >> 1);
    vec2 at_px = s.center_px + vec2(dot(row_x, step_px), dot(row_y, step_px));
    float inverse = s.inverse_depth + dot(s.inverse_slope, at_px - s.depth_px);
    // Beyond a plane's horizon it is as far as can be.
    float now = 1.0 / max(inverse, 1.0 / kMaxViewDepth);
    float at_rest = expectedPreviousDepth(state.depth_coefficients, at_px, now);
    // Only the camera's motion is known to it. What moves by itself may have kept its depth, as a
    // horse does that the camera runs beside.
    float moved = way.shift_known > 0.5 ? at_rest + way.depth_shift : now;
    float other = way.shift_known > 0.5 ? moved : at_rest;
    nearest[i] = min(moved, other);
    farthest[i] = max(moved, other);
  }
  nearest = min(nearest, vec4(kFarthestHalf));
  farthest = min(farthest, vec4(kFarthestHalf));
  // What a surface bends within the footprint, as a share of its slope.
  vec4 tolerance = farthest * (k.depth_tolerance + kBend * steepness * farthest);
  // At a silhouette the jitter moves the edge across the pixel: what lies behind the edge now may
  // have been in the pixel then.
  vec4 off = max(nearest - depths, depths - farthest - vec4(s.depth_span));
  vec4 valid = mix(vec4(0.0), vec4(1.0), lessThanEqual(off, tolerance));
  valid *= vec4(greaterThan(depths, vec4(0.0)));
  // Texels outside the frame hold nothing; the sampler would repeat the border.
  vec2 last = k.frame.extent_px - 1.0;
  vec2 base = f.base;
  vec2 low = vec2(greaterThanEqual(base, vec2(0.0))) * vec2(lessThanEqual(base, last));
  vec2 high = vec2(greaterThanEqual(base + 1.0, vec2(0.0))) * vec2(lessThanEqual(base + 1.0, last));
  return valid * vec4(low.x * low.y, high.x * low.y, low.x * high.y, high.x * high.y);
}

vec4 depthsIn(sampler2D image, Footprint f) {
  return textureGather(image, (f.base + 1.0) * k.frame.history_texel_uv, 3).wzxy;
}

// Texels of the previous frame that show the surface, with their shares: of N, of residuals.
struct Previous {
  ivec2 base;
  vec4 shares;  // sum 1, or 0 where none does
};

// `newest` is the buffer that the previous frame wrote. Where an edge moves, what lay behind it
// shares its colour with the pixel, as validTexels allows, but not its count: a pixel just
// uncovered would inherit the trust of the one beside it.
Previous previousOf(sampler2D newest, Surface s, Way ways[4]) {
  Way way = Way(s.motion_px, 0.0, 0.0);
  SlotState state = k.slots[0];
  state.place_age = vec4(0.0, 0.0, 1.0, 1.0);
  bool tested = k.previous_slot > -0.5;
  for (uint b = 0u; b < kSlots; ++b) {
    if (float(b) != k.previous_slot) continue;
    state = k.slots[b];
    way = Way(s.motion_px, ways[b].depth_shift, ways[b].shift_known);
  }
  if (length(s.motion_px) > kReachOfJitter_px) s.depth_span = 0.0;
  Footprint f = footprintIn(state, vec2(0.0), s, s.motion_px, vec2(0.0));
  vec4 w = tentWeights(f.point.x, f.point.y, 1.0);
  if (tested) w *= validTexels(depthsIn(newest, f), f, state, s, way);
  float sum = w.x + w.y + w.z + w.w;
  return Previous(ivec2(f.base), sum > 0.0 && f.readable ? w / sum : vec4(0.0));
}

ivec2 texelOf(ivec2 base, int i) {
  return clamp(base + ivec2(i & 1, i >> 1), ivec2(0), ivec2(k.frame.extent_px) - 1);
}

// N of the previous frame where the surface was; 0 where nothing shows it.
float samplesBefore(sampler2D counts, Previous previous) {
  float sum = 0.0;
  for (int i = 0; i < 4; ++i) {
    sum += previous.shares[i] * texelFetch(counts, texelOf(previous.base, i), 0).x;
  }
  return sum;
}

vec4 texelIn(uint b, ivec2 texel) {
  if (b == 0u) return texelFetch(buffer_0, texel, 0);
  if (b == 1u) return texelFetch(buffer_1, texel, 0);
  if (b == 2u) return texelFetch(buffer_2, texel, 0);
  return texelFetch(buffer_3, texel, 0);
}

float sumOf(vec4 w) {
  return w.x + w.y + w.z + w.w;
}

// A buffer failed for the pixel when more of its tent is unseen than seen.
bool reprojectionFailed(float seen, float whole) {
  return seen <= 0.0 || 2.0 * seen <= whole;
}

#endif
