// SPDX-License-Identifier: MIT
#include "equations/color_space.h"

#include <gtest/gtest.h>

namespace reprise::eq {
namespace {

const vec3 kColors[] = {{0.0f, 0.0f, 0.0f},     {1.0f, 1.0f, 1.0f},
                        {0.2f, 0.7f, 0.1f},     {12.0f, 0.03f, 4.0f},
                        {1.0e-3f, 0.0f, 2e-4f}, {900.0f, 1000.0f, 20.0f},
                        {0.0f, 0.0f, 5.0f},     {65504.0f, 65504.0f, 65504.0f}};

void expectNear(vec3 a, vec3 b, float relative) {
  const float scale = max(max(abs(b.x), abs(b.y)), max(abs(b.z), 1e-6f));
  EXPECT_NEAR(a.x, b.x, relative * scale);
  EXPECT_NEAR(a.y, b.y, relative * scale);
  EXPECT_NEAR(a.z, b.z, relative * scale);
}

TEST(ColorSpace, LumasOfWhiteAreOne) {
  EXPECT_NEAR(luma601(vec3(1.0f)), 1.0f, 1e-6f);
  EXPECT_NEAR(luma709(vec3(1.0f)), 1.0f, 1e-6f);
  EXPECT_NEAR(lumaYCoCg(vec3(1.0f)), 1.0f, 1e-6f);
  EXPECT_NEAR(luma601(vec3(0.0f, 1.0f, 0.0f)), 0.587f, 1e-6f);
  EXPECT_NEAR(luma709(vec3(0.0f, 0.0f, 1.0f)), 0.0722f, 1e-6f);
}

TEST(ColorSpace, YCoCgByHand) {
  const vec3 y = yCoCgFromRgb(vec3(1.0f, 0.5f, 0.25f));
  EXPECT_FLOAT_EQ(y.x, 0.5625f);
  EXPECT_FLOAT_EQ(y.y, 0.375f);
  EXPECT_FLOAT_EQ(y.z, -0.0625f);
}

TEST(ColorSpace, EveryPairIsInverse) {
  for (const vec3 c : kColors) {
    expectNear(rgbFromYCoCg(yCoCgFromRgb(c)), c, 1e-6f);
    // Compression leaves a large colour few bits: 1 - luma keeps 2^-24 of 1 / luma.
    const float relative = 1e-6f + 2.5e-7f * max(max(c.x, c.y), c.z);
    expectNear(expandByLuma(compressByLuma(c)), c, relative);
    expectNear(expandByMax(compressByMax(c)), c, relative);
  }
  // The logarithm's floor swallows what is darker than e^-10.
  expectNear(linearFromLog(logFromLinear(kColors[3])), kColors[3], 1e-5f);
  EXPECT_EQ(linearFromLog(logFromLinear(0.0f)), 0.0f);
  EXPECT_EQ(logFromLinear(0.0f), -10.0f);
  EXPECT_EQ(logFromLinear(-1.0f), -10.0f);
  EXPECT_EQ(logFromLinear(1e-9f), -10.0f);
}

TEST(ColorSpace, CompressionByHand) {
  const vec3 by_max = compressByMax(vec3(3.0f, 1.0f, 0.0f));
  EXPECT_FLOAT_EQ(by_max.x, 0.75f);
  EXPECT_FLOAT_EQ(by_max.y, 0.25f);
  const vec3 by_luma = compressByLuma(vec3(0.0f, 2.0f, 0.0f));  // luma 1
  EXPECT_FLOAT_EQ(by_luma.y, 1.0f);
}

TEST(ColorSpace, ExpansionStaysFinite) {
  for (const float x : {1.0f, 1.5f, 100.0f}) {
    EXPECT_TRUE(std::isfinite(expandByLuma(vec3(x)).x));
    EXPECT_TRUE(std::isfinite(expandByMax(vec3(x)).x));
    EXPECT_GT(expandByLuma(vec3(x)).x, 0.0f);
  }
}

TEST(ColorSpace, Display) {
  EXPECT_EQ(displayFromLinear(0.0f), 0.0f);
  EXPECT_EQ(displayFromLinear(-1.0f), 0.0f);
  EXPECT_NEAR(displayFromLinear(1.0f), 0.729740f, 1e-6f);  // 2^(-1 / 2.2)
  EXPECT_NEAR(displayFromLinear(vec3(1.0f, 0.0f, 3.0f)).z, 0.8774243f, 1e-6f);
  EXPECT_NEAR(perceptualLuma(vec3(1.0f)), 0.729740f, 1e-6f);
  EXPECT_NEAR(perceptualLuma(vec3(0.0f, 1.0f, 0.0f)), 0.587f * 0.729740f, 1e-6f);
  EXPECT_NEAR(linearFromDisplay(0.729740f), 1.0f, 1e-5f);
  EXPECT_EQ(linearFromDisplay(-1.0f), 0.0f);
  for (const float x : {0.0f, 0.003f, 0.4f, 7.0f, 300.0f}) {
    EXPECT_NEAR(linearFromDisplay(displayFromLinear(x)), x, 1e-5f * (1.0f + x * x)) << x;
  }
  EXPECT_TRUE(std::isfinite(linearFromDisplay(2.0f)));
}

}  // namespace
}  // namespace reprise::eq
