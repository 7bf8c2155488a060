// SPDX-License-Identifier: MIT
#include "equations/evidence.h"

#include <gtest/gtest.h>

#include <random>

namespace reprise::eq {
namespace {

TEST(Evidence, VarianceOfAnExponentialMeanIsTheSumOfItsSquaredWeights) {
  EXPECT_FLOAT_EQ(exponentialMeanVariance(1.0f), 1.0f);
  EXPECT_FLOAT_EQ(exponentialMeanVariance(0.5f), 1.0f / 3.0f);
  for (const float alpha : {0.05f, 0.3f, 0.7f}) {
    double sum = 0.0;
    double weight = alpha;
    for (int n = 0; n < 2000; ++n, weight *= 1.0 - alpha) sum += weight * weight;
    EXPECT_NEAR(exponentialMeanVariance(alpha), sum, 1e-6);
  }
}

TEST(Evidence, BelievesNothingUpToTheDoubtAndAllOfWhatIsFarBeyond) {
  EXPECT_EQ(believedShare(1.0f, 0.5f, 2.0f), 0.0f);
  EXPECT_EQ(believedShare(0.5f, 1.0f, 1.0f), 0.0f);
  EXPECT_FLOAT_EQ(believedShare(1.0f, 0.25f, 2.0f), 0.5f);
  EXPECT_FLOAT_EQ(believedShare(4.0f, 0.25f, 2.0f), 0.875f);
  EXPECT_EQ(believedShare(3.0f, 0.0f, 2.0f), 1.0f);
  EXPECT_EQ(believedShare(0.0f, 0.1f, 2.0f), 0.0f);
}

// Stein 1956, James and Stein 1961: in three dimensions and more, a noisy mean shrunk by a doubt of
// (d - 2) / d of the whole noise is nearer to the truth than itself, wherever the truth is.
TEST(Evidence, AShrunkMeanIsNearerToTheTruthThanTheMean) {
  std::mt19937 generator(7);
  std::normal_distribution<float> noise(0.0f, 1.0f);
  for (const float truth : {0.0f, 0.5f, 1.0f, 3.0f}) {
    double raw = 0.0;
    double shrunk = 0.0;
    for (int n = 0; n < 20000; ++n) {
      const vec3 seen(truth + noise(generator), noise(generator), noise(generator));
      const vec3 guess = seen * believedShare(dot(seen, seen), 3.0f, 1.0f / 3.0f);
      const vec3 there(truth, 0.0f, 0.0f);
      raw += dot(seen - there, seen - there);
      shrunk += dot(guess - there, guess - there);
    }
    EXPECT_LT(shrunk, raw) << truth;
  }
}

}  // namespace
}  // namespace reprise::eq
