// SPDX-License-Identifier: MIT
#include "lab/post/post_chain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "equations/color_space.h"
#include "equations/exposure.h"
#include "lab/post/show_sequence.h"

namespace reprise::lab {
namespace {

FloatImage grey(uint32_t width, uint32_t height, float value) {
  FloatImage image(width, height, 4);
  std::fill(image.texels.begin(), image.texels.end(), value);
  return image;
}

class PostChainTest : public testing::Test {
 protected:
  std::vector<FloatImage> shown(std::vector<FloatImage> pictures, const PostSettings& settings = {},
                                double frame_rate = 60.0) {
    std::vector<FloatImage*> all;
    for (FloatImage& picture : pictures) all.push_back(&picture);
    showSequence(
        device_, all, frame_rate, [](size_t) { return false; }, settings, nullptr);
    EXPECT_TRUE(device_.validationMessages().empty());
    return pictures;
  }

  Device device_{{.validation = Device::validationAvailable()}};
};

TEST_F(PostChainTest, AnEvenPictureIsMiddleGreyAtAnyExtent) {
  for (const auto& [width, height] : {std::pair{1u, 1u}, {2u, 1u}, {7u, 5u}, {65u, 33u}}) {
    for (const float value : {0.001f, 3.0f, 2000.0f}) {
      const FloatImage image = shown({grey(width, height, value)})[0];
      for (size_t i = 0; i < image.texelCount(); ++i) {
        ASSERT_NEAR(image.texels[4 * i], eq::kMiddleGrey * value / (value + 1e-4f), 2e-3f)
            << width << "x" << height << " of " << value;
      }
    }
  }
}

TEST_F(PostChainTest, TheEyeFollowsAStepAsTheEquationSays) {
  constexpr double kFrameRate = 30.0;
  std::vector<FloatImage> pictures(6, grey(16, 16, 4.0f));
  pictures[0] = grey(16, 16, 1.0f);
  const std::vector<FloatImage> result = shown(pictures, {}, kFrameRate);
  float adapted = 1.0f;
  for (size_t i = 0; i < pictures.size(); ++i) {
    if (i > 0) adapted = eq::adaptedLuminance(adapted, 4.0f, 1.0f / 30.0f, 0.4f);
    const float expected = pictures[i].texels[0] * eq::exposureFor(adapted);
    EXPECT_NEAR(result[i].texels[0], expected, 2e-3f * expected) << i;
  }
  EXPECT_GT(result[1].texels[0], 2.0f * result[0].texels[0]);
}

TEST_F(PostChainTest, BloomSpreadsLightAndAddsNone) {
  // Far from the borders, where clamping would count texels twice.
  FloatImage picture = grey(256, 256, 0.0f);
  for (uint32_t c = 0; c < 4; ++c) picture.at(128, 130)[c] = 1.0f;
  const PostSettings with{.bloom = 0.5f, .bloom_spread = 0.3f};
  const FloatImage without_bloom = shown({picture}, {.bloom = 0.0f})[0];
  const FloatImage bloom = shown({picture}, with)[0];
  double sum = 0.0, sum_without = 0.0;
  for (size_t i = 0; i < bloom.texelCount(); ++i) {
    sum += bloom.texels[4 * i];
    sum_without += without_bloom.texels[4 * i];
  }
  EXPECT_NEAR(sum, sum_without, 0.01 * sum_without);
  EXPECT_LT(bloom.at(128, 130)[0], 0.7f * without_bloom.at(128, 130)[0]);
  EXPECT_EQ(without_bloom.at(140, 130)[0], 0.0f);
  EXPECT_GT(bloom.at(140, 130)[0], 0.0f);
  // Centred: a level that is shifted would shine to one side. The pixel lies off the centre of its
  // coarse texel, by half a texel of the finest level at most.
  double moment = 0.0;
  for (uint32_t x = 0; x < 256; ++x) {
    for (uint32_t y = 0; y < 256; ++y) moment += (x - 128.0) * bloom.at(x, y)[0];
  }
  EXPECT_LT(std::abs(moment / sum), 0.6);
}

TEST_F(PostChainTest, NoNumberIsBlackAndStaysAlone) {
  FloatImage picture = grey(64, 64, 0.5f);
  picture.at(32, 32)[0] = std::numeric_limits<float>::quiet_NaN();
  picture.at(33, 32)[1] = std::numeric_limits<float>::infinity();
  const FloatImage clean = shown({grey(64, 64, 0.5f)})[0];
  const FloatImage image = shown({picture})[0];
  for (size_t i = 0; i < image.texels.size(); ++i) ASSERT_TRUE(std::isfinite(image.texels[i]));
  EXPECT_LT(image.at(32, 32)[0], 0.2f * clean.at(32, 32)[0]);
  EXPECT_NEAR(image.at(10, 10)[0], clean.at(10, 10)[0], 1e-3f);
}

TEST_F(PostChainTest, AResetForgets) {
  std::vector<FloatImage> pictures = {grey(8, 8, 100.0f), grey(8, 8, 1.0f)};
  std::vector<FloatImage*> all = {&pictures[0], &pictures[1]};
  showSequence(
      device_, all, 60.0, [](size_t i) { return i == 1; }, {}, nullptr);
  EXPECT_NEAR(pictures[1].texels[0], eq::kMiddleGrey, 2e-3f);
}

}  // namespace
}  // namespace reprise::lab
