// SPDX-License-Identifier: MIT
//
// Where a pixel's surface was when each subpixel buffer was written, and what the buffer holds
// there. Shared by the resolve and the request pass, which must agree on what counts.
#ifndef REPRISE_AMORTIZED_REPROJECT_GLSL
#define REPRISE_AMORTIZED_REPROJECT_GLSL

#include "core/frame_inputs.glsl"
#include "equations/amortized.h"
#include "techniques/amortized/amortized_shared.h"

// Images that hold buffers; how many of them are in use is known when a frame is recorded.
layout(constant_id = 0) const uint kSlots = 4u;
// 0: motion of frame pairs, chained; 1: the host's motion to each buffer's frame.
layout(constant_id = 1) const uint kExactMotion = 0u;
// 1: the projection is jittered, so that surfaces change from frame to frame at silhouettes.
layout(constant_id = 2) const uint kSilhouettes = 0u;

layout(binding = 0) uniform sampler2D depth_image;
layout(binding = 1) uniform sampler2D motion_image;
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

// A global, not an argument: an argument would be copied, 4 KiB an invocation, wherever a loop over
// slots is not unrolled. The includer says at which binding.
layout(binding = kConstantsBinding, std140) uniform Constants {
  AmortizedConstants k;
};

// Depth lies in the alpha of RGBA16F; what is farther than a half can say is equally far.
const float kFarthestHalf = 65504.0;
// Changes of motion from pixel to pixel beyond this are silhouettes, not the surface's own.
const float kSteepestMotion = 0.5;

