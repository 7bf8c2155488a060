// SPDX-License-Identifier: MIT
//
// The new sample joins what was gathered: the buffer to be written, the pixel, N.
#ifndef REPRISE_AMORTIZED_BLEND_GLSL
#define REPRISE_AMORTIZED_BLEND_GLSL

#include "core/half_rounding.glsl"
#include "equations/amortized.h"
#include "techniques/amortized/gathered.glsl"

// A pixel's tent averages 16 texels like 10.24 equal ones (the inverse sum of its squared weights
// at rest), where N counts four: what a single sample weighs beside N.
const float kTexelsAverage = 10.24 / 4.0;

struct Blended {
  vec3 estimate;  // rounded to half
  vec3 pixel;
  float count;
  float residual;
};

float blurByte(ivec2 cell) {
  int index = cell.y * 64 + cell.x;
  uvec4 words = k.blur_slice[index >> 4];
  uint word = words[(index >> 2) & 3];
  return float((word >> (8 * (index & 3))) & 255u) * (1.0 / 255.0);
}

// alpha_tau_b at the fractional velocity, bilinear in the table.
float blurBound(vec2 motion_px) {
  vec2 at = fract(motion_px) * 63.0;
  ivec2 cell = min(ivec2(at), ivec2(62));
  vec2 f = at - vec2(cell);
  float low = mix(blurByte(cell), blurByte(cell + ivec2(1, 0)), f.x);
  float high = mix(blurByte(cell + ivec2(0, 1)), blurByte(cell + ivec2(1, 1)), f.x);
  return mix(low, high, f.y);
}

float storedWrites(int frames) {
  return k.writes[frames >> 2][frames & 3];
}

// How often the buffer to be written was written in the last `count` frames; between whole numbers
// linear.
float writesAmong(float count) {
  float periods = floor(count * (1.0 / 32.0));
  float rest = count - 32.0 * periods;
  int low = int(rest);
  float below = storedWrites(low);
  float above = low < 31 ? storedWrites(low + 1) : k.writes_a_period;
  return periods * k.writes_a_period + mix(below, above, rest - float(low));
}

float luminance(vec3 color) {
  return dot(color, vec3(0.2126, 0.7152, 0.0722));
}

// `extra`: served requests (section 5.3), the sum of evaluations at some quadrants, and their
// number.
Blended blended(Gathered g, vec3 current, vec4 extra, vec2 motion_px, float change_bound,
                ivec2 px) {
  bool seen_before = g.pixel_weight > kLeastWeight;
  // A buffer that finds nothing under its tent begins with all that this frame has, and they count
  // in N: spread over the pixel, they blur no more than tau_b lets a moving estimate.
  float begun = g.begins ? extra.a : 0.0;

  // Weight of the new sample (26): in the pixel, beta; in its buffer, alpha. The table holds the
  // weight in the buffer, K times the paper's; (27) is that in the pixel.
  float bound = max(blurBound(motion_px), min(k.buffer_count * change_bound, 1.0));
  float beta = max(1.0 / (g.count + begun + 1.0), max(bound / k.buffer_count, change_bound));
  // On a view at rest beta says 1/t; the buffer's own mean over its n writes is exact with 1/n.
  float alpha = clamp(max(1.0 / (writesAmong(g.count) + 1.0), bound), 0.0, 1.0);
  if (k.fixed_alpha > 0.0) {
    alpha = k.fixed_alpha;
    beta = alpha / k.buffer_count;
  }
  if (!seen_before) {
    alpha = 1.0;
    beta = 1.0;
  }

  Blended result;
  // (12)
  vec3 estimate = (current + begun / max(extra.a, 1.0) * extra.rgb) / (1.0 + begun);
  result.residual = 0.0;
  if (!g.begins) {
    result.residual = luminance(current) - luminance(g.target);
    estimate = mix(g.target, current, alpha);
  }
  result.estimate = roundedToHalf(estimate, px, k.frame.frame_number, true);

  // (20), with served requests in the place of buffers whose reprojection failed. The new sample
  // stands for one instant of those that the shutter sees; where nothing else is known, it is one
  // among the served ones.
  int taps = kShutter != 0u ? shutterTaps(motion_px) : 1;
  float share = alpha / (k.buffer_count * float(taps));
  vec3 pixel_sum = g.pixel_weight * g.pixel;
  float pixel_weight = g.pixel_weight;
  if (extra.a > 0.0) {
    // Asked for to hold a quality, one is a sample beside those that the buffers hold.
    float each = 1.0;
    if (k.quality > 0.0 && seen_before) {
      each = min(pixel_weight / (kTexelsAverage * max(g.count, 1.0)), 1.0);
    }
    pixel_sum += each * extra.rgb;
    pixel_weight += each * extra.a;
    if (!seen_before) share = 1.0 / (1.0 + extra.a);
  }
  result.pixel = current;
  if (pixel_weight > kLeastWeight) result.pixel = mix(pixel_sum / pixel_weight, current, share);

  result.count = 1.0 + begun;
  if (seen_before) result.count = min(varianceReduction(g.count + begun, beta), k.max_samples);
  return result;
}

vec4 servedRequests(sampler2D extra_image, ivec2 px) {
  vec4 extra = k.extra_given > 0.5 ? texelFetch(extra_image, px, 0) : vec4(0.0);
  return vec4(sanitizedColor(extra.rgb), extra.a);
}

#endif
