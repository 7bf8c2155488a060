// SPDX-License-Identifier: MIT
//
// Moves history of 2 x 2 texels a pixel to this frame, follows what evidence says has changed,
// bounds it, and blends the new sample in. Equation numbers refer to README.md of this folder.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/frame_inputs.glsl"
#include "core/half_rounding.glsl"
#include "core/neighbourhood.glsl"
#include "core/workgroup.h"
#include "equations/evidence.h"
#include "techniques/reprise/history_block.glsl"
#include "techniques/reprise/prediction.glsl"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

layout(binding = 0) uniform sampler2D color_image;
layout(binding = 1) uniform sampler2D motion_image;
layout(binding = 2) uniform sampler2D reactive_image;
layout(binding = 3) uniform sampler2D predicted_image;
layout(binding = 4) uniform sampler2D depth_image;
layout(binding = 5) uniform sampler2D history_image;  // rgb linear, a: samples held
layout(binding = 6) uniform usampler2D history_depth_image;
layout(binding = 7) uniform sampler2D
    change_image;  // of residuals, x: mean, y: the last, z: noise, w: flips
layout(binding = 8) uniform sampler2D gain_image;  // one texel a tile
layout(binding = 9) writeonly uniform image2D next_history_image;
layout(binding = 10) writeonly uniform image2D next_change_image;
layout(binding = 11) writeonly uniform image2D output_image;
layout(binding = 12, std140) uniform Constants {
  RepriseConstants k;
};

// Weight of a frame's residual in the running mean, unless evidence of the frame alone raises it.
const float kChangeMemory = 0.3;
// Residuals of 3x3 that count as independent: an edge's aliasing errs alike along a row.
const float kChangeCount = 3.0;

// Residuals beyond this are followed no further: what is left of history says nothing.
const float kMostChange = 0.8;

// Weight of a new squared difference of residuals from frame to frame in its mean, the noise.
const float kNoiseMemory = 0.5;
// The least noise, as a share of what the residuals' scatter over 3x3 says.
const float kSpatialShare = 0.3;

// Standard deviation over mean luma of 3x3 up to which content is faint, and history bounded
// loosely (eq. 10).
const float kFaint = 0.05;
// Motions of neighbours that differ by this much belong to surfaces that move apart (px a frame).
const float kApart_px = 2.0;

// At rest what a silhouette left counts for this share of what it counts for in motion: else it
// stays as long as history does there. Bars of 10 px over a sky at rest have 32.1 dB at 0.5, 33.3
// at 0.25 (AGapMovesWithItsBars), `hangar/fly` 0.03 less of tPSNR.
const float kUncoveredAtRest = 0.25;

// What a frame adds to the samples held by the four texels of a pixel, together.
const float kFrameWeight = 2.0;
// A texel far from the sample still learns a little: 0 / 0 otherwise.
const float kSmallestWeight = 1.0e-3;

// Output pixels without a sample of their own borrow the closest one, at this share of a sample's
// weight (0.4 dB against 1 on `brick/still` at twice the extent, 0.2 on `brick/pan`), which falls
// with its distance from the pixel (output px).
const float kLentShare = 0.3;
const float kLentWidth = 0.5;
// Squared: less than this is a rounding error of samples on the pixel's edge.
const float kSmallestOutside = 1.0e-6;

// `flips`: the bound's half-size is at least as many of a pixel's flips, the least of two residuals
// in a row of different signs: where content aliases to one colour, 3x3 of a frame have no spread
// (5 dB on `chart/still`). Changes do not flip. At rest a quarter of it is enough.
const float kFlipsAtRest = 0.25;
// Flips' upper fifth, which steps toward each frame's flip: what passes by flips once or twice too,
// and one great flip must count no more than a small one.
const float kFlipRise = 0.05;
const float kFlipFall = 0.0125;

