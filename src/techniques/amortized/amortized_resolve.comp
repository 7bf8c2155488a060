// SPDX-License-Identifier: MIT
//
// Amortized supersampling, one frame: writes one subpixel buffer and the pixel. Yang et al. 2009,
// section 5; numbers in brackets are the paper's equations.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/half_rounding.glsl"
#include "core/workgroup.h"
const uint kConstantsBinding = 21u;
#include "techniques/amortized/reproject.glsl"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

// 1: residuals are kept and bound alpha (26, 27).
layout(constant_id = 3) const uint kResiduals = 0u;

layout(binding = 10) uniform sampler2D color_image;
layout(binding = 11) uniform sampler2D extra_image;  // rgb: sum of served requests, a: their number
layout(binding = 12) uniform sampler2D count_image;  // N of the previous frame
layout(binding = 13) uniform sampler2D residual_image;  // of the last four updates, signed roots
layout(binding = 14) uniform sampler2D smoothed_residual_image;
layout(binding = 22) uniform sampler2D newest_image;  // the buffer that the previous frame wrote
layout(binding = 15) writeonly uniform image2D next_buffer_image;
layout(binding = 16) writeonly uniform image2D next_count_image;
layout(binding = 17) writeonly uniform image2D next_motion_image_0;
layout(binding = 18) writeonly uniform image2D next_motion_image_1;
layout(binding = 19) writeonly uniform image2D next_residual_image;
layout(binding = 20) writeonly uniform image2D output_image;

// A pixel's tent averages 16 texels like 10.24 equal ones (the inverse sum of its squared weights
// at rest), where N counts four: what a single sample weighs beside N.
const float kTexelsAverage = 10.24 / 4.0;
// Of a blurred pixel: one a pixel of motion, so that the tents overlap; longer motion is sampled
// more sparsely.
const int kMostShutterTaps = 16;

// What a footprint of a buffer holds.
struct Texels {
  vec3 colors[4];
  vec4 depths;
};

Texels texelsOf(uint b, Footprint f) {
  Texels texels;
  for (int i = 0; i < 4; ++i) {
    vec4 texel = texelIn(b, texelOf(ivec2(f.base), i));
    texels.colors[i] = texel.rgb;
    texels.depths[i] = texel.a;
  }
  return texels;
}

vec3 weighted(Texels texels, vec4 w) {
  return w.x * texels.colors[0] + w.y * texels.colors[1] + w.z * texels.colors[2] +
         w.w * texels.colors[3];
}

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

// Residuals lie in 8 bits: the square root keeps small ones apart.
vec4 packedResiduals(vec4 residuals) {
  return sign(residuals) * sqrt(min(abs(residuals), vec4(1.0)));
}
vec4 unpackedResiduals(vec4 stored) {
  return sign(stored) * stored * stored;
}

