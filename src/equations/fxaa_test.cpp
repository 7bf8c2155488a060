// SPDX-License-Identifier: MIT
#include "equations/fxaa.h"

#include <gtest/gtest.h>

namespace reprise::eq {
namespace {

TEST(Fxaa, ContrastCountsRelativeToTheBrightestAndAboveTheDark) {
  // The published defaults: 0.166 and 0.0833.
  EXPECT_TRUE(fxaaIsEdge(0.17f, 1.0f, 0.166f, 0.0833f));
  EXPECT_FALSE(fxaaIsEdge(0.16f, 1.0f, 0.166f, 0.0833f));
  EXPECT_TRUE(fxaaIsEdge(0.09f, 0.4f, 0.166f, 0.0833f));
  EXPECT_FALSE(fxaaIsEdge(0.05f, 0.1f, 0.166f, 0.0833f));
}

TEST(Fxaa, BendOfAStepIsAcrossIt) {
  // Bright above, dark from the middle row down: lines down the columns bend, rows do not.
  const vec3 column(1.0f, 0.0f, 0.0f);
  EXPECT_FLOAT_EQ(fxaaBend(column, column, column), 4.0f);
  EXPECT_FLOAT_EQ(fxaaBend(vec3(1.0f), vec3(0.0f), vec3(0.0f)), 0.0f);
  EXPECT_FLOAT_EQ(fxaaBend(vec3(0.1f, 0.2f, 0.5f), vec3(0.0f), vec3(0.0f)), 0.2f);
}

TEST(Fxaa, SubpixelShiftIsFullForALonePixel) {
  EXPECT_FLOAT_EQ(fxaaSubpixelShift(0.0f, 0.0f, 1.0f, 1.0f, 0.75f), 0.75f);
  EXPECT_FLOAT_EQ(fxaaSubpixelShift(4.0f, 4.0f, 1.0f, 1.0f, 0.75f), 0.0f);
  // Half out: c = 1/2, smoothed 1/2, squared 1/4.
  EXPECT_FLOAT_EQ(fxaaSubpixelShift(2.0f, 2.0f, 1.0f, 1.0f, 1.0f), 0.25f);
}

TEST(Fxaa, SpanShiftFallsFromTheEndToTheMiddle) {
  EXPECT_FLOAT_EQ(fxaaSpanShift(0.0f, 8.0f), 0.5f);
  EXPECT_FLOAT_EQ(fxaaSpanShift(1.0f, 7.0f), 0.375f);
  EXPECT_FLOAT_EQ(fxaaSpanShift(7.0f, 1.0f), 0.375f);
  EXPECT_FLOAT_EQ(fxaaSpanShift(4.0f, 4.0f), 0.0f);
}

}  // namespace
}  // namespace reprise::eq
