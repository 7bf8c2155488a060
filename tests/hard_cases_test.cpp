// SPDX-License-Identifier: MIT
//
// What engines feed a technique beside plain surfaces: small highlights, light and shadow that no
// motion vector follows, particles, missing motion, noise, cuts, changes of exposure. `reprise`
// must not fall behind `taa` where taa, which bounds all history, is at its best. Run by hand it
// prints the table of src/techniques/reprise/README.md.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "equations/hash.h"
#include "formula_source.h"
#include "lab/metrics/display_space.h"
#include "lab/metrics/psnr.h"
#include "test_device.h"

namespace reprise::lab {
namespace {

constexpr VkExtent2D kExtent{64, 40};
constexpr uint32_t kWarmUp = 8;
constexpr uint32_t kFrames = 24;

float tiles(float x_px, float y_px) {
  const auto cell = static_cast<int>(std::floor(x_px / 5.3f) + std::floor(y_px / 4.1f));
  return cell % 2 == 0 ? 0.5f : 0.2f;
}

float spot(float x_px, float y_px, float center_x_px, float center_y_px, float radius_px) {
  return std::hypot(x_px - center_x_px, y_px - center_y_px) < radius_px ? 1.0f : 0.0f;
}

// `color` is told the frame, since what changes here is not what motion vectors say.
struct HardCase {
  const char* name;
  std::function<Rgb(float x_px, float y_px, uint32_t frame)> color;
  float velocity_px[2] = {0.0f, 0.0f};
  float noise = 0.0f;         // relative deviation of a sample, anew in every frame and pixel
  bool reactive = false;      // the mask is 1 where `particles` says so
  bool lies_of_rest = false;  // motion is given as 0
  // How far reprise may lie below taa. What is more than rounding is a limit that its page states.
  double below_taa_db = 0.5;
  std::function<float(uint32_t frame)> exposure = [](uint32_t) { return 1.0f; };
};

float particleX(uint32_t frame) {
  return std::fmod(1.7f * static_cast<float>(frame), static_cast<float>(kExtent.width));
}

Rgb grey(float value) {
  return {value, 0.9f * value, 0.8f * value};
}

std::vector<HardCase> hardCases() {
  const auto floor = [](float x, float y, uint32_t) { return grey(tiles(x, y)); };
  const auto shadow = [](float x, float y, uint32_t frame) {
    const bool dark = x + 0.3f * y < 0.7f * static_cast<float>(frame) + 10.0f;
    return grey(tiles(x, y) * (dark ? 0.3f : 1.0f));
  };
  const auto light = [](float x, float y, uint32_t frame) {
    return grey(tiles(x, y) * (1.0f + 0.5f * std::sin(0.4f * static_cast<float>(frame))));
  };
  const auto highlights = [](float x, float y, uint32_t) {
    const float u = std::fmod(x + 730.0f, 7.3f);
    const float v = std::fmod(y + 610.0f, 6.1f);
    return grey(tiles(x, y) + 60.0f * spot(u, v, 3.0f, 3.0f, 0.35f));
  };
  const auto particles = [](float x, float y, uint32_t frame) {
    Rgb rgb = grey(tiles(x, y));
    rgb[0] += 2.0f * spot(x, y, particleX(frame), 20.0f, 3.5f);
    return rgb;
  };
  const auto sky = [](float x, float y, uint32_t frame) {
    const float at = x - 0.8f * static_cast<float>(frame);
    return grey(0.6f + 0.2f * std::sin(0.4f * at) * std::cos(0.3f * y));
  };
  const auto fence = [](float x, float y, uint32_t) {
    const bool wire = std::fmod(x + 0.5f * y + 900.0f, 4.0f) < 0.5f;
    return wire ? grey(0.05f) : grey(0.8f);
  };
  const auto cut = [](float x, float y, uint32_t frame) {
    return frame < kWarmUp + 4 ? grey(tiles(x, y)) : grey(1.2f - 2.0f * tiles(0.7f * y, x));
  };
  return {
      {.name = "highlights of 60, 0.7 px, panning",
       .color = highlights,
       .velocity_px = {0.37f, 0.21f},
       .below_taa_db = 0.0},
      {.name = "shadow's edge over a still floor", .color = shadow},
      {.name = "shadow's edge over a panning floor", .color = shadow, .velocity_px = {0.4f, 0.3f}},
      {.name = "light that swings by half", .color = light},
      {.name = "light that swings, panning", .color = light, .velocity_px = {0.4f, 0.3f}},
      {.name = "particle without motion", .color = particles},
      {.name = "particle with a reactive mask", .color = particles, .reactive = true},
      {.name = "fence of half a pixel, panning", .color = fence, .velocity_px = {0.33f, 0.0f}},
      {.name = "sky that pans without motion", .color = sky, .lies_of_rest = true},
      {.name = "noise of 30 %, still", .color = floor, .noise = 0.3f},
      {.name = "noise of 30 %, panning",
       .color = floor,
       .velocity_px = {0.4f, 0.3f},
       .noise = 0.3f},
      {.name = "cut without reset", .color = cut},
      {.name = "exposure that doubles and halves",
       .color = floor,
       .velocity_px = {0.4f, 0.3f},
       .exposure = [](uint32_t frame) { return frame % 8 < 4 ? 1.0f : 2.0f; }},
      {.name = "still", .color = floor},
  };
}

std::vector<FloatImage> referencesOf(const HardCase& hard) {
  uint32_t now = 0;
  Formula formula;
  formula.velocity_px[0] = hard.velocity_px[0];
  formula.velocity_px[1] = hard.velocity_px[1];
  formula.color = [&](float x, float y) { return hard.color(x, y, now); };
  FormulaSource source(testDevice(), kExtent, formula);
  std::vector<FloatImage> references(kFrames);
  for (now = kWarmUp; now < kFrames; ++now) {
    references[now] = displayImage(*source.reference(now));
  }
  return references;
}

// PSNR after display over frames [kWarmUp, kFrames).
double psnrOf(const HardCase& hard, const char* technique,
              const std::vector<FloatImage>& references) {
  uint32_t now = 0;
  Formula formula;
  formula.velocity_px[0] = hard.velocity_px[0];
  formula.velocity_px[1] = hard.velocity_px[1];
  formula.color = [&](float x, float y) { return hard.color(x, y, now); };
  formula.damage = [&](uint32_t frame, FloatImage& color, FloatImage&, FloatImage& motion) {
    for (size_t i = 0; i < color.texelCount(); ++i) {
      const uint32_t h = eq::hashPcg(static_cast<uint32_t>(i) * 977u + frame * 7919u);
      // Uniform with the wanted deviation: sqrt(3) of it to both sides.
      const float noise =
          1.0f + hard.noise * 1.7320508f * (static_cast<float>(h) / 2147483648.0f - 1.0f);
      for (size_t c = 0; c < 3; ++c) color.texels[4 * i + c] *= noise * hard.exposure(frame);
    }
    if (hard.lies_of_rest) std::fill(motion.texels.begin(), motion.texels.end(), 0.0f);
  };
  FormulaSource source(testDevice(), kExtent, formula);
  Resolver resolver(testDevice(), parseTechnique(technique), source.info());
  const Image reactive(testDevice(), {.format = VK_FORMAT_R32_SFLOAT, .extent = kExtent});
  double sum = 0.0;
  for (now = 0; now < kFrames; ++now) {
    if (hard.reactive) {
      FloatImage mask(kExtent.width, kExtent.height, 1);
      for (uint32_t y = 0; y < kExtent.height; ++y) {
        for (uint32_t x = 0; x < kExtent.width; ++x) {
          // A pixel beyond the particle, now and before: hosts draw masks a little too large.
          const float at = static_cast<float>(x) + 0.5f;
          const float down = static_cast<float>(y) + 0.5f;
          *mask.at(x, y) = std::max(spot(at, down, particleX(now), 20.0f, 4.5f),
                                    spot(at, down, particleX(now > 0 ? now - 1 : 0), 20.0f, 4.5f));
        }
      }
      upload(testDevice(), reactive, mask);
    }
    const float exposure = hard.exposure(now);
    FloatImage image = resolveFrames(resolver, source, 1, now, [&](FrameInputs& inputs) {
      inputs.pre_exposure = exposure;
      if (hard.reactive) inputs.reactive = &reactive;
    });
    if (now < kWarmUp) continue;
    for (float& value : image.texels) value /= exposure;
    sum += psnrDb(meanSquaredError(references[now], displayImage(image)));
  }
  return sum / (kFrames - kWarmUp);
}

TEST(HardCases, RepriseDoesNotFallBehind) {
  std::printf("| case | none | taa | reprise |\n|---|---|---|---|\n");
  for (const HardCase& hard : hardCases()) {
    const std::vector<FloatImage> references = referencesOf(hard);
    const double none = psnrOf(hard, "none", references);
    const double taa = psnrOf(hard, "taa", references);
    const double reprise = psnrOf(hard, "reprise", references);
    std::printf("| %s | %.2f | %.2f | %.2f |\n", hard.name, none, taa, reprise);
    EXPECT_GT(reprise, taa - hard.below_taa_db) << hard.name;
  }
  expectNoValidationMessages();
}

// Each setting on what it is for, against the same technique without it.
TEST(HardCases, WhatWidensTheBoundPays) {
  struct Pays {
    const char* without;
    HardCase hard;
  };
  // Mortar of a third of a pixel, in most frames in none of nine samples, in a wall that is not
  // even.
  const auto faint = [](float x, float y, uint32_t) {
    const bool mortar = std::fmod(y + 900.0f, 5.0f) < 0.33f;
    return grey(0.5f + 0.01f * std::sin(1.3f * x) * std::sin(1.7f * y) + (mortar ? 0.08f : 0.0f));
  };
  const HardCase highlights = hardCases().front();
  const Pays all[] = {
      {"reprise:flips=0", highlights},
      {"reprise:tone=0", highlights},
      {"reprise:bound_faint=3",
       {.name = "faint mortar, panning", .color = faint, .velocity_px = {0.37f, 0.21f}}},
  };
  for (const Pays& pays : all) {
    const std::vector<FloatImage> references = referencesOf(pays.hard);
    const double with = psnrOf(pays.hard, "reprise", references);
    const double without = psnrOf(pays.hard, pays.without, references);
    std::printf("%s: %.2f, without %.2f\n", pays.without, with, without);
    EXPECT_GT(with, without) << pays.without;
  }
  expectNoValidationMessages();
}

// Bars that move over an even sky at rest look as they do with the sky moving along. One pixel of
// sky between two bars lies beside nearer ones on both sides, as no slope does: with the sky's
// motion it lost its history in every frame (22.9 for 31.3 dB). Wider gaps are the sky's again, and
// what bars leave there when they have moved on is not history to mix with (17.6 for 32.7 dB).
TEST(HardCases, AGapMovesWithItsBars) {
  struct Bars {
    float slant, velocity_px, period_px;
    double below_flat_db = 1.0;
  };
  // Bars that pass a sky at rest slowly leave a trail of a pixel: what keeps thin bars whole.
  for (const Bars& bars : {Bars{0.0f, 0.37f, 2.0f}, Bars{1.0f, 1.7f, 6.0f}, Bars{0.3f, 0.8f, 4.0f},
                           Bars{0.0f, 0.37f, 20.0f, 6.5}}) {
    const auto isBar = [&](float x, float y) {
      return std::fmod(x + bars.slant * y + 900.0f, bars.period_px) < 0.5f * bars.period_px;
    };
    const auto psnr = [&](bool deep) {
      Formula formula;
      formula.velocity_px[0] = bars.velocity_px;
      formula.color = [&](float x, float y) { return isBar(x, y) ? grey(0.8f) : grey(0.05f); };
      formula.damage = [&](uint32_t, FloatImage& color, FloatImage& depth, FloatImage& motion) {
        for (size_t i = 0; deep && i < color.texelCount(); ++i) {
          if (color.texels[4 * i] > 0.5f) continue;
          depth.texels[i] = 1000.0f;
          motion.texels[2 * i] = 0.0f;
        }
      };
      FormulaSource source(testDevice(), kExtent, formula);
      Resolver resolver(testDevice(), parseTechnique("reprise"), source.info());
      double sum = 0.0;
      for (uint32_t i = 0; i < kFrames; ++i) {
        const FloatImage image = resolveFrames(resolver, source, 1, i);
        if (i < kWarmUp) continue;
        sum += psnrDb(meanSquaredError(displayImage(*source.reference(i)), displayImage(image)));
      }
      return sum / (kFrames - kWarmUp);
    };
    const double flat = psnr(false);
    const double deep = psnr(true);
    std::printf("bars of %.0f px, slant %.1f, %.2f px a frame: %.2f, over a sky at rest %.2f\n",
                0.5 * bars.period_px, bars.slant, bars.velocity_px, flat, deep);
    EXPECT_GT(deep, flat - bars.below_flat_db);
  }
  expectNoValidationMessages();
}

TEST(HardCases, WhatSilhouettesLeaveConcernsThemAlone) {
  Formula floor;
  floor.velocity_px[0] = 0.4f;
  floor.color = [](float x, float y) { return grey(tiles(x, y)); };
  FormulaSource source(testDevice(), kExtent, floor);
  Resolver with(testDevice(), parseTechnique("reprise"), source.info());
  Resolver without(testDevice(), parseTechnique("reprise:history_uncovered=0"), source.info());
  EXPECT_EQ(resolveFrames(with, source, kFrames).texels,
            resolveFrames(without, source, kFrames).texels);
  expectNoValidationMessages();
}

}  // namespace
}  // namespace reprise::lab