struct Surface {
  ivec2 px;
  vec2 center_px;
  float view_depth;
  vec2 depth_slope;  // change of depth over a pixel of the surface
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

// Differences to the neighbour of nearer depth: across a silhouette they would not be the
// surface's own.
Surface surfaceAt(ivec2 px) {
  ivec2 last_px = ivec2(k.frame.extent_px) - 1;
  Surface s;
  s.px = px;
  s.center_px = vec2(px) + 0.5;
  ivec2 at_px = px;
  s.view_depth = depthAt(px, last_px);
  float farthest = s.view_depth;
  if (kSilhouettes != 0u) {
    // The closest of 3x3: motion reaches half a pixel beyond the edge that is jittered across it.
    for (int i = 0; i < 9; ++i) {
      ivec2 neighbour_px = px + ivec2(i % 3 - 1, i / 3 - 1);
      float depth = depthAt(neighbour_px, last_px);
      farthest = max(farthest, depth);
      if (depth < s.view_depth) {
        s.view_depth = depth;
        at_px = clamp(neighbour_px, ivec2(0), last_px);
      }
    }
  }
  s.depth_span = farthest - s.view_depth;
  s.motion_px = motionAt(at_px, last_px);
  vec2 steps[2];
  for (int axis = 0; axis < 2; ++axis) {
    ivec2 step_px = axis == 0 ? ivec2(1, 0) : ivec2(0, 1);
    float ahead = depthAt(at_px + step_px, last_px) - s.view_depth;
    float behind = s.view_depth - depthAt(at_px - step_px, last_px);
    // At the frame's border the clamped neighbour is the pixel itself: no difference to go by.
    bool first = any(lessThan(at_px - step_px, ivec2(0)));
    bool last = any(greaterThan(at_px + step_px, last_px));
    bool forward = !last && (first || abs(ahead) <= abs(behind));
    s.depth_slope[axis] = forward ? ahead : behind;
    steps[axis] = forward ? motionAt(at_px + step_px, last_px) - s.motion_px
                          : s.motion_px - motionAt(at_px - step_px, last_px);
    steps[axis] = clamp(steps[axis], vec2(-kSteepestMotion), vec2(kSteepestMotion));
  }
  s.motion_dx = steps[0];
  s.motion_dy = steps[1];
  return s;
}

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

vec2 exactMotion(Surface s, uint buffer_index) {
  vec2 texel = vec2(0.0);
  if (buffer_index == 0u) texel = texelFetch(past_motion_0, s.px, 0).xy;
  if (buffer_index == 1u) texel = texelFetch(past_motion_1, s.px, 0).xy;
  if (buffer_index == 2u) texel = texelFetch(past_motion_2, s.px, 0).xy;
  if (buffer_index == 3u) texel = texelFetch(past_motion_3, s.px, 0).xy;
  vec2 motion_px = texel * k.frame.motion_scale;
  bool valid = abs(motion_px.x) < kMaxMotion_px && abs(motion_px.y) < kMaxMotion_px;
  return valid ? motion_px : vec2(2.0 * kMaxMotion_px);
}

// pi_{t-a}(center) of each buffer, minus the centre.
void motionsToBuffers(Surface s, out vec2 motions_px[4], out vec4 chained[2]) {
  chained[0] = vec4(0.0);
  chained[1] = vec4(0.0);
  if (kExactMotion != 0u) {
    for (uint b = 0u; b < kSlots; ++b) motions_px[b] = exactMotion(s, b);
    return;
  }
  chained[0] = chainedMotion(s, past_motion_0, 0u);
  motions_px[0] = chained[0].xy;
  motions_px[1] = chained[0].zw;
  if (kSlots > 2u) {
    chained[1] = chainedMotion(s, past_motion_1, 2u);
    motions_px[2] = chained[1].xy;
    motions_px[3] = chained[1].zw;
  }
}

// Which of four texels, whose first is at `base`, show the surface; `depths` is what they hold, and
// `state` of the frame that wrote them. 1 or 0 each.
vec4 validTexels(vec4 depths, vec2 base, SlotState state, Surface s, vec2 offset_px) {
  float view_depth = s.view_depth + dot(s.depth_slope, offset_px);
  float expected = expectedPreviousDepth(state.depth_coefficients,
                                         s.center_px - k.frame.jitter_px + offset_px, view_depth);
  expected = min(expected, kFarthestHalf);
  // Only the camera's motion is known to it. What moves by itself may have kept its depth, as a
  // horse does that the camera runs beside: anything between the two is the same surface.
  float same_depth = min(view_depth, kFarthestHalf);
  // A slanted surface differs from texel to texel by its slope; a half adds its rounding.
  vec4 slack =
      vec4(k.depth_tolerance * expected + 1.5 * (abs(s.depth_slope.x) + abs(s.depth_slope.y)));
  vec4 nearer = vec4(min(expected, same_depth)) - depths;
  vec4 farther = depths - vec4(max(expected, same_depth));
  // At a silhouette the jitter moves the edge across the pixel: what lies behind the edge now may
  // have been in the pixel then.
  farther -= vec4(s.depth_span);
  vec4 valid = mix(vec4(0.0), vec4(1.0), lessThanEqual(max(nearer, farther), slack));
  valid *= vec4(greaterThan(depths, vec4(0.0)));
  // Texels outside the frame hold nothing; the sampler would repeat the border.
  vec2 last = k.frame.extent_px - 1.0;
  vec2 low = vec2(greaterThanEqual(base, vec2(0.0))) * vec2(lessThanEqual(base, last));
  vec2 high = vec2(greaterThanEqual(base + 1.0, vec2(0.0))) * vec2(lessThanEqual(base + 1.0, last));
  return valid * vec4(low.x * low.y, high.x * low.y, low.x * high.y, high.x * high.y);
}

// N of the previous frame where the surface was, from the texels of `counts` that show it;
// `newest` is the buffer that frame wrote. 0 where none does.
float samplesBefore(sampler2D counts, sampler2D newest, Surface s) {
  vec2 previous_px = previousPx(s);
  if (k.previous_slot < 0.0) {
    vec2 inside_px = clamp(previous_px, vec2(0.5), k.frame.extent_px - 0.5);
    return textureLod(counts, inside_px * k.frame.history_texel_uv, 0.0).x;
  }
  vec2 base = floor(previous_px - 0.5);
  vec2 fraction = previous_px - 0.5 - base;
  vec2 corner_uv = (base + 1.0) * k.frame.history_texel_uv;
  vec4 depths = textureGather(newest, corner_uv, 3).wzxy;
  vec4 w = tentWeights(fraction.x, fraction.y, 1.0) *
           validTexels(depths, base, k.slots[int(k.previous_slot)], s, vec2(0.0));
  float sum = w.x + w.y + w.z + w.w;
  return sum > 0.0 ? dot(w, textureGather(counts, corner_uv, 0).wzxy) / sum : 0.0;
}

// What one buffer gives to a gather: the sum over its texels, and the sum of their weights.
struct Gathered {
  vec3 sum;
  float weight;
  float weight_unseen;  // of texels that the depth test took out
};

Gathered gatherFrom(sampler2D image, Surface s, uint b, vec2 motion_px, vec2 offset_px,
                    float radius_px) {
  Gathered none = Gathered(vec3(0.0), 0.0, 1.0);
  SlotState state = k.slots[b];
  if (state.place_age.w < 0.5) return none;
  float age = state.place_age.z;
  // J is that of one frame, carried on over the buffer's age.
  vec2 column_x = vec2(1.0, 0.0) + age * s.motion_dx;
  vec2 column_y = vec2(0.0, 1.0) + age * s.motion_dy;
  vec2 there_px = s.center_px + motion_px + column_x * offset_px.x + column_y * offset_px.y;
  if (!isOnScreen(there_px, k.frame.extent_px)) return none;

  vec2 point = there_px - state.place_age.xy - 0.5;  // (14), in texels
  vec2 base = floor(point);
  vec2 fraction = point - base;
  vec4 w = tentWeights(fraction.x, fraction.y, radius_px * tentGrowth(column_x, column_y));

  vec4 depths = textureGather(image, (base + 1.0) * k.frame.history_texel_uv, 3).wzxy;
  vec4 valid = validTexels(depths, base, state, s, offset_px);

  float full = w.x + w.y + w.z + w.w;
  vec4 kept = w * valid;
  Gathered gathered;
  gathered.weight = kept.x + kept.y + kept.z + kept.w;
  gathered.weight_unseen = full - gathered.weight;
  if (gathered.weight <= 0.0) return Gathered(vec3(0.0), 0.0, full > 0.0 ? full : 0.0);
  vec3 mean;
  if (gathered.weight_unseen <= 0.0) {
    vec2 at = base + 0.5 + bilinearFraction(w);
    mean = textureLod(image, at * k.frame.history_texel_uv, 0.0).rgb;
  } else {
    ivec2 texel = ivec2(base);
    ivec2 limit = ivec2(k.frame.extent_px) - 1;
    mean = texelFetch(image, clamp(texel, ivec2(0), limit), 0).rgb * kept.x +
           texelFetch(image, clamp(texel + ivec2(1, 0), ivec2(0), limit), 0).rgb * kept.y +
           texelFetch(image, clamp(texel + ivec2(0, 1), ivec2(0), limit), 0).rgb * kept.z +
           texelFetch(image, clamp(texel + ivec2(1, 1), ivec2(0), limit), 0).rgb * kept.w;
    mean /= gathered.weight;
  }
  gathered.sum = mean * state.exposure_ratio * gathered.weight;
  return gathered;
}

Gathered gatherBuffer(uint b, Surface s, vec2 motion_px, vec2 offset_px, float radius_px) {
  if (b == 0u) return gatherFrom(buffer_0, s, b, motion_px, offset_px, radius_px);
  if (b == 1u) return gatherFrom(buffer_1, s, b, motion_px, offset_px, radius_px);
  if (b == 2u) return gatherFrom(buffer_2, s, b, motion_px, offset_px, radius_px);
  return gatherFrom(buffer_3, s, b, motion_px, offset_px, radius_px);
}

// A buffer failed for the pixel when more of its tent is unseen than seen.
bool reprojectionFailed(Gathered gathered) {
  return gathered.weight <= gathered.weight_unseen || gathered.weight <= 0.0;
}

#endif
