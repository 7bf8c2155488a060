// SPDX-License-Identifier: MIT
#include "lab/metrics/sequence_meter.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lab/metrics/psnr.h"

namespace reprise::lab {
namespace {

FloatImage flatImage(float value, uint32_t channels) {
  FloatImage image(16, 12, channels);
  for (float& v : image.texels) v = value;
  return image;
}

struct Sequence {
  SequenceTruth truth;
  std::vector<FloatImage> images;
};

FrameGeometry flatGeometry(float motion_px, bool reset) {
  FrameGeometry geometry{.motion_px = FloatImage(16, 12, 2),
                         .view_depth = flatImage(5.0f, 1),
                         .previous_view_depth = flatImage(5.0f, 1),
                         .reset = reset};
  for (size_t i = 0; i < geometry.motion_px.texels.size(); i += 2) {
    geometry.motion_px.texels[i] = motion_px;
  }
  return geometry;
}

// Frames 0 to 9 still, then moving; still frames are right, moving ones are off.
Sequence halfMoving(size_t count) {
  Sequence s;
  AgeTracker ages;
  for (size_t i = 0; i < count; ++i) {
    s.truth.frames.push_back(
        frameTruth(flatImage(0.5f, 3), flatGeometry(i < 10 ? 0.049f : 0.051f, i == 0), ages));
    s.images.push_back(flatImage(i < 10 ? 0.5f : 0.8f, 4));
  }
  return s;
}

TEST(SequenceMeter, SplitsStillFromMovingAndSkipsTheWarmUp) {
  const Sequence s = halfMoving(12);
  const SequenceFigures figures = measureSequence(s.truth, s.images);
  ASSERT_EQ(figures.frames.size(), 12u);
  EXPECT_FALSE(figures.frames[7].counted);
  EXPECT_TRUE(figures.frames[8].counted);
  ASSERT_TRUE(figures.mean && figures.still && figures.moving);
  EXPECT_EQ(figures.mean->frames, 4u);
  EXPECT_EQ(figures.still->frames, 2u);
  EXPECT_EQ(figures.moving->frames, 2u);
  EXPECT_EQ(figures.still->psnr, kMaxPsnr_db);
  const double step = std::pow(0.8 / 1.8, 1 / 2.2) - std::pow(0.5 / 1.5, 1 / 2.2);
  EXPECT_NEAR(figures.moving->psnr, -20.0 * std::log10(step), 1e-3);
  EXPECT_NEAR(figures.mean->psnr, 0.5 * (figures.still->psnr + figures.moving->psnr), 1e-9);
  EXPECT_NEAR(figures.mean->psnr_of_mean, figures.moving->psnr + 10.0 * std::log10(2.0), 1e-6);
  // The one step, between frames 9 and 10, over two moving frames.
  EXPECT_NEAR(figures.moving->tpsnr, figures.moving->psnr + 10.0 * std::log10(2.0), 1e-6);
  EXPECT_EQ(figures.still->tpsnr, kMaxPsnr_db);
  EXPECT_GT(figures.moving->flip, 0.0);
  EXPECT_NEAR(figures.moving->flip, figures.moving->flip30, 1e-4);  // flat images
  EXPECT_TRUE(std::isnan(figures.frames[0].tpsnr));
}

TEST(SequenceMeter, ShortSequencesCountWhole) {
  const Sequence s = halfMoving(3);
  const SequenceFigures figures = measureSequence(s.truth, s.images);
  EXPECT_EQ(figures.mean->frames, 3u);
  EXPECT_FALSE(figures.moving.has_value());
}

TEST(SequenceMeter, RefusesOtherExtents) {
  Sequence s = halfMoving(2);
  s.truth.frames[1].reference = FloatImage(16, 13, 3);
  EXPECT_THROW(measureSequence(s.truth, s.images), std::invalid_argument);
  s = halfMoving(2);
  s.truth.frames[1].ages.pop_back();
  EXPECT_THROW(measureSequence(s.truth, s.images), std::invalid_argument);
  s.truth.frames.pop_back();
  EXPECT_THROW(measureSequence(s.truth, s.images), std::invalid_argument);
}

TEST(SequenceMeter, MeasuresOnlyWhatIsAskedFor) {
  const Sequence s = halfMoving(12);
  bool called = false;
  MeterOptions options{.metrics = MetricSet::parse("ssim,flicker")};
  options.on_error_map = [&](size_t, const FloatImage&) { called = true; };
  const SequenceFigures figures = measureSequence(s.truth, s.images, options);
  EXPECT_FALSE(called);  // the map is flip30's
  EXPECT_FALSE(std::isnan(figures.mean->ssim));
  EXPECT_FALSE(std::isnan(figures.mean->flicker));
  EXPECT_TRUE(std::isnan(figures.mean->flip));
  EXPECT_TRUE(std::isnan(figures.mean->tpsnr));
  ASSERT_EQ(figures.cpu_s.size(), 2u);
  EXPECT_EQ(figures.cpu_s[0].first, "ssim");
  EXPECT_GT(figures.cpu_s[0].second, 0.0);
  EXPECT_TRUE(MetricSet::parse("all").has(Metric::kColorVideoVdp));
  EXPECT_FALSE(MetricSet::parse("default").has(Metric::kColorVideoVdp));
  EXPECT_THROW(MetricSet::parse("ssim,nonsense"), std::invalid_argument);
}

// Still frames at rest, the test off by a square wave: what only a sequence shows.
TEST(SequenceMeter, FindsTheResidueAndTheConvergenceOfAStillView) {
  Sequence s;
  AgeTracker ages;
  for (size_t i = 0; i < 32; ++i) {
    s.truth.frames.push_back(frameTruth(flatImage(0.5f, 3), flatGeometry(0.0f, i == 0), ages));
    // Far off for five frames, then 0.5 +- 0.01 with a period of four frames.
    s.images.push_back(flatImage(i < 5 ? 2.0f : (i / 2 % 2 == 0 ? 0.51f : 0.49f), 3));
  }
  s.truth.frame_rate = 48.0;
  const SequenceFigures figures = measureSequence(s.truth, s.images);
  ASSERT_TRUE(figures.convergence.has_value());
  EXPECT_EQ(figures.convergence->frames, 6u);
  ASSERT_TRUE(figures.residue.has_value());
  EXPECT_EQ(figures.residue->frames, 24u);
  EXPECT_NEAR(figures.residue->strongest_hz, 12.0, 1e-9);
  const double step = std::pow(0.51 / 1.51, 1 / 2.2) - std::pow(0.49 / 1.49, 1 / 2.2);
  EXPECT_NEAR(figures.residue->peak_mean, step, 1e-5);
  EXPECT_NEAR(figures.residue->sigma_mean, 0.5 * step, 1e-5);
  // Half of the frames change by the step, which can be seen.
  EXPECT_NEAR(figures.mean->flicker, 0.5 * step, 1e-5);
}

}  // namespace
}  // namespace reprise::lab
