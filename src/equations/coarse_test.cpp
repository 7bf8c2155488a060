// SPDX-License-Identifier: MIT
#include "equations/coarse.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <set>

#include "equations/coarse_jitter.h"
#include "equations/filters.h"
#include "equations/jitter.h"

namespace reprise::eq {
namespace {

TEST(Coarse, CentresOfCoarsePixels) {
  const float of_two[] = {1, 1, 3, 3, 5};
  const float shifted[] = {0, 2, 2, 4, 4};
  for (int px = 0; px < 5; ++px) {
    EXPECT_EQ(coarseCentre(px, 2, 0), of_two[px]);
    EXPECT_EQ(coarseCentre(px, 2, 1), shifted[px]);
    EXPECT_EQ(coarseCentre(px, 1, 0), static_cast<float>(px) + 0.5f);
  }
  EXPECT_EQ(coarseCentre(2, 3, 1), 2.5f);
  EXPECT_EQ(coarseCentre(0, 4, 3), 1.0f);
}

TEST(Coarse, WeightedMeansAreMeans) {
  // Weights 1, 3, 2 of 4, 8, 2: 32 / 6.
  float mean = 0.0f;
  float held = 0.0f;
  for (const auto& [weight, value] : {std::pair(1.0f, 4.0f), {3.0f, 8.0f}, {2.0f, 2.0f}}) {
    mean += weightedMeanAlpha(weight, held) * (value - mean);
    held += weight;
  }
  EXPECT_NEAR(mean, 32.0f / 6.0f, 1e-5f);
  EXPECT_NEAR(weightedMeanAlpha(0.4f, (1.0f / 0.1f - 1.0f) * 0.4f), 0.1f, 1e-6f);
  EXPECT_EQ(weightedMeanAlpha(0.3f, 0.0f), 1.0f);
}

TEST(Coarse, SilhouettesAreDifferencesOfMotion) {
  EXPECT_FALSE(isSilhouette(vec2(4, 0), vec2(5, 0), 25.0f, 0.3f));
  EXPECT_TRUE(isSilhouette(vec2(3, 0), vec2(5, 0), 25.0f, 0.3f));
  EXPECT_FALSE(isSilhouette(vec2(0, 0), vec2(0, 0), 0.0f, 0.3f));
}

TEST(Coarse, ChangeIsWhatErrorDoesNotExplain) {
  EXPECT_EQ(changeCertainty(0.1f, 0.1f), 0.0f);
  EXPECT_EQ(changeCertainty(-0.05f, 0.1f), 0.0f);
  EXPECT_EQ(changeCertainty(0.0f, 0.0f), 0.0f);
  EXPECT_NEAR(changeCertainty(0.2f, 0.1f), 0.75f, 1e-6f);
  EXPECT_NEAR(changeCertainty(-1.0f, 0.1f), 0.99f, 1e-6f);

  EXPECT_NEAR(changeGain(0.5f, -0.2f, 8.0f), 0.6f, 1e-6f);
  EXPECT_NEAR(changeGain(0.5f, 0.25f, 8.0f), 1.5f, 1e-6f);
  EXPECT_EQ(changeGain(0.5f, 0.0f, 8.0f), 1.0f);
  EXPECT_EQ(changeGain(1.0e-6f, 0.0f, 8.0f), 1.0f);
  EXPECT_EQ(changeGain(0.01f, 1.0f, 8.0f), 8.0f);
  EXPECT_EQ(changeGain(1.0f, -1.0f, 8.0f), 0.125f);
}

// Shortest distance between any two points on a torus of side `side`.
float closest(const std::vector<vec2>& points, float side) {
  float best = side;
  for (size_t i = 0; i < points.size(); ++i) {
    for (size_t k = 0; k < i; ++k) {
      const auto along = [&](float a, float b) {
        const float d = std::fmod(std::abs(a - b), side);
        return std::min(d, side - d);
      };
      best = std::min(best,
                      std::hypot(along(points[i].x, points[k].x), along(points[i].y, points[k].y)));
    }
  }
  return best;
}

TEST(CoarseJitter, SplitsIntoGridAndProjection) {
  for (const uint32_t length : {1u, 2u, 7u, 16u, 64u}) {
    const std::vector<vec2>& points = coarseBlueNoise(length);
    ASSERT_EQ(points.size(), length);
    for (const vec2 point : points) {
      EXPECT_TRUE(point.x >= 0.0f && point.x < 2.0f && point.y >= 0.0f && point.y < 2.0f);
      const CoarseOffset split = splitOffset(point);
      for (const float jitter_px : {split.jitter_px.x, split.jitter_px.y}) {
        EXPECT_LE(std::abs(jitter_px), 0.5f);
      }
      // Where pixel (0, 0)'s coarse pixel then shades, on the torus of two pixels.
      const float x = coarseCentre(0, 2, split.origin_px[0]) - split.jitter_px.x;
      const float y = coarseCentre(0, 2, split.origin_px[1]) - split.jitter_px.y;
      EXPECT_NEAR(std::fmod(x + 4.0f, 2.0f), point.x, 1e-5f);
      EXPECT_NEAR(std::fmod(y + 4.0f, 2.0f), point.y, 1e-5f);
    }
  }
}

TEST(CoarseJitter, SpreadsShadingOverFourPixelsAndVisibilityOverOne) {
  constexpr uint32_t kLength = 32;
  const std::vector<vec2>& points = coarseBlueNoise(kLength);
  std::vector<vec2> scaled;
  std::vector<vec2> sub_pixel;
  for (uint32_t i = 0; i < kLength; ++i) {
    const vec2 offset = haltonOffset(i);
    scaled.push_back(vec2(1.0f + 2.0f * offset.x, 1.0f + 2.0f * offset.y));
    sub_pixel.push_back(vec2(1.0f + offset.x, 1.0f + offset.y));
  }
  // 32 points on a torus of side 2 keep at most 2 sqrt(2 / (sqrt 3 32)) = 0.38, on one of side 1
  // half of that. One set cannot reach both; half of each is what random points (0.03) do not.
  EXPECT_GT(closest(points, 2.0f), 0.19f);
  EXPECT_GT(closest(points, 1.0f), 0.095f);
  EXPECT_GT(closest(points, 2.0f), closest(scaled, 2.0f));
  EXPECT_GT(closest(points, 2.0f), closest(sub_pixel, 2.0f));
  // Visibility lies half a pixel beside, in every pixel alike: twice Halton doubles points there.
  EXPECT_GT(closest(points, 1.0f), 1.5f * closest(scaled, 1.0f));
}

// Mean squared error of an exponential mean of the samples (alpha 0.2) over images that are
// periodic on the torus of side `side`, their power falling with the square of frequency.
double errorOverTime(const std::vector<vec2>& points, double side) {
  double error = 0.0;
  for (int y = -2; y <= 2; ++y) {
    for (int x = 0; x <= 2; ++x) {
      if (x == 0 && y <= 0) continue;
      std::complex<double> mean;
      std::complex<double> all;
      for (const vec2 p : points) {
        const double turns = (x * static_cast<double>(p.x) + y * static_cast<double>(p.y)) / side;
        all += std::polar(1.0 / static_cast<double>(points.size()), 6.283185307179586 * turns);
      }
      double sum = 0.0;
      for (size_t frame = 0; frame < 3 * points.size(); ++frame) {
        const vec2 p = points[frame % points.size()];
        const double turns = (x * static_cast<double>(p.x) + y * static_cast<double>(p.y)) / side;
        mean += 0.2 * (std::polar(1.0, 6.283185307179586 * turns) - mean);
        if (frame >= points.size()) sum += std::norm(mean - all);
      }
      error += sum / (x * x + y * y);
    }
  }
  return error / (2.0 * static_cast<double>(points.size()));
}

std::vector<vec2> jitters(const std::vector<vec2>& points) {
  std::vector<vec2> jitters_px;
  for (const vec2 p : points) jitters_px.push_back(splitOffset(p).jitter_px);
  return jitters_px;
}

// An order by shading alone lets the visibility of frames in succession fall together, which is
// worse than random.
TEST(CoarseJitter, FramesInSuccessionSpreadInBothDomains) {
  const std::vector<vec2>& points = coarseBlueNoise(32);
  std::vector<vec2> scaled;
  for (uint32_t i = 0; i < 32; ++i) {
    const vec2 offset = haltonOffset(i);
    scaled.push_back(vec2(1.0f + 2.0f * offset.x, 1.0f + 2.0f * offset.y));
  }
  EXPECT_LT(errorOverTime(jitters(points), 2.0), 0.8 * errorOverTime(jitters(scaled), 2.0));
  EXPECT_LT(errorOverTime(points, 2.0), errorOverTime(scaled, 2.0));
}

TEST(CoarseJitter, EveryQuadrantComesWithinFewFrames) {
  const std::vector<vec2>& points = coarseBlueNoise(32);
  for (size_t start = 0; start < points.size(); ++start) {
    std::set<int> quadrants;
    for (size_t i = 0; i < 8; ++i) {
      const vec2 p = points[(start + i) % points.size()];
      quadrants.insert(static_cast<int>(p.x) + 2 * static_cast<int>(p.y));
    }
    EXPECT_GE(quadrants.size(), 3u) << start;
  }
}

}  // namespace
}  // namespace reprise::eq
