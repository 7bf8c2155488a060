// SPDX-License-Identifier: MIT
#include "equations/reprojection.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "equations/hash.h"
#include "reprise/reprise.h"

namespace reprise::eq {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

// Device depth of a point at view depth z, from the projection that makes it, in double.
TEST(ViewDepth, InvertsEveryDepthKind) {
  const double n = 0.1, f = 500.0;
  for (const double z : {0.1, 0.5, 3.0, 77.0, 499.0}) {
    const struct {
      RepriseDepthKind kind;
      double depth;
    } cases[] = {
        {REPRISE_DEPTH_DEVICE, f * (z - n) / (z * (f - n))},
        {REPRISE_DEPTH_DEVICE_REVERSED, n * (f - z) / (z * (f - n))},
        {REPRISE_DEPTH_DEVICE_INFINITE, 1.0 - n / z},
        {REPRISE_DEPTH_REVERSED_INFINITE, n / z},
        {REPRISE_DEPTH_PLANAR, z},
        {REPRISE_DEPTH_ORTHOGRAPHIC, (z - n) / (f - n)},
    };
    for (const auto& c : cases) {
      const vec4 k = viewDepthCoefficients(c.kind, 0.1f, 500.0f);
      // A float near 1 keeps 6e-8 of device depth, worth z^2 / n of view depth.
      const double tolerance = 1e-5 * z + 1.2e-7 * z * z / n;
      EXPECT_NEAR(viewDepthFromDepth(k, static_cast<float>(c.depth)), z, tolerance)
          << "kind " << c.kind << " at " << z;
    }
  }
}

TEST(ViewDepth, AnInfiniteFarPlaneIsTheLimitOfADistantOne) {
  for (const float depth : {0.1f, 0.5f, 0.9f}) {
    const auto at = [&](int kind) {
      return viewDepthFromDepth(viewDepthCoefficients(kind, 0.1f, kInfinity), depth);
    };
    EXPECT_FLOAT_EQ(at(REPRISE_DEPTH_DEVICE), 0.1f / (1.0f - depth));
    EXPECT_FLOAT_EQ(at(REPRISE_DEPTH_DEVICE_REVERSED), 0.1f / depth);
  }
}

TEST(ViewDepth, PlanesOfTheFrustum) {
  const auto at = [](int kind, float depth) {
    return viewDepthFromDepth(viewDepthCoefficients(kind, 0.25f, 64.0f), depth);
  };
  EXPECT_NEAR(at(REPRISE_DEPTH_DEVICE, 0.0f), 0.25f, 1e-6f);
  EXPECT_NEAR(at(REPRISE_DEPTH_DEVICE, 1.0f), 64.0f, 1e-3f);
  EXPECT_NEAR(at(REPRISE_DEPTH_DEVICE_REVERSED, 1.0f), 0.25f, 1e-6f);
  EXPECT_NEAR(at(REPRISE_DEPTH_DEVICE_REVERSED, 0.0f), 64.0f, 1e-3f);
  EXPECT_NEAR(at(REPRISE_DEPTH_ORTHOGRAPHIC, 1.0f), 64.0f, 1e-6f);
  EXPECT_EQ(at(REPRISE_DEPTH_REVERSED_INFINITE, 0.0f), kInfinity);
}

using Matrix = std::array<float, 16>;

// World to camera at `eye`, turned by `yaw` and then `pitch`.
Matrix view(vec3 eye, float yaw, float pitch) {
  const float cy = std::cos(yaw), sy = std::sin(yaw), cp = std::cos(pitch), sp = std::sin(pitch);
  const float rows[3][3] = {{cy, 0, -sy}, {sp * sy, cp, sp * cy}, {cp * sy, -sp, cp * cy}};
  Matrix m{};
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) m[4 * c + r] = rows[r][c];
    m[12 + r] = -(rows[r][0] * eye.x + rows[r][1] * eye.y + rows[r][2] * eye.z);
  }
  m[15] = 1.0f;
  return m;
}

vec4 times(const Matrix& m, vec4 v) {
  return mat4(vec4(m[0], m[1], m[2], m[3]), vec4(m[4], m[5], m[6], m[7]),
              vec4(m[8], m[9], m[10], m[11]), vec4(m[12], m[13], m[14], m[15])) *
         v;
}

