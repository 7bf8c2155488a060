// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <set>
#include <utility>
#include <vector>

#include "equations/blue_noise.h"
#include "equations/hash.h"
#include "equations/jitter_sequence.h"

namespace reprise::eq {
namespace {

constexpr uint32_t kSequences[] = {kSequenceNone,  kSequenceHalton, kSequenceR2,
                                   kSequenceSobol, kSequenceNRooks, kSequenceRotatedGrid,
                                   kSequenceMsaa8, kSequenceHelix,  kSequenceBlueNoise};

TEST(Jitter, RadicalInverseOfBases2And3) {
  const float base_2[] = {1 / 2.f, 1 / 4.f, 3 / 4.f, 1 / 8.f, 5 / 8.f, 3 / 8.f, 7 / 8.f, 1 / 16.f};
  const float base_3[] = {1 / 3.f, 2 / 3.f, 1 / 9.f, 4 / 9.f, 7 / 9.f, 2 / 9.f, 5 / 9.f, 8 / 9.f};
  for (uint32_t i = 0; i < 8; ++i) {
    EXPECT_EQ(radicalInverse(2, i + 1), base_2[i]);
    EXPECT_NEAR(radicalInverse(3, i + 1), base_3[i], 1e-7f);
    EXPECT_EQ(haltonOffset(i).x, base_2[i] - 0.5f);
  }
  EXPECT_EQ(radicalInverse(2, 0), 0.0f);
}

TEST(Jitter, MeansOfPrefixes) {
  // Computed independently, rounded to four digits.
  struct Row {
    uint32_t n;
    vec2 halton, r2;
  };
  const Row rows[] = {{4, {-.0938f, -.1111f}, {-.1128f, -.0754f}},
                      {8, {-.0547f, .0000f}, {-.1031f, -.0607f}},
                      {16, {-.0293f, -.0370f}, {-.0835f, -.0314f}},
                      {32, {-.0151f, -.0185f}, {-.0445f, -.0351f}}};
  for (const Row& row : rows) {
    const vec2 halton = sequenceMean(kSequenceHalton, row.n);
    const vec2 r2 = sequenceMean(kSequenceR2, row.n);
    EXPECT_NEAR(halton.x, row.halton.x, 6e-5f) << row.n;
    EXPECT_NEAR(halton.y, row.halton.y, 6e-5f) << row.n;
    EXPECT_NEAR(r2.x, row.r2.x, 6e-5f) << row.n;
    EXPECT_NEAR(r2.y, row.r2.y, 6e-5f) << row.n;
  }
}

TEST(Jitter, R2KeepsItsFractionAtHighIndices) {
  const double step[] = {0.7548776662466927, 0.5698402909980532};
  for (const uint32_t index : {0u, 1u, 999u, 1000000u, 16777217u}) {
    const double x = std::fmod(0.5 + (index + 1.0) * step[0], 1.0) - 0.5;
    const double y = std::fmod(0.5 + (index + 1.0) * step[1], 1.0) - 0.5;
    // The step is known to half of 2^-32, times the index.
    const double tolerance = 1e-6 + (index + 1.0) * 1.2e-10;
    EXPECT_NEAR(r2Offset(index).x, x, tolerance) << index;
    EXPECT_NEAR(r2Offset(index).y, y, tolerance) << index;
  }
}

// Every elementary interval of every aligned block of 2^k points holds exactly one point.
template <typename Point>
void expectStratified(Point point) {
  for (uint32_t k = 0; k <= 8; ++k) {
    const uint32_t count = 1u << k;
    for (uint32_t block = 0; block < 4; ++block) {
      for (uint32_t split = 0; split <= k; ++split) {
        const uint32_t columns = 1u << split;
        const uint32_t rows = count / columns;
        std::set<std::pair<uint32_t, uint32_t>> cells;
        for (uint32_t i = 0; i < count; ++i) {
          const vec2 p = point(block * count + i);
          cells.emplace(static_cast<uint32_t>(p.x * static_cast<float>(columns)),
                        static_cast<uint32_t>(p.y * static_cast<float>(rows)));
        }
        ASSERT_EQ(cells.size(), count) << "2^" << k << ", block " << block << ", split " << split;
      }
    }
  }
}

TEST(Jitter, SobolIsStratifiedInEveryElementaryInterval) {
  expectStratified([](uint32_t i) {
    return vec2(static_cast<float>(reverseBits(i) >> 8u),
                static_cast<float>(sobolSecond(i) >> 8u)) /
           16777216.0f;
  });
}

TEST(Jitter, OwenScramblingKeepsStratificationAndDependsOnTheSeed) {
  for (const uint32_t seed : {0u, 1u, 77u, 0xdeadbeefu}) {
    expectStratified([&](uint32_t i) { return owenSobol(i, seed); });
  }
  EXPECT_NE(owenSobol(5, 1).x, owenSobol(5, 2).x);
}

TEST(Jitter, SobolDirectionNumbers) {
  EXPECT_EQ(sobolSecond(1), 0x80000000u);
  EXPECT_EQ(sobolSecond(2), 0xc0000000u);
  EXPECT_EQ(sobolSecond(4), 0xa0000000u);
  EXPECT_EQ(sobolSecond(8), 0xf0000000u);
  EXPECT_EQ(sobolSecond(16), 0x88000000u);
  EXPECT_EQ(sobolSecond(7), 0x80000000u ^ 0xc0000000u ^ 0xa0000000u);
  EXPECT_EQ(reverseBits(0x80000001u), 0x80000001u);
  EXPECT_EQ(reverseBits(0x0000f00du), 0xb00f0000u);
}

TEST(Jitter, NRooksUsesEveryColumnAndRowOnce) {
  for (uint32_t length = 1; length <= 256; ++length) {
    std::set<int> columns, rows;
    for (uint32_t i = 0; i < length; ++i) {
      const vec2 p = nRooksOffset(i, length);
      columns.insert(static_cast<int>((p.x + 0.5f) * static_cast<float>(length)));
      rows.insert(static_cast<int>((p.y + 0.5f) * static_cast<float>(length)));
    }
    ASSERT_EQ(columns.size(), length) << length;
    ASSERT_EQ(rows.size(), length) << length;
    ASSERT_EQ(*columns.rbegin(), static_cast<int>(length) - 1);
    ASSERT_EQ(*rows.rbegin(), static_cast<int>(length) - 1);
  }
}

TEST(Jitter, NRooksIsNoDiagonal) {
  for (const uint32_t length : {4u, 5u, 6u, 7u, 8u, 12u, 16u, 32u}) {
    // On a diagonal x + y or x - y is the same for all, modulo the pixel.
    std::set<int> sums, differences;
    for (uint32_t i = 0; i < length; ++i) {
      const vec2 p = nRooksOffset(i, length) * static_cast<float>(length);
      const int n = static_cast<int>(length);
      sums.insert((static_cast<int>(std::lround(p.x + p.y)) + 4 * n) % n);
      differences.insert((static_cast<int>(std::lround(p.x - p.y)) + 4 * n) % n);
    }
    EXPECT_GT(sums.size(), 1u) << length;
    EXPECT_GT(differences.size(), 1u) << length;
  }
}

TEST(Jitter, StandardSamplePositions) {
  // Vulkan's table in sixteenths from the corner.
  const int of_4[][2] = {{6, 2}, {14, 6}, {2, 10}, {10, 14}};
  const int of_8[][2] = {{9, 5}, {7, 11}, {13, 9}, {5, 3}, {3, 13}, {1, 7}, {11, 15}, {15, 1}};
  const int of_16[][2] = {{9, 9},  {7, 5}, {5, 10}, {12, 7}, {3, 6}, {10, 13}, {13, 11}, {11, 3},
                          {6, 14}, {8, 1}, {4, 2},  {2, 12}, {0, 8}, {15, 4},  {14, 15}, {1, 0}};
  const auto offset = [](const int* p) {
    return vec2(static_cast<float>(p[0]), static_cast<float>(p[1])) / 16.0f - vec2(0.5f);
  };
  for (uint32_t i = 0; i < 16; ++i) {
    EXPECT_EQ(msaa16Offset(i).x, offset(of_16[i]).x) << i;
    EXPECT_EQ(msaa16Offset(i).y, offset(of_16[i]).y) << i;
    EXPECT_EQ(msaa8Offset(i).x, offset(of_8[i % 8]).x) << i;
    EXPECT_EQ(msaa8Offset(i).y, offset(of_8[i % 8]).y) << i;
  }
  std::set<std::pair<float, float>> standard, rotated;
  for (uint32_t i = 0; i < 4; ++i) {
    standard.emplace(offset(of_4[i]).x, offset(of_4[i]).y);
    rotated.emplace(rotatedGridOffset(i).x, rotatedGridOffset(i).y);
  }
  EXPECT_EQ(standard, rotated);
  EXPECT_EQ(msaa2Offset(0).x, 0.25f);
  EXPECT_EQ(msaa2Offset(1).y, -0.25f);
}

TEST(Jitter, HelixVisitsTheQuartersDiagonalByDiagonal) {
  const vec2 expected[] = {{-.25f, -.25f}, {.25f, .25f}, {.25f, -.25f}, {-.25f, .25f}};
  for (uint32_t i = 0; i < 8; ++i) {
    EXPECT_EQ(helixOffset(i).x, expected[i % 4].x);
    EXPECT_EQ(helixOffset(i).y, expected[i % 4].y);
  }
}

TEST(Jitter, UpscalingLengths) {
  EXPECT_EQ(upscalingLength(1.0f), 8u);
  EXPECT_EQ(upscalingLength(1.5f), 18u);
  EXPECT_EQ(upscalingLength(1.7f), 23u);
  EXPECT_EQ(upscalingLength(2.0f), 32u);
  EXPECT_EQ(upscalingLength(3.0f), 72u);
}

TEST(JitterSequence, EveryOffsetLiesInThePixelAndRepeatsAfterThePeriod) {
  for (const uint32_t sequence : kSequences) {
    for (const uint32_t length : {1u, 2u, 3u, 5u, 8u, 16u, 100u, 256u, 1024u}) {
      const uint32_t period = sequencePeriod(sequence, length);
      ASSERT_GE(period, 1u);
      for (uint32_t i = 0; i < period; ++i) {
        const vec2 p = sequenceOffset(sequence, i, length);
        ASSERT_GT(p.x, -0.5f) << sequence << " " << i << " of " << length;
        ASSERT_GT(p.y, -0.5f) << sequence << " " << i << " of " << length;
        ASSERT_LE(p.x, 0.5f);
        ASSERT_LE(p.y, 0.5f);
        const vec2 later = sequenceOffset(sequence, i + 7ull * period, length);
        ASSERT_EQ(p.x, later.x);
        ASSERT_EQ(p.y, later.y);
      }
    }
  }
}

TEST(JitterSequence, CentredCyclesHaveNoMean) {
  for (const uint32_t sequence : kSequences) {
    const vec2 mean = sequenceMean(sequence, 16);
    vec2 rest;
    const uint32_t period = sequencePeriod(sequence, 16);
    for (uint32_t i = 0; i < period; ++i) rest += sequenceOffset(sequence, i, 16) - mean;
    EXPECT_NEAR(rest.x, 0.0f, 1e-5f) << sequence;
    EXPECT_NEAR(rest.y, 0.0f, 1e-5f) << sequence;
  }
  // Symmetric patterns have none to begin with.
  for (const uint32_t sequence : {kSequenceNone, kSequenceRotatedGrid, kSequenceMsaa8,
                                  kSequenceHelix, kSequenceNRooks, kSequenceSobol}) {
    const vec2 mean = sequenceMean(sequence, 16);
    EXPECT_NEAR(mean.x, 0.0f, 1e-6f) << sequence;
    EXPECT_NEAR(mean.y, 0.0f, 1e-6f) << sequence;
  }
}

// Spread on the torus.
float toroidalDistance(vec2 a, vec2 b) {
  const vec2 d = abs(a - b);
  return length(min(d, vec2(1.0f) - d));
}

float meanNearestDistance(const std::vector<vec2>& points, size_t count) {
  float sum = 0.0f;
  for (size_t i = 0; i < count; ++i) {
    float nearest = 1.0f;
    for (size_t j = 0; j < count; ++j) {
      if (i != j) nearest = min(nearest, toroidalDistance(points[i], points[j]));
    }
    sum += nearest;
  }
  return sum / static_cast<float>(count);
}

TEST(BlueNoise, NoTwoPointsAreClose) {
  const auto& points = blueNoiseSequence();
  ASSERT_EQ(points.size(), kMaxBlueNoise);
  // A square lattice has 1 / sqrt(n), white noise of 256 points about 0.03 / sqrt(n).
  for (const size_t count : {2u, 4u, 8u, 16u, 32u, 64u, 128u, 256u}) {
    float nearest = 1.0f;
    for (size_t i = 0; i < count; ++i) {
      for (size_t j = 0; j < i; ++j) nearest = min(nearest, toroidalDistance(points[i], points[j]));
    }
    EXPECT_GE(nearest * std::sqrt(static_cast<float>(count)), 0.49f) << count;
  }
}

TEST(BlueNoise, EveryPrefixIsBetterSpreadThanWhiteNoise) {
  const auto& points = blueNoiseSequence();
  for (size_t count = 2; count <= kMaxBlueNoise; ++count) {
    float best_white = 0.0f, mean_white = 0.0f;
    for (uint32_t trial = 0; trial < 8; ++trial) {
      std::vector<vec2> white;
      for (uint32_t i = 0; i < count; ++i) {
        const uint32_t h = hashPixel(i, trial, static_cast<uint32_t>(count));
        white.emplace_back(unitFloat(h), unitFloat(hashPcg(h)));
      }
      const float spread = meanNearestDistance(white, count);
      best_white = max(best_white, spread);
      mean_white += spread / 8.0f;
    }
    const float blue = meanNearestDistance(points, count);
    ASSERT_GT(blue, mean_white) << count;
    // Few white points can be lucky; many cannot.
    if (count >= 16) {
      ASSERT_GT(blue, 1.2f * best_white) << count;
    }
  }
}

TEST(BlueNoise, IsNoLattice) {
  const auto& points = blueNoiseSequence();
  std::set<float> columns, rows;
  for (size_t i = 0; i < 16; ++i) {
    columns.insert(points[i].x);
    rows.insert(points[i].y);
  }
  // 4 on a square lattice: a nearly upright edge would then see 4 of 16 coverages.
  EXPECT_GE(columns.size(), 12u);
  EXPECT_GE(rows.size(), 12u);
}

TEST(BlueNoise, IsTheSameOnEveryCompiler) {
  const auto& points = blueNoiseSequence();
  const vec2 first[] = {{.0078125f, .0078125f},
                        {.4921875f, .0234375f},
                        {-.2265625f, .4140625f},
                        {.3671875f, .3984375f}};
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(points[i].x, first[i].x) << i;
    EXPECT_EQ(points[i].y, first[i].y) << i;
  }
}

}  // namespace
}  // namespace reprise::eq
