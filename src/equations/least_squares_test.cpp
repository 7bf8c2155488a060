// SPDX-License-Identifier: MIT
#include "equations/least_squares.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "equations/hash.h"

namespace reprise::eq {
namespace {

constexpr float kLambda = 0.998f;
constexpr float kPrior = 1000.0f;

struct Sample {
  vec3 z;
  vec3 y;
};

// A feature that wanders, and a colour that is linear in it, plus noise.
Sample wandering(uint frame) {
  const auto t = static_cast<float>(frame);
  const auto noise = [&](uint k) { return unitFloat(hashPixel(frame, k, 5u)) - 0.5f; };
  const vec3 z(0.5f + 0.3f * std::sin(0.013f * t) + 0.05f * noise(0),
               0.4f + 0.2f * std::sin(0.029f * t + 1.0f) + 0.05f * noise(1),
               0.6f + 0.2f * std::cos(0.041f * t) + 0.05f * noise(2));
  const vec3 y(0.1f + 0.8f * z.x + 0.1f * z.y + 0.1f * noise(3),
               0.3f + 0.2f * z.x + 0.5f * z.z + 0.1f * noise(4),
               0.9f - 0.7f * z.y + 0.1f * noise(5));
  return {z, y};
}

// Solves A b = c for symmetric positive A, in double, by elimination with pivots.
using Vector = std::array<double, 4>;
using Matrix = std::array<Vector, 4>;
Vector solved(Matrix a, Vector c) {
  for (size_t i = 0; i < 4; ++i) {
    size_t pivot = i;
    for (size_t r = i + 1; r < 4; ++r) {
      if (std::abs(a[r][i]) > std::abs(a[pivot][i])) pivot = r;
    }
    std::swap(a[i], a[pivot]);
    std::swap(c[i], c[pivot]);
    for (size_t r = i + 1; r < 4; ++r) {
      const double f = a[r][i] / a[i][i];
      for (size_t k = i; k < 4; ++k) a[r][k] -= f * a[i][k];
      c[r] -= f * c[i];
    }
  }
  for (size_t i = 4; i-- > 0;) {
    for (size_t k = i + 1; k < 4; ++k) c[i] -= a[i][k] * c[k];
    c[i] /= a[i][i];
  }
  return c;
}

// The weighted least squares that the recursion solves, all at once: minimizes
// sum_t lambda^(n - t) (y_t - b^T x_t)^2 + lambda^n (b - b_0)^T (b - b_0) / prior.
class Batch {
 public:
  explicit Batch(vec3 first) {
    for (size_t i = 0; i < 4; ++i) a_[i][i] = 1.0 / kPrior;
    for (int c = 0; c < 3; ++c) right_[static_cast<size_t>(c)][0] = first[c] / double{kPrior};
  }
  void add(const Sample& s) {
    const double x[] = {1.0, s.z.x, s.z.y, s.z.z};
    const double lambda = kLambda;
    for (size_t i = 0; i < 4; ++i) {
      for (size_t k = 0; k < 4; ++k) a_[i][k] = lambda * a_[i][k] + x[i] * x[k];
      for (int c = 0; c < 3; ++c) {
        double& r = right_[static_cast<size_t>(c)][i];
        r = lambda * r + x[i] * s.y[c];
      }
    }
  }
  vec3 predicted(vec3 z) const {
    vec3 f;
    for (int c = 0; c < 3; ++c) {
      const Vector b = solved(a_, right_[static_cast<size_t>(c)]);
      f[c] = static_cast<float>(b[0] + b[1] * z.x + b[2] * z.y + b[3] * z.z);
    }
    return f;
  }
  // x^T P x, P the inverse of the weighted normal matrix.
  double variance(vec3 z) const {
    const Vector x{1.0, z.x, z.y, z.z};
    const Vector px = solved(a_, x);
    double sum = 0.0;
    for (size_t i = 0; i < 4; ++i) sum += x[i] * px[i];
    return sum;
  }

