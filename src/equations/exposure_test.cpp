// SPDX-License-Identifier: MIT
#include "equations/exposure.h"

#include <gtest/gtest.h>

namespace reprise::eq {
namespace {

TEST(Exposure, MeanOfLogarithmsIsTheGeometricMean) {
  const float mean = 0.5f * (logLuminance(vec3(0.01f)) + logLuminance(vec3(1.0f)));
  EXPECT_NEAR(exp(mean), 0.1005f, 1e-5f);  // sqrt(0.0101 * 1.0001)
  EXPECT_NEAR(exp(logLuminance(vec3(0.0f))), 1e-4f, 1e-9f);
}

TEST(Exposure, AnAdaptedEyeSeesMiddleGrey) {
  EXPECT_FLOAT_EQ(0.5f * exposureFor(0.5f), 0.18f);
}

TEST(Exposure, AdaptationIsOneExponentialWhateverTheFrameRate) {
  // 1 - 1/e of the way after one time constant, in 1 step or in 24.
  EXPECT_NEAR(adaptedLuminance(1.0f, 3.0f, 0.4f, 0.4f), 3.0f - 2.0f * 0.36788f, 1e-5f);
  float adapted = 1.0f;
  for (int i = 0; i < 24; ++i) adapted = adaptedLuminance(adapted, 3.0f, 0.4f / 24.0f, 0.4f);
  EXPECT_NEAR(adapted, 3.0f - 2.0f * 0.36788f, 1e-5f);
}

}  // namespace
}  // namespace reprise::eq
