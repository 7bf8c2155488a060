// SPDX-License-Identifier: MIT
#include "lab/render/image_pyramid.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/glm.hpp>

namespace reprise::lab {
namespace {

// Weight of a texel's colour where it is fully transparent: its colour still matters where nothing
// else is there.
constexpr float kHoleWeight = 1.0f / 4096.0f;

struct Level {
  uint32_t width = 0;
  uint32_t height = 0;
  std::vector<glm::vec4> texels;
};

float linearFromSrgb(float v) {
  return v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f);
}

float srgbFromLinear(float v) {
  return v <= 0.0031308f ? v * 12.92f : 1.055f * std::pow(v, 1.0f / 2.4f) - 0.055f;
}

Level decode(const SceneImage& image) {
  std::array<float, 256> rgb;
  for (uint32_t i = 0; i < 256; ++i) {
    const float v = static_cast<float>(i) / 255.0f;
    rgb[i] = image.role == ImageRole::kColor ? linearFromSrgb(v) : v;
  }
  Level level{image.width, image.height, {}};
  level.texels.resize(size_t{image.width} * image.height);
  for (size_t i = 0; i < level.texels.size(); ++i) {
    const uint8_t* t = &image.rgba[4 * i];
    level.texels[i] = {rgb[t[0]], rgb[t[1]], rgb[t[2]], static_cast<float>(t[3]) / 255.0f};
    if (image.role == ImageRole::kNormal) {
      level.texels[i] = level.texels[i] * 2.0f - glm::vec4(1.0f, 1.0f, 1.0f, 0.0f);
    }
  }
  return level;
}

uint8_t byteOf(float v) {
  return static_cast<uint8_t>(std::lround(255.0f * std::clamp(v, 0.0f, 1.0f)));
}

std::vector<uint8_t> encode(const Level& level, ImageRole role, float alpha_scale) {
  std::vector<uint8_t> rgba(4 * level.texels.size());
  for (size_t i = 0; i < level.texels.size(); ++i) {
    glm::vec4 t = level.texels[i];
    if (role == ImageRole::kNormal) {
      const float length = std::max(glm::length(glm::vec3(t)), 1.0e-6f);
      t = glm::vec4(glm::vec3(t) / length * 0.5f + 0.5f, t.a);
    }
    for (int c = 0; c < 3; ++c) {
      rgba[4 * i + c] = byteOf(role == ImageRole::kColor ? srgbFromLinear(t[c]) : t[c]);
    }
    rgba[4 * i + 3] = byteOf(t.a * alpha_scale);
  }
  return rgba;
}

struct Tap {
  uint32_t index;
  float weight;
};

// What of `from` texels each of `to` texels is made of: their shares of its area where there are
// fewer, linear interpolation (wrapped) where there are more.
std::vector<std::vector<Tap>> tapsOf(uint32_t from, uint32_t to) {
  std::vector<std::vector<Tap>> taps(to);
  const double ratio = static_cast<double>(from) / to;
  for (uint32_t i = 0; i < to; ++i) {
    if (to > from) {
      const double at = (i + 0.5) * ratio - 0.5;
      const double base = std::floor(at);
      const auto low = static_cast<uint32_t>(static_cast<int64_t>(base) + from) % from;
      taps[i] = {{low, static_cast<float>(1.0 - (at - base))},
                 {(low + 1) % from, static_cast<float>(at - base)}};
      continue;
    }
    const double begin = i * ratio;
    const double end = begin + ratio;
    for (auto k = static_cast<uint32_t>(begin); k < from && k < end; ++k) {
      const double share = std::min(end, k + 1.0) - std::max(begin, static_cast<double>(k));
      if (share > 1.0e-9) taps[i].push_back({k, static_cast<float>(share / ratio)});
    }
  }
  return taps;
}

glm::vec4 weighted(glm::vec4 texel, bool by_coverage, float weight) {
  if (!by_coverage) return texel * weight;
  const float share = weight * (texel.a + kHoleWeight);
  return glm::vec4(glm::vec3(texel) * share, share);
}

// Sums along one axis at a time; colours carry their coverage as a weight in between.
Level resized(const Level& from, uint32_t width, uint32_t height, bool by_coverage) {
  if (from.width == width && from.height == height) return from;
  const auto taps_x = tapsOf(from.width, width);
  const auto taps_y = tapsOf(from.height, height);
  std::vector<glm::vec4> rows(size_t{width} * from.height);
  for (uint32_t y = 0; y < from.height; ++y) {
    for (uint32_t x = 0; x < width; ++x) {
      glm::vec4 sum(0.0f);
      for (const Tap& tap : taps_x[x]) {
        sum += weighted(from.texels[size_t{y} * from.width + tap.index], by_coverage, tap.weight);
      }
      rows[size_t{y} * width + x] = sum;
    }
  }
  Level level{width, height, std::vector<glm::vec4>(size_t{width} * height)};
  for (uint32_t y = 0; y < height; ++y) {
    for (uint32_t x = 0; x < width; ++x) {
      glm::vec4 sum(0.0f);
      for (const Tap& tap : taps_y[y]) sum += rows[size_t{tap.index} * width + x] * tap.weight;
      if (by_coverage) sum = glm::vec4(glm::vec3(sum) / sum.a, sum.a - kHoleWeight);
      level.texels[size_t{y} * width + x] = sum;
    }
  }
  return level;
}

// Factor of alpha with which `level` has `wanted` coverage, by bisection.
float alphaScale(const Level& level, float cutoff, float wanted) {
  float low = 0.0f;
  float high = 8.0f;
  for (int i = 0; i < 24; ++i) {
    const float scale = 0.5f * (low + high);
    size_t covered = 0;
    for (const glm::vec4& t : level.texels) covered += t.a * scale >= cutoff ? 1 : 0;
    const float share = static_cast<float>(covered) / static_cast<float>(level.texels.size());
    (share < wanted ? low : high) = scale;
  }
  return high;
}

}  // namespace

uint32_t levelCount(uint32_t width, uint32_t height) {
  return static_cast<uint32_t>(std::bit_width(std::max(width, height)));
}

float coverage(const std::vector<uint8_t>& rgba, float cutoff) {
  size_t covered = 0;
  for (size_t i = 3; i < rgba.size(); i += 4) {
    covered += static_cast<float>(rgba[i]) / 255.0f >= cutoff ? 1 : 0;
  }
  return static_cast<float>(covered) / static_cast<float>(rgba.size() / 4);
}

std::vector<std::vector<uint8_t>> imagePyramid(const SceneImage& image, uint32_t width,
                                               uint32_t height) {
  const bool by_coverage = image.role == ImageRole::kColor;
  Level level = resized(decode(image), width, height, by_coverage);
  std::vector<std::vector<uint8_t>> levels;
  levels.push_back(encode(level, image.role, 1.0f));
  const float wanted =
      image.alpha_cutoff > 0.0f ? coverage(levels.front(), image.alpha_cutoff) : 0.0f;
  for (uint32_t i = 1; i < levelCount(width, height); ++i) {
    level =
        resized(level, std::max(1u, level.width / 2), std::max(1u, level.height / 2), by_coverage);
    // Levels of a few texels cannot have the share; none or all of it would blink.
    const bool scaled = image.alpha_cutoff > 0.0f && level.texels.size() >= 16;
    levels.push_back(
        encode(level, image.role, scaled ? alphaScale(level, image.alpha_cutoff, wanted) : 1.0f));
  }
  return levels;
}

}  // namespace reprise::lab
