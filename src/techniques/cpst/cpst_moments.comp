// SPDX-License-Identifier: MIT
//
// Mean and variance of 4 x 4 pixels, in YCoCg: LoD 2 of a mip chain of moments in one step. The
// variance, not the second moment, is stored: halves have no bits left for their difference. Beside
// it how far the mean is off history's (cpst_change.comp).
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/frame_inputs.glsl"
#include "core/history_filters.glsl"
#include "core/neighbourhood.glsl"
#include "core/workgroup.h"
#include "equations/color_space.h"
#include "techniques/cpst/cpst_shared.h"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

layout(constant_id = 0) const uint kChange = 0u;

layout(binding = 0) uniform sampler2D color_image;
layout(binding = 1) uniform sampler2D motion_image;
layout(binding = 2) uniform sampler2D history_image;
layout(binding = 3) writeonly uniform uimage2D moments_image;  // four words of two halves
layout(binding = 4, std140) uniform Constants {
  CpstConstants k;
};

// Squares of two by two pixels to a texel.
const int kSquares = 4;
// Share of the pixels' variance that is added to that of a mean's difference. A jitter shifts all
// samples of a frame alike, by 1 / 12 px^2 on each axis, and so means by that part of a slope's
// variance over four pixels, 15 / 12.
const float kJitterShare = 1.0 / 15.0;
// A history of more samples than motion leaves it has more to lose to noise that passes for change:
// the error counts for more, by at most this. brick/still then keeps what it has without `change`,
// 29.65 dB of `paper cpst`, and has 29.3 at 1.
const float kMostCaution = 4.0;

// How far four pixels are from history, in luma, the summed weight of that, and 1; 0 where there is
// none. Each lot by the motion of one pixel: a bilinear fetch at their corner is the mean of four
// texels. Beyond the border lie the border's pixels, as fetchColor has it.
vec3 differenceFromHistory(ivec2 square_px, ivec2 last_px, float luma) {
  vec2 motion_px = motionPx(k.frame, texelFetch(motion_image, min(square_px, last_px), 0).xy);
  vec2 extent_px = k.frame.previous_extent_px;
  vec2 corner_px = min(vec2(square_px) + 1.0, k.frame.extent_px);
  vec2 previous_px = (corner_px + motion_px) * (extent_px / k.frame.extent_px);
  if (!isOnScreen(previous_px, extent_px)) return vec3(0.0);
  vec4 history =
      bilinearHistory(history_image, previous_px, k.frame.history_texel_uv, extent_px - 0.5);
  float then = yCoCgFromRgb(sanitizedColor(history.rgb * k.frame.exposure_ratio)).x;
  return vec3(luma - then, history.a, 1.0);
}

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  ivec2 first_px = texel * int(kMomentSize);
  ivec2 last_px = ivec2(k.frame.extent_px) - 1;
  if (any(greaterThan(first_px, last_px))) return;
  vec3 sum = vec3(0.0);
  vec3 sum_of_squares = vec3(0.0);
  float difference = 0.0;
  float square_of_difference = 0.0;
  float held = 0.0;
  float count = 0.0;
  for (int q = 0; q < kSquares; ++q) {
    ivec2 square_px = first_px + 2 * ivec2(q % 2, q / 2);
    float luma = 0.0;
    for (int i = 0; i < 4; ++i) {
      ivec2 px = square_px + ivec2(i % 2, i / 2);
      vec3 c = yCoCgFromRgb(fetchColor(color_image, px, last_px));
      sum += c;
      sum_of_squares += c * c;
      luma += 0.25 * c.x;
    }
    if (kChange != 0u) {
      vec3 d = differenceFromHistory(square_px, last_px, luma);
      difference += d.x;
      square_of_difference += d.x * d.x;
      held = max(held, d.y);
      count += d.z;
    }
  }
  float share = 1.0 / float(kMomentSize * kMomentSize);
  vec3 mean = sum * share;
  vec3 variance = max(sum_of_squares * share - mean * mean, vec3(0.0));
  count = max(count, 1.0);
  difference /= count;
  float spread = max(square_of_difference / count - difference * difference, 0.0);
  float error = sqrt(spread / count + kJitterShare * variance.x) + kBoundSlack * mean.x;
  error *= clamp(held / (k.held_limit + k.mean_weight), 1.0, kMostCaution);
  vec2 change = clamp(vec2(difference, error), vec2(-kMaxColor), vec2(kMaxColor));
  variance = min(variance, vec3(kMaxColor));
  imageStore(moments_image, texel,
             uvec4(packHalf2x16(mean.xy), packHalf2x16(vec2(mean.z, variance.x)),
                   packHalf2x16(variance.yz), packHalf2x16(change)));
}
