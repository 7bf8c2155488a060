// SPDX-License-Identifier: MIT
#include "techniques/amortized/blur_moments.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <vector>

#include "equations/amortized.h"
#include "techniques/amortized/blur_table.h"

namespace reprise::amortized {
namespace {

constexpr double kVariance = 0.2575 * 0.2575;

double second(uint32_t buffers, double vx, double vy, double alpha) {
  const BufferLayout layout = bufferLayout(buffers);
  const double variance = static_cast<double>(layout.sigma_px) * layout.sigma_px;
  return PanningGathers(layout, vx, vy).moments(alpha, variance).second;
}

// Computed by an implementation that shares nothing with this one.
TEST(BlurMoments, KnownValues) {
  for (const double alpha : {0.05, 0.3, 1.0}) {
    EXPECT_NEAR(second(4, 0.0, 0.0, alpha), 0.0663, 5.0e-5);
    EXPECT_NEAR(second(4, 0.5, 0.0, alpha), 0.0663, 5.0e-5);
  }
  EXPECT_NEAR(second(4, 0.25, 0.0, 0.2), 0.234, 5.0e-4);
  EXPECT_NEAR(second(4, 0.125, 0.3, 0.4), 0.171, 5.0e-4);
}

TEST(BlurMoments, OneBufferIsTheClosedForm) {
  const auto variance = static_cast<float>(kPixelSigma_px * kPixelSigma_px);
  for (const float alpha : {0.05f, 0.2f, 0.7f}) {
    for (const float vx : {0.0f, 0.11f, 0.5f, 0.93f}) {
      for (const float vy : {0.0f, 0.37f}) {
        const float expected = eq::bilinearBlurVariance(variance, alpha, vx, vy);
        EXPECT_NEAR(second(1, vx, vy, alpha), expected, 2.0e-4 * expected + 1.0e-5);
      }
    }
  }
}

// A sample set tracked one by one, as the paper does: position in the buffer's frame -> weight.
using Samples = std::map<std::pair<long, long>, double>;
constexpr double kGrid = 1 << 20;

TEST(BlurMoments, AgreeWithTrackedSamples) {
  const BufferLayout layout = bufferLayout(4);
  const double alpha = 0.5;
  for (const auto& [vx, vy] : {std::pair{0.25, 0.0}, {0.3, 0.2}, {0.7, 0.45}}) {
    std::array<Samples, 4> buffers;
    std::array<int, 4> written = {-1, -1, -1, -1};
    double sum = 0.0;
    uint32_t counted = 0;
    constexpr int kFrames = 3 * kPeriod;  // 0.5^24 of the start is left
    for (int n = 0; n < kFrames; ++n) {
      const uint32_t target = bufferOfFrame(4, static_cast<uint64_t>(n));
      const eq::vec2 to = eq::quadrantOffset(layout.quadrants[target]);
      Samples gathered;
      double weights = 0.0;
      for (uint32_t k = 0; k < 4; ++k) {
        if (written[k] < 0) continue;
        const eq::vec2 from = eq::quadrantOffset(layout.quadrants[k]);
        const double px = to.x - from.x + (n - written[k]) * vx;
        const double py = to.y - from.y + (n - written[k]) * vy;
        for (int texel = 0; texel < 4; ++texel) {
          const double dx = std::floor(px) + (texel & 1) - px;
          const double dy = std::floor(py) + (texel >> 1) - py;
          const double w =
              std::max(1.0 - std::abs(dx) / 0.5, 0.0) * std::max(1.0 - std::abs(dy) / 0.5, 0.0);
          if (w <= 0.0) continue;
          weights += w;
          for (const auto& [at, share] : buffers[k]) {
            if (share < 1.0e-9) continue;
            gathered[{at.first + std::lround(dx * kGrid), at.second + std::lround(dy * kGrid)}] +=
                w * share;
          }
        }
      }
      Samples next;
      const double keep = weights > 1.0e-6 ? 1.0 - alpha : 0.0;
      next[{0, 0}] = 1.0 - keep;
      for (const auto& [at, share] : gathered) next[at] += keep * share / weights;
      buffers[target] = std::move(next);
      written[target] = n;
      if (n < kFrames - static_cast<int>(kPeriod)) continue;
      for (const Samples& samples : buffers) {
        for (const auto& [at, share] : samples) {
          const double x = static_cast<double>(at.first) / kGrid;
          const double y = static_cast<double>(at.second) / kGrid;
          sum += share * 0.5 * (x * x + y * y);
        }
        ++counted;
      }
    }
    // New samples lie at the origin here: their own variance is what the recurrence has more.
    EXPECT_NEAR(sum / counted + kVariance, second(4, vx, vy, alpha), 2.0e-3) << vx << " " << vy;
  }
}

TEST(BlurTable, TheThresholdHolds) {
  for (const double threshold : {0.15, 0.5, 1.5}) {
    const BlurSlice slice = blurSlice(4, threshold);
    for (uint32_t y = 0; y < kTableSize; y += 7) {
      for (uint32_t x = 0; x < kTableSize; x += 5) {
        const double alpha = slice[y * kTableSize + x] / 255.0;
        EXPECT_LT(second(4, x / 63.0, y / 63.0, alpha), threshold * 1.03 + 0.01);
      }
    }
  }
}

TEST(BlurTable, MoreBlurAllowsLessWeight) {
  for (const uint32_t buffers : {1u, 2u, 4u}) {
    const BlurSlice tight = blurSlice(buffers, 0.3);
    const BlurSlice wide = blurSlice(buffers, 2.0);
    for (uint32_t i = 0; i < tight.size(); ++i) ASSERT_GE(tight[i], wide[i]);
    EXPECT_EQ(tight[0], 1);  // no motion, no blur
  }
}

TEST(BufferLayout, TheOrderWritesEveryBufferWithinSevenFrames) {
  for (const uint32_t buffers : {1u, 2u, 4u}) {
    std::vector<uint64_t> last(buffers, 0);
    std::vector<uint32_t> writes(buffers, 0);
    for (uint64_t n = 0; n < 4 * kPeriod; ++n) {
      const uint32_t buffer = bufferOfFrame(buffers, n);
      ASSERT_LT(buffer, buffers);
      if (writes[buffer] > 0) {
        EXPECT_LE(n - last[buffer], 7u);
      }
      last[buffer] = n;
      ++writes[buffer];
    }
    for (const uint32_t count : writes) EXPECT_EQ(count, 4 * kPeriod / buffers);
  }
}

}  // namespace
}  // namespace reprise::amortized
