// SPDX-License-Identifier: MIT
// History for the 2 x 2 texels of a pixel, moved as one: 7 x 7 texels are read once and weighted
// four times (eq. 9).
#ifndef REPRISE_TECHNIQUES_REPRISE_HISTORY_BLOCK_GLSL
#define REPRISE_TECHNIQUES_REPRISE_HISTORY_BLOCK_GLSL

#include "core/frame_inputs.glsl"
#include "equations/filters.h"
#include "techniques/reprise/prediction.glsl"

const int kTaps = 6;
// The 2 x 2 texels' taps, an axis.
const int kReach = kTaps + 1;

// Lanczos with three lobes, mixed with linear; taps at -2 to 3 for a position `f` past texel 0.
float[kTaps] tapWeights(float f, float sharpness) {
  vec3 left = lanczosHalfWeights(f);
  vec3 right = lanczosHalfWeights(1.0 - f);
  float scale = sharpness / dot(left + right, vec3(1.0));
  left = scale * left + vec3((1.0 - sharpness) * (1.0 - f), 0.0, 0.0);
  right = scale * right + vec3((1.0 - sharpness) * f, 0.0, 0.0);
  return float[kTaps](left.z, left.y, left.x, right.x, right.y, right.z);
}

struct HistoryBlock {
  vec4 texel[4];    // rgb linear, a: samples held; (0,0) (1,0) (0,1) (1,1)
  float uncovered;  // share of taps that hold something closer too, which moved on
  float weight[4];  // 0: nothing there to be had
};

// `at`: where the corner of the pixel's first texel was, in texels. `near`: the inverse view depth
// that this surface had there, and its slope a pixel.
HistoryBlock historyBlock(sampler2D history_image, usampler2D history_depth_image,
                          RepriseConstants k, vec2 at, float near, vec2 slope, bool on_screen) {
  vec2 last_texel = 2.0 * k.previous_output_extent_px - 1.0;
  at = clamp(at, vec2(0.0), last_texel - 1.0);
  vec2 base = floor(at);
  vec2 f = at - base;

  // Depth is one a pixel of the input; the inner five texels in a row lie in three of them at most.
  // The outermost, of 3 % at most, count as their neighbours do.
  vec2 texel_px = 0.5 * k.frame.previous_extent_px / k.previous_output_extent_px;
  ivec2 first_px = ivec2(floor((base - 0.5) * texel_px));
  ivec2 count_px = ivec2(floor((base + 3.5) * texel_px)) - first_px + 1;
  ivec2 last_px = ivec2(k.frame.previous_extent_px) - 1;
  HistoryBlock block;
  block.uncovered = 0.0;
  float valid[9];
  float valid_count = 0.0;
  for (int i = 0; i < 9; ++i) {
    ivec2 at_px = clamp(first_px + ivec2(i % 3, i / 3), ivec2(0), last_px);
    uint word = texelFetch(history_depth_image, at_px, 0).x;
    vec2 depths = unpackedDepths(word);
    // The surface's plane where that pixel's depth was sampled; the pixel's centre is 1 texel from
    // `at`.
    vec2 offset_px =
        vec2(at_px) + 0.5 - (at + 1.0) * texel_px + k.frame.jitter_px - k.frame.previous_jitter_px;
    float there = near + dot(slope, offset_px);
    bool used = i % 3 < count_px.x && i / 3 < count_px.y;
    valid[i] = on_screen && used && there >= (1.0 - k.depth_tolerance) * depths.x ? 1.0 : 0.0;
    valid_count += valid[i];
    bool behind = there < (1.0 - k.depth_tolerance) * depths.y;
    block.uncovered += behind && areParting(word) ? valid[i] : 0.0;
  }
  // Lobes with taps left out would overshoot: bilinear over what is there.
  bool whole = valid_count > float(count_px.x * count_px.y) - 0.5;
  float sharpness = whole ? k.sharpness : 0.0;
  float wx[kTaps] = tapWeights(f.x, sharpness);
  float wy[kTaps] = tapWeights(f.y, sharpness);

  block.uncovered /= max(valid_count, 1.0);
  for (int j = 0; j < 4; ++j) {
    block.texel[j] = vec4(0.0);
    block.weight[j] = 0.0;
  }
  int column[kReach];
  int line[kReach];
  for (int i = 0; i < kReach; ++i) {
    float inner = float(clamp(i, 1, kReach - 2));
    ivec2 of_px = ivec2(floor((base + inner - 1.5) * texel_px)) - first_px;
    column[i] = of_px.x;
    line[i] = 3 * of_px.y;
  }
  // A row serves both texels beside each other, and both rows of texels.
  for (int y = 0; y < kReach; ++y) {
    vec4 row[2] = vec4[2](vec4(0.0), vec4(0.0));
    vec2 row_weight = vec2(0.0);
    int texel_y = int(clamp(base.y + float(y) - 2.0, 0.0, last_texel.y));
    for (int x = 0; x < kReach; ++x) {
      int texel_x = int(clamp(base.x + float(x) - 2.0, 0.0, last_texel.x));
      vec4 value = texelFetch(history_image, ivec2(texel_x, texel_y), 0);
      float v = valid[line[y] + column[x]];
      if (x < kTaps) {
        row[0] += wx[x] * v * value;
        row_weight.x += wx[x] * v;
      }
      if (x > 0) {
        row[1] += wx[x - 1] * v * value;
        row_weight.y += wx[x - 1] * v;
      }
    }
    for (int j = 0; j < 4; ++j) {
      int tap_y = y - (j >> 1);
      if (tap_y < 0 || tap_y >= kTaps) continue;
      block.texel[j] += wy[tap_y] * row[j & 1];
      block.weight[j] += wy[tap_y] * row_weight[j & 1];
    }
  }
  for (int j = 0; j < 4; ++j) {
    // Less than this is a rounding error of taps that do not count.
    block.weight[j] = block.weight[j] > 1.0e-3 ? block.weight[j] : 0.0;
    block.texel[j] = max(block.texel[j] / max(block.weight[j], 1.0e-3), vec4(0.0));
    if (block.weight[j] == 0.0) block.texel[j] = vec4(0.0);
  }
  return block;
}

#endif