TEST(PreviousDepth, MatchesProjectingPointsThroughBothCameras) {
  // Reversed infinite, y down, off centre.
  Matrix projection{};
  projection[0] = 1.2f;
  projection[5] = -1.9f;
  projection[8] = 0.15f;
  projection[9] = -0.05f;
  projection[11] = -1.0f;
  projection[14] = 0.1f;
  const Matrix now = view(vec3(3.0f, 1.5f, -4.0f), 0.7f, -0.2f);
  const Matrix then = view(vec3(2.6f, 1.7f, -4.9f), 0.55f, -0.1f);
  const vec2 extent_px(320.0f, 180.0f);
  const vec4 k = previousDepthCoefficients(now.data(), projection.data(), then.data(), extent_px.x,
                                           extent_px.y);
  int seen = 0;
  for (uint32_t i = 0; i < 2000; ++i) {
    const vec4 world(20.0f * unitFloat(hashPixel(i, 0, 0)) - 10.0f,
                     20.0f * unitFloat(hashPixel(i, 1, 0)) - 10.0f,
                     20.0f * unitFloat(hashPixel(i, 2, 0)) - 10.0f, 1.0f);
    const vec4 in_view = times(now, world);
    const vec4 clip = times(projection, in_view);
    if (clip.w < 0.1f) continue;
    const vec2 px = pxFromUv(uvFromNdc(vec2(clip.x, clip.y) / clip.w), extent_px);
    if (!isOnScreen(px, extent_px)) continue;
    ++seen;
    const float expected = -times(then, world).z;
    EXPECT_NEAR(expectedPreviousDepth(k, px, -in_view.z), expected, 2e-4f);
  }
  EXPECT_GT(seen, 100);
}

TEST(PreviousDepth, AStillCameraKeepsDepth) {
  Matrix projection{};
  projection[0] = projection[5] = 1.0f;
  projection[11] = -1.0f;
  const Matrix camera = view(vec3(1000.0f, 20.0f, -3000.0f), 1.0f, 0.3f);
  const vec4 k =
      previousDepthCoefficients(camera.data(), projection.data(), camera.data(), 64.0f, 64.0f);
  for (const float z : {0.5f, 10.0f, 900.0f}) {
    EXPECT_NEAR(expectedPreviousDepth(k, vec2(5.0f, 60.0f), z), z, 1e-3f * z);
  }
}

TEST(PreviousDepth, OrthographicCamerasThatDoNotTurn) {
  Matrix projection{};
  projection[0] = projection[5] = 0.1f;
  projection[15] = 1.0f;
  const Matrix now = view(vec3(0.0f, 0.0f, 2.0f), 0.0f, 0.0f);
  const Matrix then = view(vec3(5.0f, 1.0f, 3.5f), 0.0f, 0.0f);
  const vec4 k =
      previousDepthCoefficients(now.data(), projection.data(), then.data(), 64.0f, 64.0f);
  // The camera came 1.5 closer, looking along -z.
  EXPECT_NEAR(expectedPreviousDepth(k, vec2(3.0f, 50.0f), 4.0f), 5.5f, 1e-5f);
}

TEST(Reprojection, ScreenSpaces) {
  const vec2 extent_px(200.0f, 100.0f);
  EXPECT_EQ(uvFromPx(vec2(50.0f, 75.0f), extent_px).x, 0.25f);
  EXPECT_EQ(uvFromPx(vec2(50.0f, 75.0f), extent_px).y, 0.75f);
  EXPECT_EQ(ndcFromUv(vec2(0.25f, 0.75f)).x, -0.5f);
  EXPECT_EQ(ndcFromUv(vec2(0.25f, 0.75f)).y, 0.5f);
  EXPECT_EQ(uvFromNdc(vec2(-0.5f, 0.5f)).y, 0.75f);
  EXPECT_EQ(pxFromUv(vec2(0.25f, 0.75f), extent_px).y, 75.0f);
  // One pixel is 2 / extent of NDC.
  EXPECT_FLOAT_EQ(ndcFromJitter(vec2(0.5f, -0.25f), extent_px).x, 0.005f);
  EXPECT_FLOAT_EQ(ndcFromJitter(vec2(0.5f, -0.25f), extent_px).y, -0.005f);
}

