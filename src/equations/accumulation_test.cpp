// SPDX-License-Identifier: MIT
#include "equations/accumulation.h"

#include <gtest/gtest.h>

namespace reprise::eq {
namespace {

TEST(Accumulation, EffectiveSamplesOfTheSurvey) {
  // Yang, Liu, Salvi 2020: alpha 0.1 has 2.2 samples after 5 frames, 5.1 after 10, 9.8 after
  // 15, 19.
  EXPECT_NEAR(effectiveSamples(0.1f, 5.0f), 2.2f, 0.05f);
  EXPECT_NEAR(effectiveSamples(0.1f, 10.0f), 5.1f, 0.05f);
  EXPECT_NEAR(effectiveSamples(0.1f, 15.0f), 9.8f, 0.05f);
  EXPECT_NEAR(effectiveSamples(0.1f, 500.0f), 19.0f, 1e-3f);
  EXPECT_NEAR(steadyEffectiveSamples(0.1f), 19.0f, 1e-4f);
  EXPECT_NEAR(effectiveSamples(0.1f, 1.0f), 1.0f, 1e-6f);
}

TEST(Accumulation, EffectiveSamplesAreTheReciprocalSumOfSquaredWeights) {
  for (const float alpha : {0.04f, 0.1f, 0.5f, 0.9f}) {
    float samples = 1.0f;
    double sum_of_squares = 1.0;
    for (int n = 2; n < 40; ++n) {
      samples = nextEffectiveSamples(samples, alpha);
      sum_of_squares = sum_of_squares * (1.0 - alpha) * (1.0 - alpha) + alpha * alpha;
      EXPECT_NEAR(samples, 1.0 / sum_of_squares, 1e-4 / sum_of_squares);
      EXPECT_NEAR(effectiveSamples(alpha, static_cast<float>(n)), 1.0 / sum_of_squares,
                  1e-4 / sum_of_squares);
    }
  }
}

TEST(Accumulation, RunningMeanCountsOneSampleAFrame) {
  float samples = 1.0f, confidence = 0.0f, mean = 4.0f;
  for (int n = 1; n < 60; ++n) {
    const float alpha = runningMeanAlpha(static_cast<float>(n), 0.0f);
    samples = nextEffectiveSamples(samples, alpha);
    EXPECT_NEAR(samples, static_cast<float>(n) + 1.0f, 1e-3f);
    confidence = nextConfidence(confidence);
    EXPECT_NEAR(1.0f - confidence, alpha, 1e-5f) << n;
    mean = mix(mean, n % 2 == 0 ? 4.0f : 2.0f, alpha);
  }
  EXPECT_NEAR(mean, 3.0f, 1e-5f);
  EXPECT_FLOAT_EQ(runningMeanAlpha(9.0f, 0.25f), 0.25f);
  EXPECT_FLOAT_EQ(runningMeanAlpha(1.0f, 0.25f), 0.5f);
}

TEST(Accumulation, ContrastFeedbackSpansInsidesWeights) {
  // 0.12 and 0.03 over 0.06.
  EXPECT_FLOAT_EQ(contrastFeedback(0.5f, 0.5f), 0.5f);
  EXPECT_FLOAT_EQ(contrastFeedback(1.0f, 0.0f), 2.0f);
  // Half as bright: w = 1/2, w^2 = 1/4: 2 - 1.5 / 4.
  EXPECT_FLOAT_EQ(contrastFeedback(0.4f, 0.8f), 1.625f);
  // In the dark the difference counts against 0.2: w = 1 - 0.05.
  EXPECT_NEAR(contrastFeedback(0.01f, 0.0f), 2.0f - 1.5f * 0.95f * 0.95f, 1e-6f);
}

TEST(Accumulation, BoundsFeedbackIsLeastAtTheBoundsAndFullInTheMiddle) {
  EXPECT_FLOAT_EQ(boundsFeedback(0.0f, 0.0f, 1.0f), 0.2f);
  EXPECT_FLOAT_EQ(boundsFeedback(1.0f, 0.0f, 1.0f), 0.2f);
  EXPECT_FLOAT_EQ(boundsFeedback(0.5f, 0.0f, 1.0f), 1.0f);
  EXPECT_NEAR(boundsFeedback(0.125f, 0.0f, 1.0f), 0.6f, 1e-6f);
  EXPECT_FLOAT_EQ(boundsFeedback(-3.0f, 0.0f, 1.0f), 0.2f);
  EXPECT_TRUE(std::isfinite(boundsFeedback(0.3f, 0.3f, 0.3f)));
}

TEST(Accumulation, ChangeFeedback) {
  EXPECT_FLOAT_EQ(changeFeedback(0.7f, 0.7f), 1.0f);
  EXPECT_NEAR(changeFeedback(1.0f, 0.5f), (1.0f - 0.5f / 1.001f) * (1.0f - 0.5f / 1.001f), 1e-6f);
  EXPECT_FLOAT_EQ(changeFeedback(0.0f, 0.0f), 1.0f);
}

TEST(Accumulation, SpeedFactor) {
  EXPECT_EQ(speedFactor(0.0f, 64.0f), 1.0f);
  EXPECT_EQ(speedFactor(16.0f, 64.0f), 0.75f);
  EXPECT_EQ(speedFactor(100.0f, 64.0f), 0.0f);
}

TEST(Accumulation, FrameRateAlphaForgetsAlikeAtAnyRate) {
  EXPECT_NEAR(frameRateAlpha(0.1f, 0.1f), 0.632121f, 1e-6f);
  // Two frames of half the time keep what one frame keeps.
  const float slow = 1.0f - frameRateAlpha(1.0f / 30.0f, 0.2f);
  const float fast = 1.0f - frameRateAlpha(1.0f / 60.0f, 0.2f);
  EXPECT_NEAR(fast * fast, slow, 1e-6f);
}

}  // namespace
}  // namespace reprise::eq
