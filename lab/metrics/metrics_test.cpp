// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <stdexcept>

#include "lab/metrics/display_space.h"
#include "lab/metrics/magma.h"
#include "lab/metrics/psnr.h"
#include "lab/metrics/sharpness.h"
#include "lab/metrics/ssim.h"
#include "lab/metrics/workers.h"

namespace reprise::lab {
namespace {

FloatImage greyImage(uint32_t width, uint32_t height,
                     const std::function<double(int, int)>& value) {
  FloatImage image(width, height, 1);
  for (uint32_t y = 0; y < height; ++y) {
    for (uint32_t x = 0; x < width; ++x) {
      *image.at(x, y) = static_cast<float>(value(static_cast<int>(x), static_cast<int>(y)));
    }
  }
  return image;
}

TEST(DisplaySpace, ValuesByHand) {
  FloatImage linear(2, 1, 4);
  linear.texels = {1.0f,
                   0.0f,
                   3.0f,
                   7.0f,
                   -2.0f,
                   std::numeric_limits<float>::quiet_NaN(),
                   std::numeric_limits<float>::infinity(),
                   0.0f};
  const FloatImage display = displayImage(linear);
  ASSERT_EQ(display.channels, 3u);
  EXPECT_NEAR(display.texels[0], std::pow(0.5, 1.0 / 2.2), 1e-6);
  EXPECT_EQ(display.texels[1], 0.0f);
  EXPECT_NEAR(display.texels[2], std::pow(0.75, 1.0 / 2.2), 1e-6);
  EXPECT_EQ(display.texels[3], 0.0f);
  EXPECT_EQ(display.texels[4], 0.0f);
  EXPECT_EQ(display.texels[5], 1.0f);
  EXPECT_FLOAT_EQ(tonemappedImage(linear).texels[2], 0.75f);
}

TEST(Psnr, ValuesByHand) {
  FloatImage a(2, 2, 3);
  FloatImage b = a;
  EXPECT_EQ(psnrDb(meanSquaredError(a, b)), kMaxPsnr_db);
  for (float& v : b.texels) v = 0.1f;
  EXPECT_NEAR(psnrDb(meanSquaredError(a, b)), 20.0, 1e-5);
  b = a;
  b.texels[0] = 1.0f;
  EXPECT_NEAR(psnrDb(meanSquaredError(a, b)), 10.0 * std::log10(12.0), 1e-6);
}

TEST(Psnr, TemporalErrorSeesFlickerAndNoBias) {
  const FloatImage reference(4, 4, 3);
  FloatImage biased = reference;
  for (float& v : biased.texels) v = 0.3f;
  EXPECT_EQ(temporalSquaredError(reference, reference, biased, biased), 0.0);
  EXPECT_NEAR(temporalSquaredError(reference, reference, biased, reference), 0.09, 1e-7);
  // What changes in the reference too is no flicker.
  EXPECT_NEAR(temporalSquaredError(biased, reference, biased, reference), 0.0, 1e-12);
}

// The pairs of ssim_oracle.py.
std::vector<std::pair<FloatImage, FloatImage>> ssimPairs() {
  const auto image = [](const std::function<double(int, int)>& f) { return greyImage(64, 48, f); };
  return {
      {image([](int x, int) { return x / 63.0; }), image([](int x, int) { return (x / 8) / 7.0; })},
      {image([](int x, int y) { return ((7 * x + 13 * y) % 256) / 255.0; }),
       image([](int x, int y) { return ((7 * (x + 1) + 13 * y) % 256) / 255.0; })},
      {image([](int x, int) { return x >= 32 ? 1.0 : 0.0; }),
       image([](int x, int) { return x >= 33 ? 0.9 : 0.1; })}};
}

TEST(Ssim, FiguresOfScikitImage) {
  const double expected[] = {0.601189690, 0.825789673, 0.462880524};
  const auto pairs = ssimPairs();
  for (size_t i = 0; i < pairs.size(); ++i) {
    EXPECT_NEAR(ssim(pairs[i].first, pairs[i].second), expected[i], 1e-6) << i;
  }
}

TEST(Ssim, ScikitImageItself) {
  std::FILE* oracle = popen("/usr/bin/python3 " REPRISE_SSIM_ORACLE " 2>/dev/null", "r");
  ASSERT_NE(oracle, nullptr);
  double figures[3] = {};
  const int read = std::fscanf(oracle, "%lf %lf %lf", &figures[0], &figures[1], &figures[2]);
  pclose(oracle);
  if (read != 3) GTEST_SKIP() << "scikit-image (python3-skimage) is not installed";
  const auto pairs = ssimPairs();
  for (size_t i = 0; i < pairs.size(); ++i) {
    EXPECT_NEAR(ssim(pairs[i].first, pairs[i].second), figures[i], 1e-6) << i;
  }
}

TEST(Ssim, EqualIsOneAndTooSmallIsNoNumber) {
  const FloatImage image = greyImage(20, 11, [](int x, int y) { return 0.01 * (x * y % 50); });
  EXPECT_NEAR(ssim(image, image), 1.0, 1e-12);
  EXPECT_TRUE(std::isnan(ssim(FloatImage(10, 40, 1), FloatImage(10, 40, 1))));
}

TEST(Sharpness, BlurLowersAndContrastRaises) {
  const FloatImage bars = greyImage(32, 8, [](int x, int) { return x / 2 % 2; });
  const FloatImage soft = greyImage(32, 8, [](int x, int) { return 0.25 + 0.5 * (x / 2 % 2); });
  EXPECT_NEAR(sharpness(bars, bars), 1.0, 1e-9);
  EXPECT_NEAR(sharpness(bars, soft), 0.5, 1e-6);
  EXPECT_NEAR(sharpness(soft, bars), 2.0, 1e-6);
  EXPECT_EQ(sharpness(FloatImage(4, 4, 1), bars), 1.0);
}

TEST(Magma, EndsAndMiddleOfTheTable) {
  FloatImage error(3, 1, 1);
  error.texels = {0.0f, 128.0f / 255.0f, 1.0f};
  const FloatImage image = magmaImage(error);
  const float expected[] = {0.001f, 0.000f, 0.014f, 0.716f, 0.215f, 0.475f, 0.987f, 0.991f, 0.750f};
  for (size_t i = 0; i < 9; ++i) EXPECT_NEAR(image.texels[i], expected[i], 0.025f) << i;
}

TEST(Workers, EachIndexOnceAndExceptionsComeBack) {
  std::vector<std::atomic<int>> seen(1000);
  onWorkers(seen.size(), [&](size_t i) { ++seen[i]; });
  for (const auto& count : seen) ASSERT_EQ(count, 1);
  EXPECT_THROW(onWorkers(50,
                         [](size_t i) {
                           if (i == 17) throw std::runtime_error("17");
                         }),
               std::runtime_error);
}

}  // namespace
}  // namespace reprise::lab
