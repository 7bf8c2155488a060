// SPDX-License-Identifier: MIT
#include "equations/filters.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

namespace reprise::eq {
namespace {

struct Filter {
  std::string name;
  std::function<float(float)> at;
  float support;  // 0 from here on; for the Gaussians: below `beyond`
  float beyond;
  float integral;  // over the whole line
  bool tiles;      // copies at whole pixels sum to a constant
};

// Integrals by hand: Blackman-Harris window its constant term times the width; Gaussians
// sigma sqrt(2 pi); Lanczos by quadrature in double, apart.
std::vector<Filter> filters() {
  return {
      {"box", [](float x) { return boxFilter(x, 0.5f); }, 0.5f, 0.0f, 1.0f, true},
      {"tent", [](float x) { return tentFilter(x, 1.0f); }, 1.0f, 0.0f, 1.0f, true},
      {"mitchell", mitchellFilter, 2.0f, 0.0f, 1.0f, true},
      {"blackman-harris fit", blackmanHarrisFilter, 2.7f, 6e-8f, 1.171270f, false},
      {"blackman-harris window", [](float x) { return blackmanHarrisWindow(x, 3.3f); }, 1.65f, 0.0f,
       0.35875f * 3.3f, false},
      {"gaussian", [](float x) { return gaussianFilter(x, 0.4737f); }, 2.8f, 6e-8f,
       0.4737f * 2.50662827f, false},
      {"lanczos-2", [](float x) { return lanczosFilter(x, 2.0f); }, 2.0f, 0.0f, 1.009790f, false},
      {"lanczos-3", [](float x) { return lanczosFilter(x, 3.0f); }, 3.0f, 0.0f, 0.997055f, false},
  };
}

TEST(Filters, ZeroPastTheirSupport) {
  for (const Filter& f : filters()) {
    for (float x = f.support; x < 6.0f; x += 0.01f) {
      ASSERT_LE(std::fabs(f.at(x)), f.beyond) << f.name << " at " << x;
      ASSERT_LE(std::fabs(f.at(-x - 1e-4f)), f.beyond) << f.name << " at " << -x;
    }
  }
}

TEST(Filters, EvenAndLargestAtTheCentre) {
  for (const Filter& f : filters()) {
    for (float x = 0.013f; x < 3.5f; x += 0.017f) {
      ASSERT_NEAR(f.at(x), f.at(-x), 1e-6f) << f.name << " at " << x;
      ASSERT_LE(f.at(x), f.at(0.0f)) << f.name << " at " << x;
    }
  }
}

TEST(Filters, IntegralMatchesQuadrature) {
  for (const Filter& f : filters()) {
    double sum = 0.0;
    const int steps = 120000;
    for (int i = 0; i < steps; ++i)
      sum += f.at(-6.0f + 12.0f * (static_cast<float>(i) + 0.5f) / steps);
    EXPECT_NEAR(sum * 12.0 / steps, f.integral, 2e-4) << f.name;
  }
}

TEST(Filters, CopiesAtWholePixelsSumToOneWhereTheyShould) {
  for (const Filter& f : filters()) {
    float lowest = 10.0f, highest = -10.0f;
    for (float shift = 0.0f; shift < 1.0f; shift += 0.01f) {
      float sum = 0.0f;
      for (int i = -4; i <= 4; ++i) sum += f.at(static_cast<float>(i) - shift);
      lowest = min(lowest, sum);
      highest = max(highest, sum);
    }
    if (f.tiles) {
      EXPECT_NEAR(lowest, 1.0f, 1e-5f) << f.name;
      EXPECT_NEAR(highest, 1.0f, 1e-5f) << f.name;
    } else {
      // The others are used normalized; a Gaussian ripples by 4 exp(-2 (pi sigma)^2), 5 %.
      EXPECT_LT((highest - lowest) / highest, 0.06f) << f.name;
    }
  }
}

TEST(Filters, ValuesByHand) {
  EXPECT_NEAR(mitchellFilter(0.0f), 8.0f / 9.0f, 1e-6f);
  EXPECT_NEAR(mitchellFilter(1.0f), 1.0f / 18.0f, 1e-6f);
  EXPECT_NEAR(mitchellFilter(1.5f), -5.0f / 144.0f, 2e-6f);
  EXPECT_NEAR(lanczosFilter(0.5f, 2.0f), 0.573159f, 1e-5f);  // 4 sqrt 2 / pi^2
  EXPECT_NEAR(lanczosFilter(1.0f, 3.0f), 0.0f, 1e-6f);
  EXPECT_NEAR(lanczosHalfWeights(0.5f).x, 0.607927f, 1e-5f);  // 6 / pi^2
  for (int i = 0; i <= 64; ++i) {
    const float f = static_cast<float>(i) / 64.0f;
    const vec3 w = lanczosHalfWeights(f);
    EXPECT_NEAR(w.x, lanczosFilter(f, 3.0f), 1e-4f) << f;
    EXPECT_NEAR(w.y, lanczosFilter(1.0f + f, 3.0f), 1e-4f) << f;
    EXPECT_NEAR(w.z, lanczosFilter(2.0f + f, 3.0f), 1e-4f) << f;
    const vec3 right = lanczosHalfWeights(1.0f - f);
    EXPECT_NEAR(w.x + w.y + w.z + right.x + right.y + right.z, 1.0f, 0.01f) << f;
  }
  EXPECT_NEAR(blackmanHarrisWindow(0.0f, 3.3f), 1.0f, 1e-6f);
  EXPECT_NEAR(gaussianFilter(0.5f, 0.5f), 0.606531f, 1e-6f);
}

TEST(Filters, TheFitOfBlackmanHarrisIsClose) {
  // Three parts in a hundred: a fit, not the same function.
  for (float x = 0.0f; x < 1.65f; x += 0.01f) {
    EXPECT_NEAR(blackmanHarrisFilter(x), blackmanHarrisWindow(x, 3.3f), 0.03f) << x;
  }
}

TEST(CubicWeights, CatmullRomAtTheMiddle) {
  const vec4 w = cubicWeights(0.5f, 0.5f);
  EXPECT_FLOAT_EQ(w.x, -0.0625f);
  EXPECT_FLOAT_EQ(w.y, 0.5625f);
  EXPECT_FLOAT_EQ(w.z, 0.5625f);
  EXPECT_FLOAT_EQ(w.w, -0.0625f);
}

TEST(CubicWeights, SumToOneInterpolateAndAreSymmetric) {
  for (const float c : {0.0f, 0.3f, 0.5f, 1.0f}) {
    for (float f = 0.0f; f <= 1.0f; f += 0.0625f) {
      const vec4 w = cubicWeights(f, c);
      EXPECT_NEAR(w.x + w.y + w.z + w.w, 1.0f, 1e-6f);
      const vec4 mirrored = cubicWeights(1.0f - f, c);
      EXPECT_NEAR(w.x, mirrored.w, 1e-6f);
      EXPECT_NEAR(w.y, mirrored.z, 1e-6f);
    }
    EXPECT_EQ(cubicWeights(0.0f, c).y, 1.0f);
  }
}

TEST(CubicWeights, CatmullRomReproducesRampsAndParabolas) {
  for (float f = 0.0f; f < 1.0f; f += 0.05f) {
    const vec4 w = cubicWeights(f, 0.5f);
    EXPECT_NEAR(-w.x + w.z + 2.0f * w.w, f, 1e-6f);
    EXPECT_NEAR(w.x + w.z + 4.0f * w.w, f * f, 1e-6f);
  }
}

TEST(CubicWeights, MergedFetchesEqualTheFourTexels) {
  const float texels[] = {0.3f, 2.0f, -1.0f, 5.0f};
  for (float f = 0.0f; f < 1.0f; f += 0.05f) {
    const vec4 w = cubicWeights(f, 0.5f);
    const vec3 merged = mergedCubicWeights(w);
    const float offset = mergedCubicOffset(w);
    ASSERT_GE(offset, 0.0f);
    ASSERT_LE(offset, 1.0f);
    const float inner = mix(texels[1], texels[2], offset);
    EXPECT_NEAR(merged.x * texels[0] + merged.y * inner + merged.z * texels[3],
                w.x * texels[0] + w.y * texels[1] + w.z * texels[2] + w.w * texels[3], 1e-5f);
  }
}

TEST(CubicWeights, FiveFetchesKeepAtLeast63Of64) {
  float least = 1.0f;
  for (float fy = 0.0f; fy <= 1.0f; fy += 0.03125f) {
    for (float fx = 0.0f; fx <= 1.0f; fx += 0.03125f) {
      const vec3 x = mergedCubicWeights(cubicWeights(fx, 0.5f));
      const vec3 y = mergedCubicWeights(cubicWeights(fy, 0.5f));
      const float kept = fiveTapWeight(x, y);
      EXPECT_NEAR(kept, x.y * y.y + (x.x + x.z) * y.y + x.y * (y.x + y.z), 1e-6f);
      least = min(least, kept);
    }
  }
  EXPECT_NEAR(least, 63.0f / 64.0f, 1e-6f);
}

}  // namespace
}  // namespace reprise::eq