 private:
  Matrix a_{};
  std::array<Vector, 3> right_{};
};

TEST(LeastSquares, OneStepByHand) {
  // x = (1, 0.5, 0, 0), P = I: P x = x, lambda + x^T P x = 2.25 with lambda = 1.
  LinearModel m = constantModel(vec3(1.0f, 2.0f, 3.0f), 1.0f, 1.0f);
  m = updatedModel(m, vec3(0.5f, 0.0f, 0.0f), vec3(2.25f, 0.0f, -4.5f), 1.0f);
  EXPECT_FLOAT_EQ(m.intercept.x, 2.0f);
  EXPECT_FLOAT_EQ(m.intercept.y, 2.0f);
  EXPECT_FLOAT_EQ(m.intercept.z, 1.0f);
  EXPECT_FLOAT_EQ(m.slope_r.x, 0.5f);
  EXPECT_FLOAT_EQ(m.slope_b.x, -1.0f);
  EXPECT_FLOAT_EQ(m.level, 1.0f - 1.0f / 2.25f);
  EXPECT_FLOAT_EQ(m.cross.x, -0.5f / 2.25f);
  EXPECT_FLOAT_EQ(m.spread.x, 1.0f - 0.25f / 2.25f);
  EXPECT_FLOAT_EQ(m.spread.y, 1.0f);
  EXPECT_FLOAT_EQ(m.spread_cross.x, 0.0f);
}

TEST(LeastSquares, WithoutSlopesItIsTheRunningMean) {
  LinearModel m = constantModel(vec3(0.0f), kPrior, 0.0f);
  float sum = 0.0f;
  for (uint n = 1; n <= 100; ++n) {
    const auto y = static_cast<float>(n % 7);
    sum += y;
    m = updatedModel(m, vec3(0.3f), vec3(y) - predictedColor(m, vec3(0.3f)), 1.0f);
    EXPECT_NEAR(m.intercept.x, sum / static_cast<float>(n), 0.004f / static_cast<float>(n) + 1e-5f);
    EXPECT_NEAR(m.level, 1.0f / static_cast<float>(n), 2e-3f / static_cast<float>(n));
  }
}

TEST(LeastSquares, AnotherOriginIsTheSameModel) {
  LinearModel m = constantModel(vec3(0.5f), kPrior, kPrior);
  for (uint t = 0; t < 40; ++t) {
    const Sample s = wandering(t);
    m = updatedModel(m, s.z, s.y - predictedColor(m, s.z), kLambda);
  }
  const vec3 shift(0.4f, 0.3f, 0.6f);
  const vec3 z(0.55f, 0.35f, 0.5f);
  const LinearModel moved = shiftedModel(m, shift);
  EXPECT_NEAR(predictedColor(moved, z - shift).x, predictedColor(m, z).x, 1e-5f);
  EXPECT_NEAR(predictionVariance(moved, z - shift), predictionVariance(m, z), 2e-3f);
  const LinearModel back = shiftedModel(moved, vec3(0.0f) - shift);
  EXPECT_NEAR(back.intercept.y, m.intercept.y, 1e-5f);
  EXPECT_NEAR(back.level, m.level, 2e-3f);
}

TEST(LeastSquares, AnotherExposureIsTheSameModel) {
  LinearModel m = constantModel(vec3(0.5f), kPrior, kPrior);
  LinearModel brighter = exposedModel(m, 4.0f);
  for (uint t = 0; t < 40; ++t) {
    const Sample s = wandering(t);
    m = updatedModel(m, s.z, s.y - predictedColor(m, s.z), kLambda);
    brighter = updatedModel(brighter, s.z * 4.0f, s.y * 4.0f - predictedColor(brighter, s.z * 4.0f),
                            kLambda);
  }
  const vec3 z(0.5f, 0.4f, 0.6f);
  EXPECT_NEAR(predictedColor(brighter, z * 4.0f).x, 4.0f * predictedColor(m, z).x, 1e-4f);
  EXPECT_NEAR(predictedColor(exposedModel(m, 4.0f), z * 4.0f).x, 4.0f * predictedColor(m, z).x,
              1e-5f);
  EXPECT_NEAR(predictionVariance(exposedModel(m, 4.0f), z * 4.0f), predictionVariance(m, z), 1e-3f);
}

// 10,000 frames in single precision, about zero and about the feature, against the batch solution
// in double.
TEST(LeastSquares, TenThousandFramesEqualTheBatchSolution) {
  const vec3 first = wandering(0).y;
  Batch batch(first);
  LinearModel about_zero = constantModel(first, kPrior, kPrior);
  LinearModel about_feature = shiftedModel(about_zero, wandering(0).z);
  vec3 origin = wandering(0).z;
  for (uint t = 0; t < 10000; ++t) {
    const Sample s = wandering(t);
    batch.add(s);
    about_zero =
        boundedModel(updatedModel(about_zero, s.z, s.y - predictedColor(about_zero, s.z), kLambda),
                     kPrior, kPrior);
    about_feature = shiftedModel(about_feature, s.z - origin);
    origin = s.z;
    about_feature = boundedModel(
        updatedModel(about_feature, vec3(0.0f), s.y - about_feature.intercept, kLambda), 1e9f,
        kPrior);
    if (t % 500 != 499) continue;
    const vec3 expected = batch.predicted(s.z);
    const auto variance = static_cast<float>(batch.variance(s.z));
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(predictedColor(about_zero, s.z)[c], expected[c], 2e-4f) << t;
      EXPECT_NEAR(about_feature.intercept[c], expected[c], 2e-4f) << t;
    }
    EXPECT_NEAR(predictionVariance(about_zero, s.z), variance, 0.02f * variance) << t;
    EXPECT_NEAR(about_feature.level, variance, 0.02f * variance) << t;
  }
}

// What half storage does to it: every number rounded to 11 bits each frame.
float half(float v) {
  if (std::abs(v) < 6.2e-5f) return 0.0f;
  const float power = uintBitsToFloat(floatBitsToUint(std::abs(v)) & 0x7f800000u);
  return sign(v) * std::floor(std::abs(v) / (power / 1024.0f) + 0.5f) * (power / 1024.0f);
}
LinearModel halves(LinearModel m) {
  const auto each = [](vec3 v) { return vec3(half(v.x), half(v.y), half(v.z)); };
  return {each(m.intercept), each(m.slope_r), each(m.slope_g), each(m.slope_b),
          half(m.level),     each(m.cross),   each(m.spread),  each(m.spread_cross)};
}

TEST(LeastSquares, HalvesAboutTheFeatureStayCloseForTenThousandFrames) {
  const vec3 first = wandering(0).y;
  Batch batch(first);
  LinearModel m = shiftedModel(constantModel(first, kPrior, kPrior), wandering(0).z);
  vec3 origin = wandering(0).z;
  double sum = 0.0;
  for (uint t = 0; t < 10000; ++t) {
    const Sample s = wandering(t);
    batch.add(s);
    m = boundedModel(shiftedModel(m, s.z - origin), kPrior, kPrior);
    origin = s.z;
    m = halves(
        boundedModel(updatedModel(m, vec3(0.0f), s.y - m.intercept, kLambda), kPrior, kPrior));
    ASSERT_TRUE(std::isfinite(m.intercept.x) && std::isfinite(m.spread.x)) << t;
    if (t < 100) continue;
    const vec3 d = m.intercept - batch.predicted(s.z);
    sum += dot(d, d) / 3.0;
  }
  // The noise has a deviation of 0.029; the model's own, after its 500 samples, is about 0.003.
  EXPECT_LT(std::sqrt(sum / 9900.0), 0.01);
}

// Windup: the feature stands still, lambda < 1. Unbounded, P grows by 1.002 a frame and overflows.
TEST(LeastSquares, AFeatureThatBarelyVariesDoesNotWindUp) {
  for (const bool rounded : {false, true}) {
    LinearModel m = constantModel(vec3(0.5f), kPrior, kPrior);
    LinearModel unbounded = m;
    vec3 origin(0.5f);
    float last = 0.0f;
    for (uint t = 0; t < 10000; ++t) {
      const float wobble = 1e-3f * (unitFloat(hashPixel(t, 1u, 2u)) - 0.5f);
      const vec3 z = vec3(0.5f) + vec3(wobble, wobble, wobble);
      const float y = 0.5f + 0.2f * (unitFloat(hashPixel(t, 3u, 4u)) - 0.5f);
      m = boundedModel(shiftedModel(m, z - origin), kPrior, kPrior);
      unbounded = shiftedModel(unbounded, z - origin);
      origin = z;
      m = boundedModel(updatedModel(m, vec3(0.0f), vec3(y) - m.intercept, kLambda), kPrior, kPrior);
      unbounded = updatedModel(unbounded, vec3(0.0f), vec3(y) - unbounded.intercept, kLambda);
      if (rounded) m = halves(m);
      ASSERT_LE(m.spread.x, kPrior);
      ASSERT_GE(m.spread.x, 0.0f);
      ASSERT_GT(m.level, 0.0f);
      ASSERT_LE(std::abs(m.spread_cross.x), std::sqrt(m.spread.x * m.spread.y) * 1.002f);
      last = m.intercept.x;
      if (t > 2000) {
        ASSERT_NEAR(last, 0.5f, 0.1f) << t;
      }
    }
    EXPECT_FALSE(unbounded.spread.x <= 100.0f * kPrior);
  }
}

// P bounded about zero, where the prediction's variance is a small difference of large ones, is
// another P: it forgets what it knows of the feature's own place, and follows the noise.
TEST(LeastSquares, ModelsStoredAboutZeroAreBoundedAboutTheFeature) {
  constexpr float kForgetting = 0.95f;
  LinearModel about_feature = constantModel(vec3(0.5f), kPrior, kPrior);
  LinearModel stored_about_zero = shiftedModel(about_feature, vec3(-0.5f));
  LinearModel bounded_about_zero = stored_about_zero;
  vec3 origin(0.5f);
  double apart = 0.0;
  double apart_bounded_about_zero = 0.0;
  for (uint t = 0; t < 2000; ++t) {
    const float wobble = 1e-2f * (unitFloat(hashPixel(t, 1u, 2u)) - 0.5f);
    const vec3 z = vec3(0.5f) + vec3(wobble, -wobble, 0.5f * wobble);
    const vec3 y(0.5f + 0.2f * (unitFloat(hashPixel(t, 3u, 4u)) - 0.5f));
    const auto updated = [&](LinearModel m) {
      m = boundedModel(m, kPrior, kPrior);
      return boundedModel(updatedModel(m, vec3(0.0f), y - m.intercept, kForgetting), kPrior,
                          kPrior);
    };
    about_feature = updated(shiftedModel(about_feature, z - origin));
    stored_about_zero = shiftedModel(updated(shiftedModel(stored_about_zero, z)), vec3(0.0f) - z);
    const vec3 error = y - predictedColor(bounded_about_zero, z);
    bounded_about_zero =
        boundedModel(updatedModel(bounded_about_zero, z, error, kForgetting), kPrior, kPrior);
    origin = z;
    const auto from = [&](const LinearModel& m) {
      const double d = predictedColor(m, z).x - about_feature.intercept.x;
      return d * d;
    };
    apart += from(stored_about_zero);
    apart_bounded_about_zero += from(bounded_about_zero);
  }
  // The prediction's own deviation is about 0.01.
  EXPECT_LT(std::sqrt(apart / 2000.0), 1e-3);
  EXPECT_GT(std::sqrt(apart_bounded_about_zero / 2000.0), 5e-3);
}

TEST(LeastSquares, BoundsCutVariancesAndTheirCovariances) {
  LinearModel m = constantModel(vec3(0.0f), 4.0f, 16.0f);
  m.cross = vec3(4.0f, 0.0f, -100.0f);
  m.spread_cross = vec3(8.0f, 0.0f, 0.0f);
  const LinearModel b = boundedModel(m, 1.0f, 4.0f);
  EXPECT_FLOAT_EQ(b.level, 1.0f);
  EXPECT_FLOAT_EQ(b.spread.y, 4.0f);
  EXPECT_FLOAT_EQ(b.cross.x, 1.0f);   // halved by both
  EXPECT_FLOAT_EQ(b.cross.z, -2.0f);  // -25, cut to -sqrt(1 * 4)
  EXPECT_FLOAT_EQ(b.spread_cross.x, 2.0f);
  const LinearModel low = boundedModel(constantModel(vec3(0.0f), -1.0f, 0.0f), 1.0f, 1.0f);
  EXPECT_EQ(low.level, kLeastVariance);
}

TEST(LeastSquares, FeatureAlphaByHand) {
  // phi = 0.125 * 0.16 + 0.25 * 2 * 0.064 = 0.052, over 0.4 + 0.1.
  EXPECT_NEAR(featureAlpha(0.4f, 0.1f, 2.0f, 0.125f, 0.25f), 0.104f, 1e-6f);
  EXPECT_EQ(featureAlpha(0.0f, 0.0f, 8.0f, 0.125f, 0.25f), 0.0f);
}

}  // namespace
}  // namespace reprise::eq