// 1: neighbours' motion is so different from the pixel's that what they mixed is no more (eq. 10).
float movingApart(ivec2 px, vec2 motion_px, ivec2 last_px) {
  float square = 0.0;
  for (int i = 1; i < 5; ++i) {
    ivec2 at_px = clamp(px + kCross[i], ivec2(0), last_px);
    vec2 apart_px = motionPx(k.frame, texelFetch(motion_image, at_px, 0).xy) - motion_px;
    square = max(square, dot(apart_px, apart_px));
  }
  return smoothstep(0.5 * kApart_px, kApart_px, sqrt(square));
}

// Residuals of 3x3 about the prediction after `gain`, relative to the larger of both lumas (eq. 7).
struct Pooled {
  float mean;
  float variance;
  float luma;
  float count;
};

// Of the sample for the four texels of the output's pixel (eq. 11); `offset_px` from its centre.
vec4 texelWeights(vec2 offset_px, float held) {
  vec2 low = offset_px + 0.25;
  vec2 high = offset_px - 0.25;
  float scale = -0.5 / (k.sample_width * k.sample_width);
  vec2 a = exp(scale * low * low);
  vec2 b = exp(scale * high * high);
  vec4 weight = max(vec4(a.x * a.y, b.x * a.y, a.x * b.y, b.x * b.y), vec4(kSmallestWeight));
  // A sample outside the pixel is another pixel's: it fills in until the pixel has its own.
  vec2 outside = max(abs(offset_px) - 0.5, vec2(0.0));
  float square = dot(outside, outside);
  float share = exp(-0.5 * square / (kLentWidth * kLentWidth));
  if (square > kSmallestOutside) share *= kLentShare / (1.0 + held);
  return weight * (kFrameWeight * share / dot(weight, vec4(1.0)));
}

// The frame alone at `nearest_px` from its sample 4 (input px): a Gaussian, drawn out along edges.
// Widths, Sobel's gradient and the ramp are smoothedAlongEdge's; unlike there a pixel without an
// edge is interpolated too, since its own sample may lie at its rim, or in another pixel.
vec3 smoothedAt(vec3 s[9], vec2 nearest_px) {
  vec2 gradient = vec2((s[2].x + 2.0 * s[5].x + s[8].x) - (s[0].x + 2.0 * s[3].x + s[6].x),
                       (s[6].x + 2.0 * s[7].x + s[8].x) - (s[0].x + 2.0 * s[1].x + s[2].x));
  float steepness = length(gradient);
  vec2 across = gradient / max(steepness, 1.0e-6);
  float edge = clamp((steepness * 0.25 - 0.0625) * 16.0, 0.0, 1.0);
  const float kAcross = 0.11;
  float along = mix(kAcross, 1.0, edge);
  vec3 sum = vec3(0.0);
  float weight_sum = 0.0;
  for (int i = 0; i < 9; ++i) {
    vec2 offset_px = nearest_px + vec2(float(i % 3) - 1.0, float(i / 3) - 1.0);
    float a = dot(offset_px, across);
    float weight = exp(-0.5 * (a * a / kAcross + (dot(offset_px, offset_px) - a * a) / along));
    sum += weight * s[i];
    weight_sum += weight;
  }
  return sum / weight_sum;
}

