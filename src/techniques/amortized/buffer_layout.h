// SPDX-License-Identifier: MIT
//
// Where the subpixel buffers lie in the pixel and in which order they are written. The paper has
// four; one is a plain history with a tent of a pixel, two lie on the diagonal.
//
// A slot is the image that holds a buffer. With as many buffers as slots they are the same; fewer
// buffers in four slots keep the slots of their quadrants, so that what lies there goes on.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "equations/shading_offset.h"

namespace reprise::amortized {

constexpr uint32_t kMaxBuffers = 4;
constexpr uint32_t kPeriod = eq::kQuadrantPeriod;

struct BufferLayout {
  uint32_t count;
  // Quadrant of each buffer (equation quadrantOffset).
  std::array<uint32_t, kMaxBuffers> quadrants;
  // Of the tent that gathers for one buffer (13), px. The tent for the pixel is 1 px either way.
  float tent_radius_px;
  // Deviation of a sample about its buffer's place, so that the pixel's kernel comes nearest to
  // the wanted Gaussian (0.4737 px): with one buffer nothing but the samples spreads.
  float sigma_px;
};

constexpr float kPixelTentRadius_px = 1.0f;
// Of the pixel's filter (Yang et al. 2009, section 5.1).
constexpr float kPixelSigma_px = 0.4737f;

constexpr BufferLayout bufferLayout(uint32_t count) {
  switch (count) {
    case 1:
      return {1, {eq::kQuadrantCentre}, 1.0f, kPixelSigma_px};
    case 2:
      return {2, {0, 3}, 0.5f, eq::kShadingOffsetSigma_px};
    default:
      return {4, {0, 1, 2, 3}, 0.5f, eq::kShadingOffsetSigma_px};
  }
}

// The buffer that frame `frame_index` writes. Four: the paper's irregular order. Two: the
// Thue-Morse word, which is as far from periodic as two letters can be, for the same reason.
inline uint32_t bufferOfFrame(uint32_t count, uint64_t frame_index) {
  const auto phase = static_cast<uint32_t>(frame_index % kPeriod);
  if (count == 4) return eq::quadrantOfFrame(phase);
  if (count == 2) return static_cast<uint32_t>(std::popcount(phase)) & 1u;
  return 0;
}

constexpr uint32_t slotOfBuffer(uint32_t slots, uint32_t count, uint32_t buffer) {
  return count == 2 && slots == 4 ? bufferLayout(2).quadrants[buffer] : buffer;
}

}  // namespace reprise::amortized
