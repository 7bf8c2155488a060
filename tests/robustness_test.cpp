// SPDX-License-Identifier: MIT
//
// Every technique on what hosts hand over by mistake or by need: no numbers, no motion, odd and
// changing extents, missing optional images.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "formula_source.h"
#include "test_device.h"

namespace reprise::lab {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

Rgb waves(float x_px, float y_px) {
  const float v = 0.5f + 0.4f * std::sin(0.9f * x_px) * std::cos(0.7f * y_px);
  return {v, 1.0f - v, 0.5f};
}

bool allFinite(const FloatImage& image) {
  for (const float value : image.texels) {
    if (!std::isfinite(value)) return false;
  }
  return true;
}

class Robust : public testing::TestWithParam<std::string> {
 protected:
  Resolver resolver(const FrameSource& source) {
    return Resolver(testDevice(), parseTechnique(GetParam()), source.info());
  }
  void TearDown() override { expectNoValidationMessages(); }
};

TEST_P(Robust, ANoNumberDoesNotSpread) {
  constexpr uint32_t kX = 20;
  constexpr uint32_t kY = 12;
  constexpr int kReach_px = 4;  // 3x3 neighbourhoods and bicubic taps, once
  // Its gain of light is a mean over 40 px: there one lost sample of 1600 may move it by its share.
  const bool pools_light = GetParam() == "reprise";
  const float far_slack = pools_light ? 1.0e-3f : 0.0f;
  Formula clean;
  clean.color = waves;
  FormulaSource clean_source(testDevice(), {40, 24}, clean);
  Resolver clean_resolver = resolver(clean_source);
  const FloatImage expected = resolveFrames(clean_resolver, clean_source, 12);
  for (const float bad : {kNan, kInfinity, -kInfinity, -5.0f}) {
    Formula dirty = clean;
    dirty.damage = [bad](uint32_t frame, FloatImage& color, FloatImage&, FloatImage&) {
      if (frame == 3) *color.at(kX, kY) = bad;
    };
    FormulaSource source(testDevice(), {40, 24}, dirty);
    Resolver r = resolver(source);
    const FloatImage image = resolveFrames(r, source, 12);
    ASSERT_TRUE(allFinite(image)) << bad;
    for (uint32_t y = 0; y < image.height; ++y) {
      for (uint32_t x = 0; x < image.width; ++x) {
        const bool near = std::abs(static_cast<int>(x) - static_cast<int>(kX)) <= kReach_px &&
                          std::abs(static_cast<int>(y) - static_cast<int>(kY)) <= kReach_px;
        if (near) continue;
        for (size_t c = 0; c < 3; ++c) {
          ASSERT_NEAR(image.at(x, y)[c], expected.at(x, y)[c], far_slack)
              << bad << " at " << x << ", " << y;
        }
      }
    }
  }
}

TEST_P(Robust, BadDepthAndMotionGiveFiniteFrames) {
  Formula formula;
  formula.color = waves;
  formula.damage = [](uint32_t frame, FloatImage&, FloatImage& depth, FloatImage& motion) {
    const float bad[] = {kNan, kInfinity, -kInfinity, 0.0f, -1.0f, 1.0e30f};
    for (uint32_t i = 0; i < 6; ++i) {
      *depth.at(5 * i, 3 + frame % 7) = bad[i];
      motion.at(5 * i + 2, 10 + frame % 5)[i % 2] = bad[i];
    }
  };
  FormulaSource source(testDevice(), {33, 19}, formula);
  Resolver r = resolver(source);
  for (uint32_t frame = 0; frame < 12; ++frame) {
    ASSERT_TRUE(allFinite(resolveFrames(r, source, 1, frame))) << frame;
  }
}

TEST_P(Robust, MotionOutOfTheFrameShowsTheCurrentOne) {
  Formula formula;
  formula.color = waves;
  formula.damage = [](uint32_t, FloatImage&, FloatImage&, FloatImage& motion) {
    for (float& value : motion.texels) value = 1.0e6f;
  };
  FormulaSource source(testDevice(), {32, 16}, formula);
  Resolver r = resolver(source);
  const FloatImage image = resolveFrames(r, source, 6);
  for (size_t i = 0; i < image.texels.size(); ++i) ASSERT_LE(image.texels[i], 1.01f);
  EXPECT_TRUE(allFinite(image));
}

TEST_P(Robust, TheSubrectangleMayChangeEachFrame) {
  Formula formula;
  formula.color = waves;
  FormulaSource source(testDevice(), {64, 36}, formula);
  Resolver r = resolver(source);
  const VkExtent2D extents[] = {{64, 36}, {48, 27}, {1, 1}, {63, 35}, {64, 1}, {64, 36}};
  uint32_t frame = 0;
  for (const VkExtent2D extent : extents) {
    const FloatImage image =
        resolveFrames(r, source, 1, frame++, [&](FrameInputs& inputs) { inputs.extent = extent; });
    for (uint32_t y = 0; y < extent.height; ++y) {
      for (uint32_t x = 0; x < extent.width; ++x) {
        for (size_t c = 0; c < 3; ++c) {
          ASSERT_TRUE(std::isfinite(image.at(x, y)[c]));
          ASSERT_LE(image.at(x, y)[c], 1.3f);
        }
      }
    }
  }
}

TEST_P(Robust, ReactiveAndIdImagesAreTakenOrLeft) {
  const VkExtent2D extent{32, 16};
  Formula formula;
  formula.color = waves;
  FormulaSource source(testDevice(), extent, formula);
  const Image reactive(testDevice(), {.format = VK_FORMAT_R32_SFLOAT, .extent = extent});
  const Image id(testDevice(), {.format = VK_FORMAT_R32_UINT, .extent = extent});
  FloatImage ones(extent.width, extent.height, 1);
  for (float& value : ones.texels) value = 1.0f;
  upload(testDevice(), reactive, ones);
  uploadBytes(testDevice(), id, std::vector<uint8_t>(id.bytes(), 3));
  Resolver r = resolver(source);
  uint32_t frame = 0;
  for (const bool given : {true, false, true}) {
    const FloatImage image = resolveFrames(r, source, 3, frame, [&](FrameInputs& inputs) {
      inputs.reactive = given ? &reactive : nullptr;
      inputs.id = given ? &id : nullptr;
    });
    EXPECT_TRUE(allFinite(image));
    frame += 3;
  }
}

TEST_P(Robust, ExposureChangesWithoutAStep) {
  // The scene is constant; the host's exposure doubles: history must follow.
  Formula formula;
  formula.color = [](float, float) { return Rgb{0.4f, 0.4f, 0.4f}; };
  formula.damage = [](uint32_t frame, FloatImage& color, FloatImage&, FloatImage&) {
    if (frame < 6) return;
    for (float& value : color.texels) value *= 2.0f;
  };
  FormulaSource source(testDevice(), {16, 16}, formula);
  Resolver r = resolver(source);
  resolveFrames(r, source, 6);
  const FloatImage image =
      resolveFrames(r, source, 1, 6, [](FrameInputs& inputs) { inputs.pre_exposure = 2.0f; });
  for (size_t i = 0; i < image.texelCount(); ++i) ASSERT_NEAR(image.texels[4 * i], 0.8f, 0.004f);
}

INSTANTIATE_TEST_SUITE_P(All, Robust, testing::ValuesIn(everyTechnique()), [](const auto& test) {
  std::string name = test.param;
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  return name;
});
// Without its gain of light nothing of it reaches farther than the others do.
INSTANTIATE_TEST_SUITE_P(Local, Robust, testing::Values("reprise:doubt_light=1e6"));

}  // namespace
}  // namespace reprise::lab
