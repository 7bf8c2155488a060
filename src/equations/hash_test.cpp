// SPDX-License-Identifier: MIT
#include "equations/hash.h"

#include <gtest/gtest.h>

#include <set>

#include "equations/shading_offset.h"

namespace reprise::eq {
namespace {

// The same function in 64-bit arithmetic reduced by hand, so that a lost wrap-around shows.
uint32_t pcgByHand(uint64_t v) {
  const uint64_t kMask = 0xffffffffull;
  const uint64_t state = (v * 747796405ull + 2891336453ull) & kMask;
  const uint64_t word = (((state >> ((state >> 28) + 4)) ^ state) * 277803737ull) & kMask;
  return static_cast<uint32_t>((word >> 22) ^ word);
}

TEST(Hash, PcgWrapsAt32Bits) {
  for (const uint32_t v : {0u, 1u, 2u, 12345u, 0x7fffffffu, 0xffffffffu}) {
    EXPECT_EQ(hashPcg(v), pcgByHand(v)) << v;
  }
  EXPECT_EQ(hashPcg(0), 129708002u);  // worked out apart from this code
}

TEST(Hash, NeighbouringPixelsAndSeedsAreUnrelated) {
  std::set<uint32_t> seen;
  for (uint32_t y = 0; y < 32; ++y) {
    for (uint32_t x = 0; x < 32; ++x) {
      for (uint32_t seed = 0; seed < 4; ++seed) seen.insert(hashPixel(x, y, seed));
    }
  }
  // 4096 draws of 2^32: a repeat has odds of 1 in 500.
  EXPECT_EQ(seen.size(), 4096u);
}

TEST(Hash, UnitFloatStaysBelowOne) {
  EXPECT_EQ(unitFloat(0), 0.0f);
  EXPECT_EQ(unitFloat(0x80000000u), 0.5f);
  EXPECT_LT(unitFloat(0xffffffffu), 1.0f);
}

TEST(Hash, GaussianPairByHand) {
  // u = 1/2 (24 bits: 0x7fffff + 1), angle = pi/2: radius sqrt(2 ln 2).
  const vec2 g = gaussianPair(0x7fffff00u, 0x40000000u);
  EXPECT_NEAR(g.x, 0.0f, 1e-6f);
  EXPECT_NEAR(g.y, 1.17741002f, 1e-6f);
  EXPECT_TRUE(std::isfinite(gaussianPair(0u, 0u).x));
}

struct Moments {
  double mean_x = 0, mean_y = 0, var_x = 0, var_y = 0, covariance = 0, fourth = 0;
};

template <typename Draw>
Moments momentsOf(uint32_t side, Draw draw) {
  Moments m;
  const double n = static_cast<double>(side) * side;
  for (uint32_t y = 0; y < side; ++y) {
    for (uint32_t x = 0; x < side; ++x) {
      const vec2 v = draw(x, y);
      m.mean_x += v.x / n;
      m.mean_y += v.y / n;
      m.var_x += v.x * v.x / n;
      m.var_y += v.y * v.y / n;
      m.covariance += v.x * v.y / n;
      m.fourth += v.x * v.x * v.x * v.x / n;
    }
  }
  return m;
}

TEST(Hash, GaussianMoments) {
  const Moments m = momentsOf(512, [](uint32_t x, uint32_t y) {
    const uint32_t h = hashPixel(x, y, 9);
    return gaussianPair(h, hashPcg(h));
  });
  // Five standard errors of 2^18 draws: 1/512 for a mean, sqrt(2)/512, sqrt(96)/512.
  EXPECT_NEAR(m.mean_x, 0.0, 5.0 / 512);
  EXPECT_NEAR(m.mean_y, 0.0, 5.0 / 512);
  EXPECT_NEAR(m.var_x, 1.0, 5.0 * 1.42 / 512);
  EXPECT_NEAR(m.var_y, 1.0, 5.0 * 1.42 / 512);
  EXPECT_NEAR(m.covariance, 0.0, 5.0 / 512);
  EXPECT_NEAR(m.fourth, 3.0, 5.0 * 9.8 / 512);
}

TEST(ShadingOffset, QuadrantsInThePapersOrder) {
  const vec2 expected[] = {{-.25f, -.25f}, {-.25f, .25f}, {.25f, -.25f}, {.25f, .25f}};
  for (uint32_t k = 0; k < 4; ++k) {
    EXPECT_EQ(quadrantOffset(k).x, expected[k].x);
    EXPECT_EQ(quadrantOffset(k).y, expected[k].y);
    // No deviation: the centre itself.
    EXPECT_EQ(shadingOffset(3, 4, 5, 0.0f, k).x, expected[k].x);
  }
}

TEST(ShadingOffset, UpdateOrderIsThePapers) {
  const uint32_t order[] = {0, 1, 2, 3, 0, 2, 1, 3, 1, 0, 3, 2, 1, 3, 0, 2,
                            2, 3, 0, 1, 2, 0, 3, 1, 3, 2, 1, 0, 3, 1, 2, 0};
  for (uint32_t i = 0; i < 96; ++i) EXPECT_EQ(quadrantOfFrame(i), order[i % 32]) << i;
}

TEST(ShadingOffset, IsAGaussianAboutTheQuadrantsCentre) {
  const Moments m = momentsOf(256, [](uint32_t x, uint32_t y) {
    return shadingOffset(x, y, 3, kShadingOffsetSigma_px, 2) - quadrantOffset(2);
  });
  const double sigma = kShadingOffsetSigma_px;
  EXPECT_NEAR(m.mean_x, 0.0, 5 * sigma / 256);
  EXPECT_NEAR(m.mean_y, 0.0, 5 * sigma / 256);
  EXPECT_NEAR(m.var_x, sigma * sigma, 5 * 1.42 * sigma * sigma / 256);
  EXPECT_NEAR(m.var_y, sigma * sigma, 5 * 1.42 * sigma * sigma / 256);
  EXPECT_NEAR(m.covariance, 0.0, 5 * sigma * sigma / 256);
}

}  // namespace
}  // namespace reprise::eq
