// SPDX-License-Identifier: MIT
#include "lab/paper/blur_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace reprise::lab {
namespace {

constexpr uint32_t kScale = 4;
constexpr uint32_t kMargin_px = 12;

// Waves of several lengths in both directions, the shortest a little above two px.
double scene(double x, double y) {
  return 0.5 + 0.2 * std::sin(0.2 * x) + 0.2 * std::sin(0.23 * y) +
         0.15 * std::sin(0.9 * x + 0.003 * x * x) + 0.1 * std::sin(2.6 * x) +
         0.12 * std::sin(1.1 * y + 0.004 * y * y) + 0.1 * std::sin(2.4 * y);
}

FloatImage fineImage() {
  FloatImage fine(84 * kScale, 76 * kScale, 1);
  for (uint32_t y = 0; y < fine.height; ++y) {
    for (uint32_t x = 0; x < fine.width; ++x) {
      *fine.at(x, y) =
          static_cast<float>(scene((x + 0.5) / double{kScale}, (y + 0.5) / double{kScale}));
    }
  }
  return fine;
}

// Gathers sample by sample, sharing nothing with the code under test: a Gaussian drawn at random.
FloatImage sampledImage(double sigma_px, double shift_x_px, double shift_y_px) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0.0, sigma_px);
  FloatImage image(84, 76, 1);
  constexpr int kSamples = 600;
  for (uint32_t y = 0; y < image.height; ++y) {
    for (uint32_t x = 0; x < image.width; ++x) {
      double sum = 0.0;
      for (int i = 0; i < kSamples; ++i) {
        sum += scene(x + 0.5 + shift_x_px + normal(random), y + 0.5 + shift_y_px + normal(random));
      }
      *image.at(x, y) = static_cast<float>(sum / kSamples);
    }
  }
  return image;
}

TEST(BlurFit, KnownGaussiansAreRecovered) {
  const BlurFit fit(fineImage(), kScale, kMargin_px);
  for (const double sigma_px : {0.4737, 0.8, 1.6}) {
    const BlurMatch match = fit.bestSigma(sampledImage(sigma_px, 0.0, 0.0));
    EXPECT_NEAR(match.sigma_px, sigma_px, 0.02) << sigma_px;
    EXPECT_LT(match.mean_squared_error, 1.0e-3);
  }
}

// Samples in two places are the mean of both; far apart, no Gaussian looks like them.
TEST(BlurFit, SpreadMixesDisplacements) {
  const BlurFit fit(fineImage(), kScale, kMargin_px);
  const FloatImage mixed = fit.spread(0.4, {{-0.5, 0.25}, {1.5, 0.75}}, {{0.2, 1.0}});
  const FloatImage left = fit.blurred(0.4, -0.5, 0.2);
  const FloatImage right = fit.blurred(0.4, 1.5, 0.2);
  for (size_t i = 0; i < mixed.texels.size(); ++i) {
    ASSERT_NEAR(mixed.texels[i], 0.25f * left.texels[i] + 0.75f * right.texels[i], 1.0e-5f);
  }
  EXPECT_NEAR(fit.bestSigma(fit.blurred(0.7, 0.0, 0.0)).sigma_px, 0.7, 0.005);
}

TEST(BlurFit, DisplacementIsToldFromBlur) {
  const BlurFit fit(fineImage(), kScale, kMargin_px);
  const BlurMatch match = fit.bestShift(sampledImage(0.6, 0.3, -0.15));
  EXPECT_NEAR(match.sigma_px, 0.6, 0.02);
  EXPECT_NEAR(match.shift_x_px, 0.3, 0.02);
  EXPECT_NEAR(match.shift_y_px, -0.15, 0.02);
}

TEST(BlurFit, SharperThanAnyGaussianIsZero) {
  const FloatImage fine = fineImage();
  FloatImage image(84, 76, 1);
  for (uint32_t y = 0; y < image.height; ++y) {
    for (uint32_t x = 0; x < image.width; ++x) {
      *image.at(x, y) = static_cast<float>(scene(x + 0.5, y + 0.5));
    }
  }
  EXPECT_LT(BlurFit(fine, kScale, kMargin_px).bestSigma(image).sigma_px, 0.2);
}

TEST(BlurFit, MarginMustHoldTheKernel) {
  EXPECT_THROW(BlurFit(fineImage(), kScale, 5), std::invalid_argument);
  EXPECT_THROW(BlurFit(FloatImage(10, 10, 1), 1, 12), std::invalid_argument);
}

}  // namespace
}  // namespace reprise::lab
