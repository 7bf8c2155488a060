// SPDX-License-Identifier: MIT
#include "equations/clipping.h"

#include <gtest/gtest.h>

#include <vector>

#include "equations/hash.h"

namespace reprise::eq {
namespace {

vec3 randomColor(uint32_t i) {
  return vec3(unitFloat(hashPixel(i, 0, 1)), unitFloat(hashPixel(i, 1, 1)),
              unitFloat(hashPixel(i, 2, 1)));
}

void expectInside(vec3 p, vec3 low, vec3 high) {
  for (int i = 0; i < 3; ++i) {
    EXPECT_GE(p[i], low[i] - 1e-5f);
    EXPECT_LE(p[i], high[i] + 1e-5f);
  }
}

TEST(Clipping, ByHand) {
  const vec3 low(0.0f), high(1.0f);
  const vec3 history(2.0f, 0.5f, 0.5f);
  EXPECT_FLOAT_EQ(clampToBox(low, high, vec3(2.0f, -1.0f, 0.3f)).x, 1.0f);
  EXPECT_FLOAT_EQ(clampToBox(low, high, vec3(2.0f, -1.0f, 0.3f)).y, 0.0f);
  EXPECT_FLOAT_EQ(clampToBox(low, high, vec3(2.0f, -1.0f, 0.3f)).z, 0.3f);
  // Toward the centre along x only.
  EXPECT_NEAR(clipTowardBoxCentre(low, high, history).x, 1.0f, 1e-5f);
  EXPECT_NEAR(clipTowardBoxCentre(low, high, vec3(2.0f, 1.25f, 0.5f)).y, 0.75f, 1e-5f);
  // From (0, 0, 0) to (2, 1, 0) the box ends at (1, 0.5, 0).
  const vec3 clipped = clipTowardSample(low, high, vec3(0.0f), vec3(2.0f, 1.0f, 0.0f));
  EXPECT_NEAR(clipped.x, 1.0f, 1e-6f);
  EXPECT_NEAR(clipped.y, 0.5f, 1e-6f);
  EXPECT_NEAR(clipped.z, 0.0f, 1e-6f);
}

TEST(Clipping, InsideStaysAndOutsideComesIn) {
  for (uint32_t i = 0; i < 500; ++i) {
    const vec3 a = randomColor(4 * i), b = randomColor(4 * i + 1);
    const vec3 low = min(a, b), high = max(a, b);
    const vec3 current = mix(low, high, unitFloat(hashPcg(i)));
    const vec3 history = randomColor(4 * i + 2) * 3.0f - vec3(1.0f);
    expectInside(clampToBox(low, high, history), low, high);
    expectInside(clipTowardBoxCentre(low, high, history), low, high);
    expectInside(clipTowardSample(low, high, current, history), low, high);
    const vec3 inside = low + (high - low) * unitFloat(hashPixel(i, 9, 9));
    EXPECT_NEAR(length(clampToBox(low, high, inside) - inside), 0.0f, 1e-6f);
    EXPECT_NEAR(length(clipTowardBoxCentre(low, high, inside) - inside), 0.0f, 1e-5f);
    EXPECT_NEAR(length(clipTowardSample(low, high, current, inside) - inside), 0.0f, 1e-5f);
  }
}

TEST(Clipping, DegenerateBoxesGiveTheirPoint) {
  const vec3 point(0.25f, 0.5f, 4.0f);
  for (uint32_t i = 0; i < 20; ++i) {
    const vec3 history = randomColor(i) * 10.0f;
    EXPECT_LT(length(clipTowardBoxCentre(point, point, history) - point), 1e-5f);
    EXPECT_LT(length(clipTowardSample(point, point, point, history) - point), 1e-5f);
  }
}

TEST(Clipping, SlabExit) {
  EXPECT_FLOAT_EQ(slabExit(0.0f, 2.0f, -1.0f, 1.0f), 0.5f);
  EXPECT_FLOAT_EQ(slabExit(0.0f, -4.0f, -1.0f, 1.0f), 0.25f);
  EXPECT_FLOAT_EQ(slabExit(0.0f, 0.5f, -1.0f, 1.0f), 1.0f);  // ends inside
  EXPECT_FLOAT_EQ(slabExit(0.0f, 0.0f, -1.0f, 1.0f), 1.0f);  // does not move
  EXPECT_FLOAT_EQ(slabExit(3.0f, 1.0f, -1.0f, 1.0f), 0.0f);  // starts outside, moves off
}

TEST(Clipping, DeviationAndRoundedBound) {
  // Samples 1, 2, 3: mean 2, mean square 14 / 3, variance 2 / 3.
  EXPECT_NEAR(deviationFromMoments(vec3(2.0f), vec3(14.0f / 3.0f)).x, 0.816497f, 1e-5f);
  // Rounding must not become a NaN.
  EXPECT_EQ(deviationFromMoments(vec3(0.1f), vec3(0.00999f)).x, 0.0f);
  EXPECT_FLOAT_EQ(roundedBound(vec3(0.0f), vec3(1.0f)).y, 0.5f);
}

std::vector<vec3> unitAxes(uint32_t count) {
  std::vector<vec3> axes;
  for (uint32_t i = 0; i < count; ++i) axes.push_back(kdopAxis(i) / length(kdopAxis(i)));
  return axes;
}

// Degrees from `direction` to the nearest axis, either way along it.
float degreesToNearest(vec3 direction, const std::vector<vec3>& axes) {
  float nearest = 0.0f;
  for (const vec3 axis : axes) nearest = max(nearest, abs(dot(axis, direction)));
  return std::acos(min(nearest, 1.0f)) * 57.2957795f;
}

// How the axes were made: all whole directions of the cube, then the gaps.
TEST(KdopAxes, FirstThirteenAreTheCubesDirections) {
  std::vector<vec3> cube;
  for (int z = -1; z <= 1; ++z) {
    for (int y = -1; y <= 1; ++y) {
      for (int x = -1; x <= 1; ++x) {
        const vec3 d(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
        if (dot(d, d) > 0.0f) cube.push_back(d / length(d));
      }
    }
  }
  ASSERT_EQ(cube.size(), 26u);  // each axis both ways
  const std::vector<vec3> axes = unitAxes(13);
  for (const vec3 d : cube) EXPECT_LT(degreesToNearest(d, axes), 0.1f);
  for (const vec3 axis : axes) EXPECT_LT(degreesToNearest(axis, cube), 0.1f);
}

TEST(KdopAxes, LastThreeLieInTheWidestGaps) {
  const std::vector<vec3> cube = unitAxes(13);
  float widest = 0.0f;
  for (uint32_t i = 0; i < 20000; ++i) {
    vec3 d = randomColor(i) * 2.0f - vec3(1.0f);
    d = d / max(length(d), 1e-3f);
    widest = max(widest, degreesToNearest(d, cube));
  }
  const std::vector<vec3> axes = unitAxes(kKdopAxes);
  for (uint32_t i = 13; i < kKdopAxes; ++i) {
    EXPECT_NEAR(degreesToNearest(axes[i], cube), 27.57f, 0.01f);
    EXPECT_GE(degreesToNearest(axes[i], cube), widest - 0.01f);
    for (uint32_t j = 13; j < i; ++j) {
      EXPECT_GT(degreesToNearest(axes[i], {axes[j]}), 60.0f) << i << " and " << j;
    }
  }
}

}  // namespace
}  // namespace reprise::eq
