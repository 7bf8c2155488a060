// SPDX-License-Identifier: MIT
#include "equations/sharpen.h"

#include <gtest/gtest.h>

#include "equations/hash.h"

namespace reprise::eq {
namespace {

TEST(Sharpen, ByHand) {
  // Neighbours 0.4 .. 0.6: to black 0.4 / 2.4 = 1/6, to white 0.4 / -2.4 = -1/6.
  EXPECT_NEAR(sharpenLobe(0.4f, 0.6f), -1.0f / 6.0f, 1e-6f);
  // (-1/6 * 2 + 0.7) / (1 - 4/6) = 1.1.
  const vec3 result = sharpened(vec3(0.4f), vec3(0.6f), vec3(0.7f), vec3(0.4f), vec3(0.6f), 1.0f);
  EXPECT_NEAR(result.x, 1.1f, 1e-4f);
}

TEST(Sharpen, NothingAtStrengthZeroAndOnFlatColour) {
  const vec3 same = sharpened(vec3(0.1f), vec3(0.9f), vec3(0.3f), vec3(0.2f), vec3(0.8f), 0.0f);
  EXPECT_FLOAT_EQ(same.y, 0.3f);
  for (const float level : {0.0f, 0.3f, 0.999f, 1.0f}) {
    const vec3 c(level);
    EXPECT_NEAR(sharpened(c, c, c, c, c, 1.0f).x, level, 2e-6f) << level;
  }
}

TEST(Sharpen, TheLimitKeepsTheDivisorAwayFromZero) {
  EXPECT_FLOAT_EQ(kSharpenLimit, 0.1875f);
  for (uint32_t i = 0; i < 2000; ++i) {
    const auto level = [&](uint32_t k) { return vec3(unitFloat(hashPixel(i, k, 2))); };
    const vec3 r = sharpened(level(0), level(1), level(2), level(3), level(4), 1.0f);
    ASSERT_TRUE(std::isfinite(r.x));
    // Bounded by the neighbours' part at the strongest lobe, divisor 1/4.
    ASSERT_GE(r.x, -3.0f);
    ASSERT_LE(r.x, 4.0f);
  }
}

TEST(Sharpen, ACentreWithinItsNeighboursStaysInRange) {
  // The lobe is bounded so that a centre between the extremes of its neighbours stays in [0, 1].
  for (uint32_t i = 0; i < 2000; ++i) {
    float n[4], low = 1.0f, high = 0.0f;
    for (uint32_t k = 0; k < 4; ++k) {
      n[k] = unitFloat(hashPixel(i, k, 3));
      low = min(low, n[k]);
      high = max(high, n[k]);
    }
    const vec3 centre(mix(low, high, unitFloat(hashPixel(i, 7, 3))));
    const vec3 r = sharpened(vec3(n[0]), vec3(n[1]), centre, vec3(n[2]), vec3(n[3]), 1.0f);
    ASSERT_GE(r.x, -1e-5f) << i;
    ASSERT_LE(r.x, 1.0f + 1e-5f) << i;
  }
}

TEST(Sharpen, AnEdgeGainsContrast) {
  const vec3 dark(0.3f), light(0.7f);
  // The light side of a vertical edge.
  EXPECT_GT(sharpened(light, dark, light, light, light, 1.0f).x, 0.7f);
  EXPECT_LT(sharpened(dark, dark, dark, light, dark, 1.0f).x, 0.3f);
}

TEST(Sharpen, NoiseIsSpared) {
  EXPECT_FLOAT_EQ(sharpenNoiseFactor(0.2f, 0.2f, 0.8f, 0.2f, 0.2f), 0.5f);
  EXPECT_FLOAT_EQ(sharpenNoiseFactor(0.2f, 0.8f, 0.5f, 0.8f, 0.2f), 1.0f);
  EXPECT_FLOAT_EQ(sharpenNoiseFactor(0.5f, 0.5f, 0.5f, 0.5f, 0.5f), 1.0f);
}

}  // namespace
}  // namespace reprise::eq
