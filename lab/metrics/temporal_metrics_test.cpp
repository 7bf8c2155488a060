// SPDX-License-Identifier: MIT
// Ages, flicker along motion, residue, convergence: sequences whose figures follow by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "lab/metrics/convergence.h"
#include "lab/metrics/disocclusion.h"
#include "lab/metrics/jitter_residue.h"
#include "lab/metrics/warped_flicker.h"

namespace reprise::lab {
namespace {

constexpr uint32_t kWidth = 32;
constexpr uint32_t kHeight = 12;
constexpr int kSquare = 8;  // px, side of the square and its first column is kStart
constexpr int kStart = 2;

bool inSquare(int x, int y, int frame, int speed) {
  const int left = kStart + speed * frame;
  return x >= left && x < left + kSquare && y >= 2 && y < 2 + kSquare;
}

// A square 1 m away moves right by `speed` px a frame before a wall 4 m away.
FrameGeometry squareGeometry(int frame, int speed) {
  FrameGeometry geometry{.motion_px = FloatImage(kWidth, kHeight, 2),
                         .view_depth = FloatImage(kWidth, kHeight, 1),
                         .previous_view_depth = FloatImage(kWidth, kHeight, 1),
                         .reset = frame == 0};
  for (uint32_t y = 0; y < kHeight; ++y) {
    for (uint32_t x = 0; x < kWidth; ++x) {
      const bool square = inSquare(static_cast<int>(x), static_cast<int>(y), frame, speed);
      *geometry.view_depth.at(x, y) = square ? 1.0f : 4.0f;
      *geometry.previous_view_depth.at(x, y) = square ? 1.0f : 4.0f;
      geometry.motion_px.at(x, y)[0] = square ? -static_cast<float>(speed) : 0.0f;
    }
  }
  return geometry;
}

TEST(Disocclusion, ATrailOfKnownAges) {
  AgeTracker tracker;
  Ages ages;
  for (int frame = 0; frame <= 5; ++frame) ages = tracker.next(squareGeometry(frame, 2));
  for (int y = 0; y < static_cast<int>(kHeight); ++y) {
    for (int x = 0; x < static_cast<int>(kWidth); ++x) {
      int expected = kAgeNeverUncovered;  // the square itself and what it has not passed
      // Two columns of the wall a frame come into view behind the square; the newest are next to
      // it.
      if (y >= 2 && y < 2 + kSquare && x >= kStart && x < kStart + 10) {
        expected = 5 - (x - kStart) / 2;
      }
      EXPECT_EQ(ages[static_cast<size_t>(y) * kWidth + static_cast<size_t>(x)], expected)
          << x << " " << y;
    }
  }
}

TEST(Disocclusion, AKnownGhostIsFoundAtItsAge) {
  AgeTracker tracker;
  Ages ages;
  for (int frame = 0; frame <= 5; ++frame) ages = tracker.next(squareGeometry(frame, 2));
  const FloatImage reference(kWidth, kHeight, 3);
  FloatImage test = reference;
  // What was at the square's back edge two frames ago still shows: 2 x 8 pixels.
  for (uint32_t y = 2; y < 2 + kSquare; ++y) {
    for (uint32_t x = kStart + 6; x < kStart + 8; ++x) {
      for (uint32_t c = 0; c < 3; ++c) test.at(x, y)[c] = 0.5f;
    }
  }
  EXPECT_EQ(errorAtAges(reference, test, ages, 2, 2).pixels, 16u);
  EXPECT_NEAR(errorAtAges(reference, test, ages, 2, 2).squared_error, 16 * 0.25, 1e-6);
  EXPECT_EQ(errorAtAges(reference, test, ages, 1, 1).squared_error, 0.0);
  EXPECT_EQ(errorAtAges(reference, test, ages, 4, 4).squared_error, 0.0);
  EXPECT_EQ(errorAtAges(reference, test, ages, 1, 8).pixels, 80u);
  EXPECT_EQ(errorAtAges(reference, test, ages, 9, 16).pixels, 0u);
}

TEST(Disocclusion, ASlopeIsNoOcclusionAndTheEdgeIsNoDisocclusion) {
  // A floor that runs away from the eye by 10 % a row, seen by a camera that moves by half a pixel.
  FrameGeometry geometry{.motion_px = FloatImage(kWidth, kHeight, 2),
                         .view_depth = FloatImage(kWidth, kHeight, 1),
                         .previous_view_depth = FloatImage(kWidth, kHeight, 1)};
  for (uint32_t y = 0; y < kHeight; ++y) {
    for (uint32_t x = 0; x < kWidth; ++x) {
      *geometry.view_depth.at(x, y) = std::pow(1.1f, static_cast<float>(y));
      *geometry.previous_view_depth.at(x, y) = std::pow(1.1f, static_cast<float>(y) + 0.5f);
      geometry.motion_px.at(x, y)[0] = 1.75f;
      geometry.motion_px.at(x, y)[1] = 0.5f;
    }
  }
  AgeTracker tracker;
  geometry.reset = true;
  EXPECT_EQ(tracker.next(geometry)[40], kAgeEntered);
  geometry.reset = false;
  const Ages ages = tracker.next(geometry);
  for (uint32_t y = 0; y + 1 < kHeight; ++y) {
    for (uint32_t x = 0; x < kWidth; ++x) {
      EXPECT_EQ(ages[y * kWidth + x], x < kWidth - 2 ? kAgeNeverUncovered : kAgeEntered) << x;
    }
  }
  // A motion that is no number has no previous surface.
  geometry.motion_px.at(3, 3)[0] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(tracker.next(geometry)[3 * kWidth + 3], kAgeEntered);
}

FloatImage luma(const std::function<double(double)>& value) {
  FloatImage image(kWidth, kHeight, 1);
  for (size_t i = 0; i < image.texels.size(); ++i) {
    image.texels[i] = static_cast<float>(value(static_cast<double>(i % kWidth)));
  }
  return image;
}

TEST(WarpedFlicker, ZeroForWhatMovesAsTheTruthDoes) {
  FloatImage motion_px(kWidth, kHeight, 2);
  for (size_t i = 0; i < motion_px.texels.size(); i += 2) motion_px.texels[i] = -1.5f;
  Ages ages(motion_px.texelCount(), kAgeNeverUncovered);
  for (size_t i = 0; i < ages.size(); ++i) {
    if (i % kWidth < 2) ages[i] = kAgeEntered;
  }
  const auto wave = [](double phase) {
    return luma([=](double x) { return 0.5 + 0.2 * std::sin(0.3 * (x - phase)); });
  };
  const FloatImage now = wave(1.5);
  const FloatImage before = wave(0.0);
  EXPECT_EQ(warpedFlicker({now, before}, {now, before}, motion_px, ages), 0.0);
  // A blurred and a brighter sequence that move along are no flicker either.
  const FloatImage dim_now = luma([](double x) { return 0.6 + 0.1 * std::sin(0.3 * (x - 1.5)); });
  const FloatImage dim_before = luma([](double x) { return 0.6 + 0.1 * std::sin(0.3 * x); });
  EXPECT_EQ(warpedFlicker({now, before}, {dim_now, dim_before}, motion_px, ages), 0.0);
  // What stands still on the screen while the truth moves is: it changes along motion.
  EXPECT_GT(warpedFlicker({now, before}, {now, now}, motion_px, ages), 0.02);
}

TEST(WarpedFlicker, CountsWhatCanBeSeenOfPixelsWithAPast) {
  const FloatImage motion_px(kWidth, kHeight, 2);
  Ages ages(motion_px.texelCount(), kAgeNeverUncovered);
  const FloatImage flat = luma([](double) { return 0.5; });
  const FloatImage brighter = luma([](double x) { return x < 8 ? 0.6 : 0.502; });
  // A quarter of the pixels by 0.1; 0.002 is below what is seen.
  EXPECT_NEAR(warpedFlicker({flat, flat}, {brighter, flat}, motion_px, ages), 0.025, 1e-6);
  // Where the truth changes by 0.04 too, only the rest is flicker.
  const FloatImage changed = luma([](double) { return 0.54; });
  EXPECT_NEAR(warpedFlicker({changed, flat}, {brighter, flat}, motion_px, ages), 0.015, 1e-6);
  for (size_t i = 0; i < ages.size(); ++i) {
    if (i % kWidth < 8) ages[i] = 1;
  }
  EXPECT_EQ(warpedFlicker({flat, flat}, {brighter, flat}, motion_px, ages), 0.0);
  std::fill(ages.begin(), ages.end(), kAgeEntered);
  EXPECT_TRUE(std::isnan(warpedFlicker({flat, flat}, {brighter, flat}, motion_px, ages)));
}

// A sine of `hz` on the left half, nothing on the right.
std::vector<FloatImage> humming(double hz, double amplitude, double frame_rate, size_t frames) {
  std::vector<FloatImage> differences;
  for (size_t f = 0; f < frames; ++f) {
    const double v = 0.1 + amplitude * std::sin(2.0 * std::numbers::pi * hz *
                                                static_cast<double>(f) / frame_rate);
    differences.push_back(luma([=](double x) { return x < kWidth / 2 ? v : 0.3; }));
  }
  return differences;
}

TEST(JitterResidue, FindsAKnownFrequencyAndItsAmplitude) {
  const std::vector<uint8_t> all(kWidth * kHeight, 1);
  const auto residue = jitterResidue(humming(7.5, 0.02, 60.0, 64), all, 60.0);
  ASSERT_TRUE(residue.has_value());
  EXPECT_EQ(residue->frames, 64u);
  EXPECT_NEAR(residue->strongest_hz, 7.5, 1e-9);
  EXPECT_NEAR(residue->sigma_mean, 0.5 * 0.02 / std::numbers::sqrt2, 1e-6);
  EXPECT_NEAR(residue->sigma_p99, 0.02 / std::numbers::sqrt2, 1e-6);
  EXPECT_NEAR(residue->peak_mean, 0.02, 1e-6);
  EXPECT_NEAR(residue->peak_p99, 0.04, 1e-6);
  // Root of the mean over pixels of the power: half of them have 0.02^2 / 2, all in the eye's band.
  EXPECT_NEAR(residue->eye_band_rms, 0.01, 1e-6);
}

TEST(JitterResidue, WhatFlipsEveryFrameIsOutsideOfTheEyesBand) {
  const std::vector<uint8_t> all(kWidth * kHeight, 1);
  std::vector<FloatImage> differences;
  for (int f = 0; f < 16; ++f) {
    differences.push_back(luma([=](double) { return f % 2 == 0 ? 0.01 : -0.01; }));
  }
  const auto residue = jitterResidue(differences, all, 60.0);
  EXPECT_NEAR(residue->strongest_hz, 30.0, 1e-9);
  EXPECT_NEAR(residue->sigma_mean, 0.01, 1e-6);
  EXPECT_NEAR(residue->eye_band_rms, 0.0, 1e-6);
}

TEST(JitterResidue, OnlyPixelsAtRestCount) {
  std::vector<uint8_t> right(kWidth * kHeight, 0);
  const auto differences = humming(7.5, 0.02, 60.0, 16);
  EXPECT_FALSE(jitterResidue(differences, right, 60.0).has_value());
  for (size_t i = 0; i < right.size(); ++i) right[i] = i % kWidth >= kWidth / 2;
  const auto residue = jitterResidue(differences, right, 60.0);
  ASSERT_TRUE(residue.has_value());
  EXPECT_EQ(residue->pixels, right.size() / 2);
  EXPECT_EQ(residue->peak_p99, 0.0);
  EXPECT_EQ(residue->strongest_hz, 0.0);
  EXPECT_FALSE(jitterResidue(humming(7.5, 0.02, 60.0, 7), right, 60.0).has_value());
}

TEST(Convergence, CountsFramesToWithinOneDecibel) {
  std::vector<double> psnr_db;
  for (int n = 1; n <= 32; ++n) psnr_db.push_back(20.0 + 10.0 * std::log10(std::min(n, 16)));
  const auto converged = convergence(psnr_db);
  ASSERT_TRUE(converged.has_value());
  EXPECT_NEAR(converged->asymptote_db, 20.0 + 10.0 * std::log10(16.0), 1e-9);
  // 10 log10(n / 16) >= -1 from n = 12.71 on.
  EXPECT_EQ(converged->frames, 13u);
  psnr_db.resize(15);
  EXPECT_FALSE(convergence(psnr_db).has_value());
}

}  // namespace
}  // namespace reprise::lab