TEST(Reprojection, DepthTests) {
  EXPECT_TRUE(depthsAgree(10.0f, 10.15f, 0.02f));
  EXPECT_FALSE(depthsAgree(10.0f, 10.25f, 0.02f));
  EXPECT_FALSE(depthsAgree(10.25f, 10.0f, 0.02f));
  EXPECT_TRUE(depthsAgree(65504.0f, 65504.0f, 0.001f));
  EXPECT_TRUE(wasVisible(10.0f, 100.0f, 0.02f));
  EXPECT_TRUE(wasVisible(10.15f, 10.0f, 0.02f));
  EXPECT_FALSE(wasVisible(10.25f, 10.0f, 0.02f));
  // 1/8 against 1/10: a change of 0.025.
  EXPECT_TRUE(wasVisibleOnPlane(10.15f, 10.0f, 0.02f, 0.0f));
  EXPECT_FALSE(wasVisibleOnPlane(10.25f, 10.0f, 0.02f, 0.0f));
  EXPECT_FALSE(wasVisibleOnPlane(10.0f, 8.0f, 0.0f, 0.024f));
  EXPECT_TRUE(wasVisibleOnPlane(10.0f, 8.0f, 0.0f, 0.026f));
  // Behind the eye then; no history.
  EXPECT_TRUE(wasVisibleOnPlane(-5.0f, 2.0f, 0.02f, 1.0f));
  EXPECT_FALSE(wasVisibleOnPlane(5.0f, 0.0f, 0.02f, 1.0f));
}

// Against differences of 1 / viewDepthFromDepth, for every kind of depth.
TEST(Reprojection, InverseDepthSlopeIsTheDerivative) {
  for (const int kind : {0, 1, 2, 3, 4, 5}) {
    const vec4 k = viewDepthCoefficients(kind, 0.5f, 50.0f);
    const float depth = kind == 4 ? 20.0f : 0.25f;
    const float step = 0.01f * depth;
    const float change =
        1.0f / viewDepthFromDepth(k, depth + step) - 1.0f / viewDepthFromDepth(k, depth - step);
    const float expected = std::abs(change) / (2.0f * step);
    EXPECT_NEAR(inverseDepthSlope(k, depth), expected, 2.0e-3f * expected) << kind;
  }
  // Reversed, infinite: 1 / z = depth / near.
  EXPECT_FLOAT_EQ(inverseDepthSlope(vec4(0.0f, 0.5f, 1.0f, 0.0f), 0.3f), 2.0f);
}

TEST(Reprojection, ScreenEndsAtTheOuterEdgesOfThePixels) {
  const vec2 extent_px(8.0f, 4.0f);
  EXPECT_TRUE(isOnScreen(vec2(0.0f, 0.0f), extent_px));
  EXPECT_TRUE(isOnScreen(vec2(8.0f, 4.0f), extent_px));
  EXPECT_FALSE(isOnScreen(vec2(-0.01f, 2.0f), extent_px));
  EXPECT_FALSE(isOnScreen(vec2(4.0f, 4.01f), extent_px));
  EXPECT_FALSE(isOnScreen(vec2(std::numeric_limits<float>::quiet_NaN(), 1.0f), extent_px));
}

TEST(Reprojection, TapWeights) {
  const auto sum = [](vec4 w) { return w.x + w.y + w.z + w.w; };
  // All valid: bilinear, up to the share of texels without weight.
  const vec4 all = validTapWeights(0.25f, 0.5f, vec4(1.0f));
  EXPECT_NEAR(all.x, 0.375f, 2e-4f);
  EXPECT_NEAR(all.y, 0.125f, 2e-4f);
  EXPECT_NEAR(all.z, 0.375f, 2e-4f);
  for (uint32_t mask = 1; mask < 16; ++mask) {
    const vec4 valid(static_cast<float>(mask & 1u), static_cast<float>(mask >> 1 & 1u),
                     static_cast<float>(mask >> 2 & 1u), static_cast<float>(mask >> 3 & 1u));
    for (const float f : {0.0f, 0.3f, 0.999f}) {
      const vec4 w = validTapWeights(f, 1.0f - f, valid);
      EXPECT_NEAR(sum(w), 1.0f, 1e-5f) << mask;
      EXPECT_EQ(dot(w, vec4(1.0f) - valid), 0.0f) << mask;
    }
  }
  EXPECT_EQ(sum(validTapWeights(0.5f, 0.5f, vec4(0.0f))), 0.0f);
}

TEST(Reprojection, MotionDifference) {
  const vec2 now_px(3.0f, 0.0f);
  EXPECT_EQ(motionDifferenceRamp(now_px, now_px, 0.5f), 0.0f);
  EXPECT_EQ(motionDifferenceRamp(now_px, vec2(3.0f, 0.5f), 0.5f), 0.0f);
  EXPECT_FLOAT_EQ(motionDifferenceRamp(now_px, vec2(3.0f, 2.75f), 0.5f), 0.5f);
  EXPECT_FLOAT_EQ(motionDifferenceRamp(now_px, vec2(-3.0f, 0.0f), 0.5f), 1.0f);
}

}  // namespace
}  // namespace reprise::eq
