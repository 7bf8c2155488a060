// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace reprise::lab {

// Interleaved float texels, rows from top to bottom: texel (x, y) channel c lies at
// (y * width + x) * channels + c.
struct FloatImage {
  uint32_t width = 0;
  uint32_t height = 0;
  uint32_t channels = 0;
  std::vector<float> texels;

  FloatImage() = default;
  FloatImage(uint32_t width_px, uint32_t height_px, uint32_t channel_count)
      : width(width_px),
        height(height_px),
        channels(channel_count),
        texels(size_t{width_px} * height_px * channel_count) {}

  float* at(uint32_t x, uint32_t y) { return &texels[(size_t{y} * width + x) * channels]; }
  const float* at(uint32_t x, uint32_t y) const {
    return &texels[(size_t{y} * width + x) * channels];
  }
  size_t texelCount() const { return size_t{width} * height; }
  bool sameShape(const FloatImage& other) const {
    return width == other.width && height == other.height && channels == other.channels;
  }
};

}  // namespace reprise::lab
