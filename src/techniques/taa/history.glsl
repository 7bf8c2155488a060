// SPDX-License-Identifier: MIT
// Reading history between texels: rgb linear colour, a the number of samples it holds.
#ifndef REPRISE_TECHNIQUES_TAA_HISTORY_GLSL
#define REPRISE_TECHNIQUES_TAA_HISTORY_GLSL

#include "core/history_filters.glsl"

vec4 filteredHistory(sampler2D image, vec2 px, vec2 texel_uv, vec2 last_px, float sharpness) {
  if (kHistoryFilter == kHistoryBilinear) return bilinearHistory(image, px, texel_uv, last_px);
  if (kHistoryFilter == kHistoryLanczos) return lanczosHistory(image, px, last_px);
  return cubicHistory(image, px, texel_uv, last_px, sharpness,
                      kHistoryFilter == kHistoryCatmullRom9);
}

#endif
