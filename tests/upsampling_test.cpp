// SPDX-License-Identifier: MIT
//
// Techniques whose output has more pixels than their input: ratios, extents that change while
// running, the plan's jitter and mip bias.
#include <gtest/gtest.h>

#include <cmath>

#include "formula_source.h"
#include "test_device.h"

namespace reprise::lab {
namespace {

constexpr float kHalfStep = 1.0f / 1024.0f;

// A picture over (0, 0) to (1, 1), whatever extent it is sampled at: smooth, but for one edge.
Rgb picture(float u, float v) {
  const float wave = 0.5f + 0.3f * std::sin(9.0f * u + 2.0f) * std::cos(7.0f * v);
  return {wave, 1.0f - wave, u + 0.3f * v < 0.7f ? 0.2f : 0.8f};
}

Formula pictureAt(VkExtent2D extent) {
  Formula formula;
  formula.color = [extent](float x_px, float y_px) {
    return picture(x_px / static_cast<float>(extent.width),
                   y_px / static_cast<float>(extent.height));
  };
  return formula;
}

// Mean squared error against the mean of 8 x 8 positions a pixel.
double errorOf(const FloatImage& image) {
  double sum = 0.0;
  for (uint32_t y = 0; y < image.height; ++y) {
    for (uint32_t x = 0; x < image.width; ++x) {
      double mean[3] = {};
      for (uint32_t i = 0; i < 64; ++i) {
        const float u = (static_cast<float>(x) + (static_cast<float>(i % 8) + 0.5f) / 8.0f) /
                        static_cast<float>(image.width);
        const float v = (static_cast<float>(y) + (static_cast<float>(i / 8) + 0.5f) / 8.0f) /
                        static_cast<float>(image.height);
        const Rgb rgb = picture(u, v);
        for (size_t c = 0; c < 3; ++c) mean[c] += rgb[c] / 64.0;
      }
      for (size_t c = 0; c < 3; ++c) {
        const double d = image.at(x, y)[c] - mean[c];
        sum += d * d;
      }
    }
  }
  return sum / (3.0 * image.width * image.height);
}

class Upsampling : public testing::TestWithParam<std::string> {
 protected:
  Resolver resolver(const FrameSource& source, VkExtent2D output) {
    return Resolver(testDevice(), parseTechnique(GetParam()), source.info(), output);
  }
  void TearDown() override { expectNoValidationMessages(); }
};

TEST_P(Upsampling, AConstantImageStaysConstantAtEveryRatio) {
  const VkExtent2D cases[][2] = {{{1, 1}, {1, 1}},     {{1, 1}, {3, 2}},    {{16, 9}, {21, 12}},
                                 {{17, 11}, {34, 22}}, {{13, 7}, {40, 21}}, {{20, 5}, {20, 15}}};
  for (const auto& [input, output] : cases) {
    FormulaSource source(testDevice(), input, {});
    Resolver r = resolver(source, output);
    const FloatImage image = resolveFrames(r, source, 6);
    ASSERT_EQ(image.width, output.width);
    ASSERT_EQ(image.height, output.height);
    for (size_t i = 0; i < image.texels.size(); ++i) {
      if (i % 4 == 3) continue;
      ASSERT_NEAR(image.texels[i], 0.5f, kHalfStep) << output.width << "x" << output.height;
    }
  }
}

TEST_P(Upsampling, AStillViewGainsWhatOneFrameLacks) {
  for (const double ratio : {1.3, 2.0, 3.0}) {
    const VkExtent2D input{33, 21};
    const VkExtent2D output{static_cast<uint32_t>(std::lround(33 * ratio)),
                            static_cast<uint32_t>(std::lround(21 * ratio))};
    FormulaSource source(testDevice(), input, pictureAt(input));
    Resolver r = resolver(source, output);
    const double first = errorOf(resolveFrames(r, source, 1));
    const double last = errorOf(resolveFrames(r, source, 95, 1));
    // The edge is what one frame lacks; a picture shifted by half a pixel would stay far above.
    EXPECT_LT(last, 0.35 * first) << ratio;
    EXPECT_LT(last, 1.0e-3) << ratio;
  }
}

// The closest sample in its place: a pixel of the output is off by half a pixel of the input.
TEST_P(Upsampling, TheFirstFrameIsInterpolated) {
  const VkExtent2D input{33, 21};
  const VkExtent2D output{66, 42};
  FormulaSource source(testDevice(), input, pictureAt(input));
  Resolver r = resolver(source, output);
  const FloatImage image = resolveFrames(r, source, 1);
  double closest = 0.0;
  double rough = 0.0;
  for (uint32_t y = 0; y < output.height; ++y) {
    for (uint32_t x = 1; x < output.width; ++x) {
      const double step = image.at(x, y)[0] - image.at(x - 1, y)[0];
      const Rgb here =
          picture((static_cast<float>(x) + 0.5f) / 66.0f, (static_cast<float>(y) + 0.5f) / 42.0f);
      const Rgb left =
          picture((static_cast<float>(x) - 0.5f) / 66.0f, (static_cast<float>(y) + 0.5f) / 42.0f);
      const double truth = here[0] - left[0];
      rough += (step - truth) * (step - truth);
      // Every other step is 0, the others are twice as large.
      closest += truth * truth;
    }
  }
  EXPECT_LT(rough, 0.6 * closest);
}

TEST_P(Upsampling, TheInputMayChangeItsExtentWhileRunning) {
  const VkExtent2D output{66, 42};
  const VkExtent2D inputs[] = {{66, 42}, {33, 21}, {47, 29}, {22, 14}, {51, 42}, {1, 1}, {64, 41}};
  FormulaSource largest(testDevice(), output, pictureAt(output));
  Resolver r = resolver(largest, output);
  uint32_t frame = 0;
  for (const VkExtent2D input : inputs) {
    FormulaSource source(testDevice(), input, pictureAt(input));
    FloatImage image;
    for (int i = 0; i < 3; ++i, ++frame) {
      image = resolveFrames(r, source, 1, frame, [&](FrameInputs& inputs_now) {
        inputs_now.reset = frame == 0;
        inputs_now.output_extent = output;
      });
      for (const float value : image.texels) ASSERT_TRUE(std::isfinite(value));
    }
    // One pixel cannot hold the picture; every other extent shows it at once.
    if (input.width > 1) {
      EXPECT_LT(errorOf(image), 4.0e-3) << input.width << "x" << input.height;
    }
  }
}

TEST_P(Upsampling, ThePlanFollowsTheRatio) {
  FormulaSource source(testDevice(), {40, 20}, {});
  Resolver native = resolver(source, {40, 20});
  Resolver twice = resolver(source, {80, 40});
  const RepriseSamplePlan at_one = native.context().plan(3);
  const RepriseSamplePlan at_two = twice.context().plan(3);
  EXPECT_EQ(at_one.mip_bias, 0.0f);
  EXPECT_NEAR(at_two.mip_bias, -1.0f, 1.0e-6f);
  EXPECT_EQ(at_two.period, 4 * at_one.period);
  // Of a frame below the maximum.
  EXPECT_EQ(twice.context().plan(3, {40, 20}, {40, 20}).period, at_one.period);
  EXPECT_NEAR(native.context().plan(3, {20, 10}, {40, 20}).mip_bias, -1.0f, 1.0e-6f);
  double mean[2] = {};
  for (uint32_t i = 0; i < at_two.period; ++i) {
    const RepriseSamplePlan plan = twice.context().plan(i);
    for (int axis = 0; axis < 2; ++axis) mean[axis] += plan.jitter_px[axis];
  }
  EXPECT_NEAR(mean[0] / at_two.period, 0.0, 1.0e-5);
  EXPECT_NEAR(mean[1] / at_two.period, 0.0, 1.0e-5);
}

TEST_P(Upsampling, AnOutputBelowTheInputIsRefused) {
  FormulaSource source(testDevice(), {40, 20}, {});
  EXPECT_THROW(resolver(source, {39, 20}), std::exception);
  Resolver r = resolver(source, {80, 40});
  EXPECT_THROW(r.context().plan(0, {40, 20}, {40, 19}), std::exception);
  EXPECT_THROW(r.context().plan(0, {41, 20}, {80, 40}), std::exception);
}

std::vector<std::string> upsamplingTechniques() {
  std::vector<std::string> names;
  for (const std::string& name : everyTechnique()) {
    const uint32_t flags = parseTechnique(name).library->flags;
    if ((flags & REPRISE_TECHNIQUE_UPSAMPLES) != 0) names.push_back(name);
  }
  return names;
}

INSTANTIATE_TEST_SUITE_P(All, Upsampling, testing::ValuesIn(upsamplingTechniques()),
                         [](const auto& test) {
                           std::string name = test.param;
                           for (char& c : name) {
                             if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
                           }
                           return name;
                         });

}  // namespace
}  // namespace reprise::lab