void main() {
  ivec2 px = ivec2(gl_GlobalInvocationID.xy);
  ivec2 extent_px = ivec2(k.frame.extent_px);
  if (any(greaterThanEqual(px, extent_px))) return;

  vec3 current = fetchColor(color_image, px, extent_px - 1);
  Surface s = surfaceAt(px);
  Way ways[4];
  vec4 chained[2];
  waysToBuffers(s, ways, chained);

  // (16) for the buffer to be written and (20) for the pixel, of the same texels: a buffer's tent
  // reaches half a pixel from a quadrant, and so no farther than the pixel's own.
  vec3 target_sum = vec3(0.0);
  float target_weight = 0.0;
  vec3 pixel_sum = vec3(0.0);
  float pixel_weight = 0.0;
  for (uint b = 0u; b < kSlots; ++b) {
    SlotState state = k.slots[b];
    Footprint f = footprintIn(state, state.place_age.xy, s, ways[b].motion_px, vec2(0.0));
    if (!f.readable) continue;
    Texels texels = texelsOf(b, f);
    vec4 valid = validTexels(texels.depths, f, state, s, ways[b]);
    vec2 target = f.point + f.column_x * k.target_px.x + f.column_y * k.target_px.y;
    vec4 w = tentWeights(target.x, target.y, k.target_px.z * f.growth) * valid;
    target_sum += state.exposure_ratio * weighted(texels, w);
    target_weight += sumOf(w);
    w = tentWeights(f.point.x, f.point.y, kPixelTentRadius_px * f.growth) * valid;
    pixel_sum += state.exposure_ratio * weighted(texels, w);
    pixel_weight += sumOf(w);
  }
  // What passes the pixel while the shutter is open, about the instant of the frame.
  float open_px = k.shutter * length(s.motion_px);
  int taps = clamp(int(ceil(open_px)), 1, kMostShutterTaps);
  if (taps > 1) {
    pixel_sum = vec3(0.0);
    pixel_weight = 0.0;
  }
  for (int tap = 0; taps > 1 && tap < taps; ++tap) {
    float instant = (float(tap) + 0.5) / float(taps) - 0.5;
    vec2 offset_px = instant * k.shutter * s.motion_px;
    for (uint b = 0u; b < kSlots; ++b) {
      SlotState state = k.slots[b];
      Footprint f = footprintIn(state, state.place_age.xy, s, ways[b].motion_px, offset_px);
      if (!f.readable) continue;
      Texels texels = texelsOf(b, f);
      vec4 w = tentWeights(f.point.x, f.point.y, kPixelTentRadius_px * f.growth) *
               validTexels(texels.depths, f, state, s, ways[b]);
      pixel_sum += state.exposure_ratio * weighted(texels, w);
      pixel_weight += sumOf(w);
    }
  }
  bool seen_before = pixel_weight > 1.0e-4;

  // Served requests (section 5.3), an evaluation at each of some quadrants.
  vec4 extra = k.extra_given > 0.5 ? texelFetch(extra_image, px, 0) : vec4(0.0);
  extra.rgb = sanitizedColor(extra.rgb);
  // A buffer that finds nothing under its tent begins with all that this frame has, and they count
  // in N: spread over the pixel, they blur no more than tau_b lets a moving estimate.
  bool begins = target_weight <= 1.0e-4;
  float begun = begins ? extra.a : 0.0;

  // Weight of the new sample (26): in the pixel, beta; in its buffer, alpha.
  Previous previous = previousOf(newest_image, s, ways);
  float count = seen_before ? samplesBefore(count_image, previous) : 0.0;
  float bound = 0.0;
  if (seen_before) bound = blurBound(s.motion_px);
  float change_bound = 0.0;
  vec4 residuals = vec4(0.0);
  if (kResiduals != 0u && seen_before) {
    float smoothed = 0.0;
    for (int i = 0; i < 4; ++i) {
      ivec2 texel = texelOf(previous.base, i);
      residuals += previous.shares[i] * unpackedResiduals(texelFetch(residual_image, texel, 0));
      smoothed += previous.shares[i] * texelFetch(smoothed_residual_image, texel, 0).x;
    }
    change_bound = residualBound(smoothed, k.residual_tolerance);
  }
  // The table holds the weight in the buffer, K times the paper's; (27) is that in the pixel.
  bound = max(bound, min(k.buffer_count * change_bound, 1.0));
  float beta = max(1.0 / (count + begun + 1.0), max(bound / k.buffer_count, change_bound));
  // On a view at rest beta says 1/t; the buffer's own mean over its n writes is exact with 1/n.
  float alpha = clamp(max(1.0 / (writesAmong(count) + 1.0), bound), 0.0, 1.0);
  if (k.fixed_alpha > 0.0) {
    alpha = k.fixed_alpha;
    beta = alpha / k.buffer_count;
  }
  if (!seen_before) {
    alpha = 1.0;
    beta = 1.0;
  }

  // (12)
  vec3 estimate = (current + begun / max(extra.a, 1.0) * extra.rgb) / (1.0 + begun);
  float residual = 0.0;
  if (!begins) {
    vec3 reconstructed = target_sum / target_weight;
    residual = luminance(current) - luminance(reconstructed);
    estimate = mix(reconstructed, current, alpha);
  }

  // (20), with served requests in the place of buffers whose reprojection failed. The new sample
  // stands for one instant of those that the shutter sees; where nothing else is known, it is one
  // among the served ones.
  float share = alpha / (k.buffer_count * float(taps));
  if (extra.a > 0.0) {
    // Asked for to hold a quality, one is a sample beside those that the buffers hold.
    float each = 1.0;
    if (k.quality > 0.0 && seen_before) {
      each = min(pixel_weight / (kTexelsAverage * max(count, 1.0)), 1.0);
    }
    pixel_sum += each * extra.rgb;
    pixel_weight += each * extra.a;
    if (!seen_before) share = 1.0 / (1.0 + extra.a);
  }
  vec3 pixel = current;
  if (pixel_weight > 1.0e-4) pixel = mix(pixel_sum / pixel_weight, current, share);

  vec3 stored = roundedToHalf(estimate, px, k.frame.frame_number, true);
  // 0 says "never written": the nearest surface is a little in front of the eye.
  float stored_depth = clamp(depthAt(px, extent_px - 1), 1.0e-6, kFarthestHalf);
  imageStore(next_buffer_image, px, vec4(stored, stored_depth));
  float next_count = 1.0 + begun;
  if (seen_before) next_count = min(varianceReduction(count + begun, beta), k.max_samples);
  imageStore(next_count_image, px, vec4(next_count));
  if (kExactMotion == 0u) {
    imageStore(next_motion_image_0, px, chained[0]);
    if (kSlots > 2u) imageStore(next_motion_image_1, px, chained[1]);
  }
  if (kResiduals != 0u) {
    imageStore(next_residual_image, px, packedResiduals(vec4(residual, residuals.xyz)));
  }
  imageStore(output_image, px, vec4(pixel, 1.0));
}
