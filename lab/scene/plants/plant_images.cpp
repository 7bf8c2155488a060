// SPDX-License-Identifier: MIT
#include "lab/scene/plants/plant_images.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "equations/hash.h"

namespace reprise::lab {
namespace {

float lattice(int x, int y, uint32_t seed) {
  return eq::unitFloat(eq::hashPcg(static_cast<uint32_t>(x) * 1597334677u ^
                                   static_cast<uint32_t>(y) * 3812015801u ^ seed));
}

// Value noise of `period` x `period` features over the unit square, seamless.
float noise(glm::vec2 uv, int period, uint32_t seed) {
  const glm::vec2 p = uv * static_cast<float>(period);
  const glm::vec2 base = glm::floor(p);
  glm::vec2 f = p - base;
  f = f * f * (3.0f - 2.0f * f);
  const auto value = [&](int dx, int dy) {
    const int x = (static_cast<int>(base.x) + dx + 4 * period) % period;
    const int y = (static_cast<int>(base.y) + dy + 4 * period) % period;
    return lattice(x, y, seed);
  };
  return glm::mix(glm::mix(value(0, 0), value(1, 0), f.x), glm::mix(value(0, 1), value(1, 1), f.x),
                  f.y);
}

// Five octaves, mean 0.5.
float cloudy(glm::vec2 uv, int period, uint32_t seed) {
  float sum = 0.0f;
  float share = 0.5f;
  for (uint32_t octave = 0; octave < 5; ++octave) {
    sum += share * noise(uv, period << octave, seed + octave);
    share *= 0.5f;
  }
  return sum / (1.0f - share * 2.0f + 1.0e-6f);
}

uint8_t byteOf(float v) {
  return static_cast<uint8_t>(std::lround(255.0f * std::clamp(v, 0.0f, 1.0f)));
}

// `texel` gives sRGB colour and coverage at a texel's centre.
SceneImage drawn(uint32_t width, uint32_t height, ImageRole role,
                 const std::function<glm::vec4(glm::vec2)>& texel) {
  SceneImage image{width, height, role, 0.0f, {}};
  image.rgba.reserve(size_t{4} * width * height);
  for (uint32_t y = 0; y < height; ++y) {
    for (uint32_t x = 0; x < width; ++x) {
      const glm::vec2 uv((static_cast<float>(x) + 0.5f) / static_cast<float>(width),
                         (static_cast<float>(y) + 0.5f) / static_cast<float>(height));
      const glm::vec4 t = texel(uv);
      for (int c = 0; c < 4; ++c) image.rgba.push_back(byteOf(t[c]));
    }
  }
  return image;
}

// Normals of a height field (m) over a square of `side_m`; green towards falling v.
SceneImage normalsOf(uint32_t size, float side_m, const std::function<float(glm::vec2)>& height) {
  const float step = 1.0f / static_cast<float>(size);
  return drawn(size, size, ImageRole::kNormal, [&](glm::vec2 uv) {
    const float scale = 1.0f / (2.0f * step * side_m);
    const float du =
        (height(uv + glm::vec2(step, 0.0f)) - height(uv - glm::vec2(step, 0.0f))) * scale;
    const float dv =
        (height(uv + glm::vec2(0.0f, step)) - height(uv - glm::vec2(0.0f, step))) * scale;
    const glm::vec3 normal = glm::normalize(glm::vec3(-du, dv, 1.0f));
    return glm::vec4(normal * 0.5f + 0.5f, 1.0f);
  });
}

// A soft edge one to two texels wide is what a cutoff of 0.5 finds again in every level.
float covered(float inside, float softness) {
  return std::clamp(0.5f + inside / softness, 0.0f, 1.0f);
}

glm::vec4 leaf(glm::vec2 uv, uint32_t kind) {
  // Stem from v = 0 to 0.12, blade above.
  const float x = (uv.x - 0.5f) * 2.0f;
  const float along = (uv.y - 0.12f) / 0.84f;
  const glm::vec3 greens[] = {
      {0.33f, 0.48f, 0.14f}, {0.40f, 0.53f, 0.17f}, {0.28f, 0.43f, 0.16f}, {0.52f, 0.52f, 0.17f}};
  const float stem = 0.035f - std::abs(x);
  float inside = along < 0.0f ? stem : -1.0f;
  float vein = 1.0f;
  if (along >= 0.0f && along <= 1.0f) {
    const float shape = std::pow(std::sin(3.14159265f * std::pow(along, 0.72f)), 0.85f);
    const float teeth = 0.05f * std::abs(2.0f * (along * 13.0f - std::floor(along * 13.0f)) - 1.0f);
    inside = 0.80f * shape - teeth - std::abs(x);
    inside = std::max(inside, along < 0.1f ? stem : -1.0f);
    const float side = (along - 0.35f * std::abs(x)) * 9.0f;
    const float to_side = std::abs(side - std::round(side));
    vein = std::min(std::abs(x) / 0.035f, to_side / 0.11f);
  }
  const float tone = 0.8f + 0.4f * cloudy(uv, 4, 17u + kind);
  glm::vec3 color = greens[kind] * tone;
  color = glm::mix(color * 1.35f + 0.04f, color, std::clamp(vein, 0.0f, 1.0f));
  const float spot = noise(uv, 11, 90u + kind);
  if (spot > 0.86f) color = glm::mix(color, glm::vec3(0.42f, 0.30f, 0.12f), 0.7f);
  return glm::vec4(color, covered(inside, 0.05f));
}

float barkHeight(glm::vec2 uv) {
  const float ridge = std::abs(2.0f * cloudy(uv * glm::vec2(1.0f, 0.5f), 8, 51u) - 1.0f);
  return 0.02f * ridge + 0.004f * noise(uv, 64, 52u);
}

float soilHeight(glm::vec2 uv) {
  const float stone = std::max(0.0f, noise(uv, 40, 61u) - 0.72f);
  return 0.03f * cloudy(uv, 8, 60u) + 0.12f * stone + 0.006f * noise(uv, 128, 62u);
}

}  // namespace

SceneImage leafImage(float alpha_cutoff) {
  SceneImage image = drawn(256, 256, ImageRole::kColor, [](glm::vec2 uv) {
    const glm::vec2 cell = glm::floor(uv * 2.0f);
    return leaf(uv * 2.0f - cell, static_cast<uint32_t>(cell.x + 2.0f * cell.y));
  });
  image.alpha_cutoff = alpha_cutoff;
  return image;
}

SceneImage grassImage(float alpha_cutoff) {
  struct Blade {
    float foot, tip, bend, height, width, tone;
  };
  std::vector<Blade> blades;
  for (int i = 0; i < 15; ++i) {
    const float foot = 0.12f + 0.76f * (static_cast<float>(i) + lattice(i, 0, 71u)) / 15.0f;
    blades.push_back({foot, foot + 0.30f * (lattice(i, 1, 71u) - 0.5f), 0.5f + lattice(i, 2, 71u),
                      0.45f + 0.52f * lattice(i, 3, 71u), 0.012f + 0.014f * lattice(i, 4, 71u),
                      lattice(i, 5, 71u)});
  }
  SceneImage image = drawn(256, 256, ImageRole::kColor, [&](glm::vec2 uv) {
    float inside = -1.0f;
    glm::vec3 color(0.34f, 0.44f, 0.17f);
    for (const Blade& blade : blades) {
      const float s = uv.y / blade.height;
      if (s > 1.0f) continue;
      const float center = glm::mix(blade.foot, blade.tip, std::pow(s, 1.0f + blade.bend));
      const float here = blade.width * (1.0f - s * s) - std::abs(uv.x - center);
      if (here <= inside) continue;
      inside = here;
      color = glm::mix(glm::vec3(0.27f, 0.40f, 0.12f), glm::vec3(0.58f, 0.58f, 0.27f),
                       0.7f * blade.tone + 0.3f * s) *
              (0.55f + 0.5f * s);
    }
    return glm::vec4(color, covered(inside, 0.010f));
  });
  image.alpha_cutoff = alpha_cutoff;
  return image;
}

SceneImage bladeImage() {
  return drawn(32, 64, ImageRole::kColor, [](glm::vec2 uv) {
    const float rib = 1.0f + 0.25f * std::cos(6.2831853f * 2.0f * uv.x);
    const glm::vec3 color =
        glm::mix(glm::vec3(0.25f, 0.38f, 0.11f), glm::vec3(0.55f, 0.57f, 0.26f), uv.y);
    return glm::vec4(color * rib * (0.6f + 0.4f * uv.y), 1.0f);
  });
}

SceneImage barkImage() {
  return drawn(256, 256, ImageRole::kColor, [](glm::vec2 uv) {
    const float ridge = barkHeight(uv) / 0.022f;
    const glm::vec3 color = glm::mix(glm::vec3(0.20f, 0.16f, 0.13f), glm::vec3(0.47f, 0.42f, 0.35f),
                                     std::clamp(ridge, 0.0f, 1.0f));
    const float moss = std::clamp(3.0f * (noise(uv, 6, 55u) - 0.62f), 0.0f, 0.7f);
    return glm::vec4(glm::mix(color, glm::vec3(0.30f, 0.36f, 0.16f), moss), 1.0f);
  });
}

SceneImage barkNormalImage() {
  return normalsOf(256, 0.5f, barkHeight);
}

SceneImage soilImage() {
  return drawn(512, 512, ImageRole::kColor, [](glm::vec2 uv) {
    const glm::vec3 earth = glm::mix(glm::vec3(0.27f, 0.20f, 0.13f), glm::vec3(0.46f, 0.37f, 0.25f),
                                     cloudy(uv, 8, 60u));
    glm::vec3 color = earth * (0.7f + 0.5f * noise(uv, 128, 62u));
    if (noise(uv, 40, 61u) > 0.72f)
      color = glm::vec3(0.52f, 0.50f, 0.46f) * (0.7f + 0.4f * color.r);
    const float straw = noise(uv, 90, 63u) * noise(uv, 23, 64u);
    if (straw > 0.62f) color = glm::vec3(0.62f, 0.53f, 0.30f);
    const float moss = std::clamp(4.0f * (cloudy(uv, 3, 65u) - 0.5f), 0.0f, 0.85f);
    color =
        glm::mix(color, glm::vec3(0.25f, 0.33f, 0.11f) * (0.6f + 0.8f * noise(uv, 200, 66u)), moss);
    return glm::vec4(color, 1.0f);
  });
}

SceneImage soilNormalImage() {
  return normalsOf(512, 2.5f, soilHeight);
}

SceneImage canopyImage() {
  return drawn(256, 256, ImageRole::kColor, [](glm::vec2 uv) {
    const float crown = noise(uv, 48, 81u);
    const glm::vec3 color = glm::mix(glm::vec3(0.20f, 0.27f, 0.13f), glm::vec3(0.42f, 0.47f, 0.21f),
                                     0.6f * crown + 0.4f * cloudy(uv, 6, 82u));
    return glm::vec4(color * (0.6f + 0.5f * noise(uv, 128, 83u)), 1.0f);
  });
}

SceneImage treeLineImage(float alpha_cutoff) {
  struct Crown {
    float x, top, half_width, tone;
  };
  std::vector<Crown> crowns;
  constexpr int kTrees = 14;
  for (int i = 0; i < kTrees; ++i) {
    const float x = (static_cast<float>(i) + 0.2f + 0.6f * lattice(i, 0, 91u)) / kTrees;
    crowns.push_back({x, 0.55f + 0.42f * lattice(i, 1, 91u), 0.035f + 0.03f * lattice(i, 2, 91u),
                      lattice(i, 3, 91u)});
  }
  SceneImage image = drawn(512, 256, ImageRole::kColor, [&](glm::vec2 uv) {
    // Undergrowth first, then what stands in it.
    float inside = 0.10f + 0.14f * cloudy(uv, 12, 92u) - uv.y;
    glm::vec3 color(0.40f, 0.47f, 0.22f);
    const float leaves = cloudy(uv, 24, 93u);
    for (const Crown& crown : crowns) {
      const float s = uv.y / crown.top;
      // The picture repeats along u.
      float off = std::abs(uv.x - crown.x);
      off = std::min(off, 1.0f - off);
      const float foot = std::clamp((s - 0.25f) / 0.2f, 0.0f, 1.0f);
      const float shape = crown.half_width * std::sqrt(std::max(1.0f - s * s * s, 0.0f)) * foot;
      const float trunk = s < 0.9f ? 0.0035f - off : -1.0f;
      // Gaps between the leaves, more of them at the rim.
      const float leafy = shape > 0.0f ? shape * (1.9f * leaves - 0.05f) - off : -1.0f;
      const float here = std::max(leafy, trunk);
      if (here <= inside) continue;
      inside = here;
      color = leafy > trunk
                  ? glm::mix(glm::vec3(0.32f, 0.42f, 0.17f), glm::vec3(0.58f, 0.60f, 0.24f),
                             0.5f * crown.tone + 0.5f * leaves)
                  : glm::vec3(0.25f, 0.22f, 0.19f);
    }
    return glm::vec4(color * (0.75f + 0.5f * noise(uv, 128, 94u)), covered(inside, 0.008f));
  });
  image.alpha_cutoff = alpha_cutoff;
  return image;
}

SceneImage skyImage() {
  return drawn(512, 128, ImageRole::kColor, [](glm::vec2 uv) {
    const glm::vec3 haze(0.86f, 0.87f, 0.87f);
    const glm::vec3 blue(0.45f, 0.58f, 0.76f);
    const glm::vec3 clear = glm::mix(haze, blue, std::min(std::sqrt(uv.y) * 1.15f, 1.0f));
    const float high = std::clamp(4.0f * uv.y, 0.0f, 1.0f);
    const float cloud = std::clamp(
        2.4f * (cloudy(glm::vec2(uv.x, 0.35f * std::sqrt(uv.y)), 7, 101u) - 0.5f), 0.0f, 0.8f);
    return glm::vec4(glm::mix(clear, glm::vec3(0.93f, 0.93f, 0.92f), cloud * high), 1.0f);
  });
}

}  // namespace reprise::lab
