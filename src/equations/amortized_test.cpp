// SPDX-License-Identifier: MIT
#include "equations/amortized.h"

#include <gtest/gtest.h>

namespace reprise::eq {
namespace {

TEST(Amortized, BilinearBlur) {
  // (11) by hand: 0.0663 + 9 * (0.25 * 0.75) / 2.
  EXPECT_NEAR(bilinearBlurVariance(0.0663f, 0.1f, 0.25f, 0.0f), 0.91005f, 1.0e-5f);
  EXPECT_FLOAT_EQ(bilinearBlurVariance(0.2f, 0.3f, 0.0f, 0.0f), 0.2f);
}

TEST(Amortized, TentWeightsOfHalfRadiusTakeOneTexel) {
  const vec4 w = tentWeights(0.2f, 0.1f, 0.5f);
  EXPECT_NEAR(w.x, 0.6f * 0.8f, 1.0e-6f);
  EXPECT_EQ(w.y, 0.0f);
  EXPECT_EQ(w.z, 0.0f);
  EXPECT_EQ(w.w, 0.0f);
}

TEST(Amortized, TentOfOnePixelIsBilinear) {
  const vec4 w = tentWeights(0.25f, 0.5f, 1.0f);
  EXPECT_NEAR(w.x, 0.375f, 1.0e-6f);
  EXPECT_NEAR(w.y, 0.125f, 1.0e-6f);
  EXPECT_NEAR(w.z, 0.375f, 1.0e-6f);
  EXPECT_NEAR(w.w, 0.125f, 1.0e-6f);
}

// One bilinear fetch at the fraction gives the weighted mean, x and y not exchanged.
TEST(Amortized, TheFractionGivesTheWeightedMean) {
  const vec4 texels(3.0f, 5.0f, 11.0f, 2.0f);
  const vec4 w = tentWeights(0.3f, 0.6f, 0.8f);
  const vec2 f = bilinearFraction(w);
  EXPECT_GT(std::abs(f.x - f.y), 0.1f);
  const float fetched = mix(mix(texels.x, texels.y, f.x), mix(texels.z, texels.w, f.x), f.y);
  EXPECT_NEAR(fetched, dot(texels, w) / (w.x + w.y + w.z + w.w), 1.0e-5f);
}

TEST(Amortized, TheTentGrowsWithMinification) {
  EXPECT_FLOAT_EQ(tentGrowth(vec2(1.0f, 0.0f), vec2(0.0f, 1.0f)), 1.0f);
  EXPECT_FLOAT_EQ(tentGrowth(vec2(1.5f, 0.0f), vec2(0.0f, 1.2f)), 1.5f);
  EXPECT_FLOAT_EQ(tentGrowth(vec2(0.5f, 0.0f), vec2(0.0f, 0.5f)), 1.0f);
  EXPECT_FLOAT_EQ(tentGrowth(vec2(1.0f, 0.2f), vec2(0.6f, 1.0f)), 1.6f);
}

TEST(Amortized, SamplesGrowByOneAtRest) {
  float count = 1.0f;
  for (int t = 2; t < 200; ++t) {
    count = varianceReduction(count, 1.0f / (count + 1.0f));
    ASSERT_NEAR(count, static_cast<float>(t), 1.0e-3f * static_cast<float>(t));
  }
  EXPECT_FLOAT_EQ(varianceReduction(100.0f, 1.0f), 1.0f);
  // A constant weight settles at (2 - beta) / beta.
  for (int t = 0; t < 1000; ++t) count = varianceReduction(count, 0.2f);
  EXPECT_NEAR(count, 9.0f, 1.0e-3f);
}

TEST(Amortized, ResidualBound) {
  EXPECT_EQ(residualBound(0.05f, 0.1f), 0.0f);
  EXPECT_EQ(residualBound(0.0f, 0.1f), 0.0f);
  EXPECT_FLOAT_EQ(residualBound(-0.4f, 0.1f), 0.75f);
}

}  // namespace
}  // namespace reprise::eq