void main() {
  ivec2 output_px = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(output_px, ivec2(k.output_extent_px)))) return;

  // The input's pixel whose sample is the closest to the output's pixel.
  ivec2 last_px = ivec2(k.frame.extent_px) - 1;
  vec2 ratio = k.output_extent_px / k.frame.extent_px;
  vec2 center_px = (vec2(output_px) + 0.5) / ratio;
  ivec2 px = clamp(ivec2(floor(center_px + k.frame.jitter_px)), ivec2(0), last_px);
  vec2 sample_px = (vec2(px) + 0.5 - k.frame.jitter_px) * ratio - vec2(output_px) - 0.5;
  vec3 gain = textureLod(gain_image, min(center_px * k.tile_uv, k.last_tile_uv), 0.0).rgb;
  vec3 samples[9];
  Pooled pooled = Pooled(0.0, 0.0, 0.0, 0.0);
  vec4 predicted = vec4(0.0);
  vec3 current = vec3(0.0);
  for (int i = 0; i < 9; ++i) {
    ivec2 at_px = clamp(px + ivec2(i % 3 - 1, i / 3 - 1), ivec2(0), last_px);
    vec3 texel = texelFetch(color_image, at_px, 0).rgb;
    vec4 told = texelFetch(predicted_image, at_px, 0);
    told.rgb *= gain;
    float w = isPredicted(told);
    // What is no number is what was foretold: black would be held against history for many frames.
    vec3 color = w > 0.0 && !isFinite(texel) ? told.rgb : sanitizedColor(texel);
    samples[i] = yCoCgFromRgb(color);
    float foretold = lumaYCoCg(told.rgb);
    float residual = w * (samples[i].x - foretold);
    pooled.mean += residual;
    pooled.variance += residual * residual;
    pooled.luma += w * foretold;
    pooled.count += w;
    if (i == 4) {
      predicted = told;
      current = color;
    }
  }
  float per = 1.0 / max(pooled.count, 1.0);
  float scale = per / (max(pooled.luma, pooled.luma + pooled.mean) * per + kDarkest);
  pooled.mean *= scale;
  pooled.variance = max(pooled.variance * scale * scale / per - pooled.mean * pooled.mean, 0.0);

  ivec2 surface_px = clamp(px + kCross[surfaceIndex(predicted)], ivec2(0), last_px);
  vec2 motion_px = motionPx(k.frame, texelFetch(motion_image, surface_px, 0).xy);
  vec2 then_scale = k.previous_output_extent_px / k.frame.extent_px;
  vec2 previous_px = (center_px + motion_px) * then_scale;
  vec2 inside_px = clamp(previous_px, vec2(0.5), k.previous_output_extent_px - 0.5);
  bool on_screen =
      k.frame.has_history > 0.5 && isOnScreen(previous_px, k.previous_output_extent_px);
  bool still = !isMoving(predicted);

  // Evidence of this frame alone, then of the running mean (eq. 8).
  vec4 then = textureLod(change_image, inside_px * k.output_texel_uv, 0.0);
  float known = on_screen && pooled.count > 0.5 ? 1.0 : 0.0;
  float square = pooled.mean * pooled.mean;
  float spatial = (pooled.variance + kSmallestSquare) / kChangeCount;
  float noise = then.z > 0.0 ? max(then.z, kSpatialShare * spatial) : max(spatial, square);
  float patience = still ? kPatience : 1.0;
  float now = known * believedShare(square, noise, k.doubt_now * patience);
  float weight = max(kChangeMemory, now);
  float change = known * mix(then.x, pooled.mean, weight);
  float believed = known * believedShare(change * change, noise * exponentialMeanVariance(weight),
                                         k.doubt_mean * patience);
  float step = pooled.mean - then.y;
  float next_noise = mix(noise, 0.5 * step * step, kNoiseMemory);
  float flip = pooled.mean * then.y < 0.0 ? min(abs(pooled.mean), abs(then.y)) : 0.0;
  float flips = (1.0 - max(believed, now)) * (then.w + clamp(flip - then.w, -kFlipFall, kFlipRise));
  imageStore(next_change_image, output_px,
             known * vec4(change * (1.0 - believed), pooled.mean, next_noise, flips));
  float changed = max(believed, now);
  float brighter = clamp(believed * change, -kMostChange, kMostChange);
  gain *= brighter < 0.0 ? 1.0 + brighter : 1.0 / (1.0 - brighter);

  // The surface as a plane: how near it was at the pixel, and how that changes over pixels.
  float near = nearness(k.frame, depth_image, surface_px, last_px);
  float left = nearness(k.frame, depth_image, surface_px - ivec2(1, 0), last_px);
  float right = nearness(k.frame, depth_image, surface_px + ivec2(1, 0), last_px);
  float above = nearness(k.frame, depth_image, surface_px - ivec2(0, 1), last_px);
  float below = nearness(k.frame, depth_image, surface_px + ivec2(0, 1), last_px);
  vec2 slope = vec2(slopeOf(right - near, near - left), slopeOf(below - near, near - above));
  float expected = expectedPreviousDepth(k.frame.previous_depth_coefficients,
                                         center_px - k.frame.jitter_px, 1.0 / near);
  HistoryBlock block =
      historyBlock(history_image, history_depth_image, k, 2.0 * (previous_px - 0.5),
                   1.0 / clamp(expected, 1.0e-9, kMaxViewDepth), slope, on_screen);

  float reactive = 0.0;
  if (k.frame.reactive_given > 0.5) {
    reactive = clamp(texelFetch(reactive_image, px, 0).x, 0.0, 1.0);
  }
  Moments m = moments(samples);
  float half_size = mix(still ? k.bound_still : k.bound, k.bound_changed, changed);
  if (!still) {
    float relative = m.deviation.x / ((m.mean.x + kDarkest) * kFaint);
    float faint = 1.0 / (1.0 + relative * relative * relative * relative);
    half_size = mix(half_size, mix(k.bound_faint, k.bound_changed, changed), faint);
    half_size = mix(half_size, k.bound_apart, movingApart(px, motion_px, last_px));
  }
  float flipping = k.flips * (still ? kFlipsAtRest * then.w : max(0.0, then.w - k.chance_flips));
  flipping *= (1.0 - changed) * known;
  flipping *= pooled.luma * per + kDarkest;
  float limit = still ? k.still_history : k.history;
  float behind = k.history_uncovered * (still ? kUncoveredAtRest : 1.0);
  if (block.uncovered > 0.0) limit = min(limit, behind / block.uncovered);
  // Where little is held the frame is antialiased by itself. A loop, not a branch: CPU drivers run
  // both sides of a branch for every pixel.
  float held = 0.25 * (block.texel[0].a + block.texel[1].a + block.texel[2].a + block.texel[3].a);
  float alone = clamp(1.0 - held / k.alone_samples, 0.0, 1.0);
  for (int fresh = alone > 0.0 ? 0 : 1; fresh < 1; ++fresh) {
    vec3 smoothed = rgbFromYCoCg(smoothedAt(samples, sample_px / ratio));
    current = mix(current, max(smoothed, vec3(0.0)), alone);
  }
  // Bright samples weigh less, as if they were seen (Karis 2014): one small highlight would else be
  // most of a mean of few samples, and flicker. At rest the mean is to be that of light.
  float tone = still ? 0.0 : k.tone;
  float brightness = 1.0 + tone * lumaYCoCg(current);
  vec4 texel_weight = texelWeights(sample_px, held);
  vec3 shown = vec3(0.0);
  for (int j = 0; j < 4; ++j) {
    vec3 followed = block.texel[j].rgb * (gain * k.frame.exposure_ratio);
    vec3 history = yCoCgFromRgb(min(followed, vec3(kMaxColor)));
    vec3 reach = half_size * max(m.deviation, vec3(flipping)) + boundSlack(history, samples[4]);
    vec3 bounded = clipTowardBoxCentre(m.mean - reach, m.mean + reach, history);
    float clipped = length(bounded - history) / (length(history - samples[4]) + 1.0e-4);

    // Samples held, and the new one's weight (eq. 11).
    float count = min(block.texel[j].a, limit) * (1.0 - reactive);
    count *= 1.0 - k.forget_clipped * clamp(clipped, 0.0, 1.0);
    count *= 1.0 - k.forget_changed * believed;
    float w = texel_weight[j];
    float toned = texel_weight[j] * (1.0 + tone * max(bounded.x, 0.0)) / brightness;
    vec3 value = mix(max(rgbFromYCoCg(bounded), vec3(0.0)), current, toned / (count + toned));
    shown += 0.25 * value;
    ivec2 texel = 2 * output_px + ivec2(j & 1, j >> 1);
    vec3 stored = roundedToHalf(min(value, vec3(kMaxColor)), texel, k.frame.frame_number, true);
    imageStore(next_history_image, texel, vec4(stored, min(count + w, 2048.0)));
  }
  imageStore(output_image, output_px, vec4(shown, 1.0));
}
