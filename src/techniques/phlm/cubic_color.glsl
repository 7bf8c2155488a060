// SPDX-License-Identifier: MIT
// Catmull-Rom on texels, for forms of storage that no sampler filters: the including shader gives
// colorTexel(px). Same weights as cubicHistory's without corners.
#ifndef REPRISE_TECHNIQUES_PHLM_CUBIC_COLOR_GLSL
#define REPRISE_TECHNIQUES_PHLM_CUBIC_COLOR_GLSL

vec4 cubicColor(vec2 px, vec2 last_center_px) {
  vec2 base_px = floor(px - 0.5);
  vec4 wx = cubicWeights(px.x - 0.5 - base_px.x, 0.5);
  vec4 wy = cubicWeights(px.y - 0.5 - base_px.y, 0.5);
  vec4 sum = vec4(0.0);
  float weight_sum = 0.0;
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) {
      bool corner = (x == 0 || x == 3) && (y == 0 || y == 3);
      float weight = wx[x] * wy[y];
      if (corner || weight == 0.0) continue;
      vec2 at_px = clamp(base_px + vec2(x - 1, y - 1), vec2(0.0), last_center_px - 0.5);
      sum += weight * colorTexel(ivec2(at_px));
      weight_sum += weight;
    }
  }
  return max(sum / weight_sum, vec4(0.0));
}

#endif
