// SPDX-License-Identifier: MIT
// Reading history between texels. `px` is a position in pixels (centres at + 0.5), `last_px` the
// last texel's centre; what a kernel overshoots below 0 is cut.
#ifndef REPRISE_CORE_HISTORY_FILTERS_GLSL
#define REPRISE_CORE_HISTORY_FILTERS_GLSL

#include "equations/filters.h"
#include "equations/reprojection.h"

vec4 bilinearHistory(sampler2D image, vec2 px, vec2 texel_uv, vec2 last_px) {
  return textureLod(image, clamp(px, vec2(0.5), last_px) * texel_uv, 0.0);
}

// Bicubic with the two inner columns (and rows) merged into one bilinear fetch. Five fetches drop
// the corners and renormalize: at most 1/64 of the weight.
vec4 cubicHistory(sampler2D image, vec2 px, vec2 texel_uv, vec2 last_px, float sharpness,
                  bool corners) {
  vec2 base_px = floor(px - 0.5) + 0.5;
  vec2 f = px - base_px;
  vec4 wx = cubicWeights(f.x, sharpness);
  vec4 wy = cubicWeights(f.y, sharpness);
  vec2 inner = vec2(wx.y + wx.z, wy.y + wy.z);
  vec2 low_px = base_px - 1.0;
  vec2 inner_px = base_px + vec2(wx.z, wy.z) / inner;
  vec2 high_px = base_px + 2.0;
  vec4 sum = bilinearHistory(image, inner_px, texel_uv, last_px) * (inner.x * inner.y);
  sum += bilinearHistory(image, vec2(low_px.x, inner_px.y), texel_uv, last_px) * (wx.x * inner.y);
  sum += bilinearHistory(image, vec2(high_px.x, inner_px.y), texel_uv, last_px) * (wx.w * inner.y);
  sum += bilinearHistory(image, vec2(inner_px.x, low_px.y), texel_uv, last_px) * (inner.x * wy.x);
  sum += bilinearHistory(image, vec2(inner_px.x, high_px.y), texel_uv, last_px) * (inner.x * wy.w);
  if (corners) {
    sum += bilinearHistory(image, low_px, texel_uv, last_px) * (wx.x * wy.x);
    sum += bilinearHistory(image, vec2(high_px.x, low_px.y), texel_uv, last_px) * (wx.w * wy.x);
    sum += bilinearHistory(image, vec2(low_px.x, high_px.y), texel_uv, last_px) * (wx.x * wy.w);
    sum += bilinearHistory(image, high_px, texel_uv, last_px) * (wx.w * wy.w);
    return max(sum, vec4(0.0));
  }
  float weight = inner.x * inner.y + (wx.x + wx.w) * inner.y + inner.x * (wy.x + wy.w);
  return max(sum / weight, vec4(0.0));
}

// The four texels around `px`: (0,0) (1,0) (0,1) (1,1).
vec4[4] innerTexels(sampler2D image, vec2 px, vec2 last_px) {
  vec2 base_px = floor(px - 0.5);
  ivec2 lo = ivec2(clamp(base_px, vec2(0.0), last_px - 0.5));
  ivec2 hi = ivec2(clamp(base_px + 1.0, vec2(0.0), last_px - 0.5));
  return vec4[4](texelFetch(image, lo, 0), texelFetch(image, ivec2(hi.x, lo.y), 0),
                 texelFetch(image, ivec2(lo.x, hi.y), 0), texelFetch(image, hi, 0));
}

// cubicHistory of 5 fetches, the middle one made of the inner texels.
vec4 cubicAroundInner(vec4 inner[4], sampler2D image, vec2 px, vec2 texel_uv, vec2 last_px,
                      float sharpness) {
  vec2 base_px = floor(px - 0.5) + 0.5;
  vec2 f = px - base_px;
  vec4 wx = cubicWeights(f.x, sharpness);
  vec4 wy = cubicWeights(f.y, sharpness);
  vec2 middle = vec2(wx.y + wx.z, wy.y + wy.z);
  vec2 middle_px = base_px + vec2(wx.z, wy.z) / middle;
  vec4 sum =
      wy.y * (wx.y * inner[0] + wx.z * inner[1]) + wy.z * (wx.y * inner[2] + wx.z * inner[3]);
  sum += bilinearHistory(image, vec2(base_px.x - 1.0, middle_px.y), texel_uv, last_px) *
         (wx.x * middle.y);
  sum += bilinearHistory(image, vec2(base_px.x + 2.0, middle_px.y), texel_uv, last_px) *
         (wx.w * middle.y);
  sum += bilinearHistory(image, vec2(middle_px.x, base_px.y - 1.0), texel_uv, last_px) *
         (middle.x * wy.x);
  sum += bilinearHistory(image, vec2(middle_px.x, base_px.y + 2.0), texel_uv, last_px) *
         (middle.x * wy.w);
  float weight = middle.x * middle.y + (wx.x + wx.w) * middle.y + middle.x * (wy.x + wy.w);
  return max(sum / weight, vec4(0.0));
}

// Where history steps (a lamp, an edge) the cubic's negative lobes fall below and rise above all of
// it, and what is fed back keeps that as a fringe: no farther than the four texels around.
vec4 withinInner(vec4 history, vec4 inner[4]) {
  return clamp(history, min(min(inner[0], inner[1]), min(inner[2], inner[3])),
               max(max(inner[0], inner[1]), max(inner[2], inner[3])));
}

// Bilinear over the inner texels whose `valid` is 1.
vec4 validOfInner(vec4 inner[4], vec2 px, vec4 valid) {
  vec2 f = px - 0.5 - floor(px - 0.5);
  vec4 w = validTapWeights(f.x, f.y, valid);
  return w.x * inner[0] + w.y * inner[1] + w.z * inner[2] + w.w * inner[3];
}

vec4 lanczosHistory(sampler2D image, vec2 px, vec2 last_px) {
  vec2 base_px = floor(px - 0.5);
  vec2 f = px - 0.5 - base_px;
  vec4 sum = vec4(0.0);
  float weight_sum = 0.0;
  for (int y = -1; y <= 2; ++y) {
    float wy = lanczosFilter(float(y) - f.y, 2.0);
    for (int x = -1; x <= 2; ++x) {
      float w = lanczosFilter(float(x) - f.x, 2.0) * wy;
      ivec2 texel = ivec2(clamp(base_px + vec2(x, y), vec2(0.0), last_px - 0.5));
      sum += w * texelFetch(image, texel, 0);
      weight_sum += w;
    }
  }
  return max(sum / weight_sum, vec4(0.0));
}

// The same, fetched here.
vec4 validHistory(sampler2D image, vec2 px, vec2 last_px, vec4 valid) {
  return validOfInner(innerTexels(image, px, last_px), px, valid);
}

#endif
