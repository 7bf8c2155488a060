// SPDX-License-Identifier: MIT
// C++ only: where a frame of 2 x 2 coarse pixels shades and sees.
#pragma once

#include <cstdint>
#include <vector>

#include "equations/language.h"

namespace reprise::eq {

inline constexpr uint32_t kMaxCoarseJitter = 128;

// `length` positions of shading samples in the cell [0, 2) px of a coarse pixel's torus, well
// spread there, and the visibility samples that come with them well spread over the pixel: void and
// cluster for two masks (Xiao, Liktor, Vaidyanathan 2018, section 3.1) on 64 x 64 cells. Neighbours
// in the sequence lie apart. The same on every compiler; computed once for each length and kept.
const std::vector<vec2>& coarseBlueNoise(uint32_t length);

// A shading position as a shift of the coarse grid and a jitter of the projection within half a
// pixel: centre of pixel (0, 0)'s coarse pixel - jitter = position, modulo 2.
struct CoarseOffset {
  int32_t origin_px[2];
  vec2 jitter_px;
};
CoarseOffset splitOffset(vec2 shading_px);

}  // namespace reprise::eq
