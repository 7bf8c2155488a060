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
  std::vector<FloatImage> references, images;
  std::vector<float> motion_px;
};

// Frames 0 to 9 still, then moving; still frames are right, moving ones are off.
Sequence halfMoving(size_t count) {
  Sequence s;
  for (size_t i = 0; i < count; ++i) {
    s.references.push_back(flatImage(0.5f, 3));
    s.images.push_back(flatImage(i < 10 ? 0.5f : 0.8f, 4));
    s.motion_px.push_back(i < 10 ? 0.049f : 0.051f);
  }
  return s;
}

TEST(SequenceMeter, SplitsStillFromMovingAndSkipsTheWarmUp) {
  const Sequence s = halfMoving(12);
  const SequenceFigures figures = measureSequence(s.references, s.images, s.motion_px);
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
  const SequenceFigures figures = measureSequence(s.references, s.images, s.motion_px);
  EXPECT_EQ(figures.mean->frames, 3u);
  EXPECT_FALSE(figures.moving.has_value());
}

TEST(SequenceMeter, RefusesOtherExtents) {
  Sequence s = halfMoving(2);
  s.references[1] = FloatImage(16, 13, 3);
  EXPECT_THROW(measureSequence(s.references, s.images, s.motion_px), std::invalid_argument);
  s.references.pop_back();
  EXPECT_THROW(measureSequence(s.references, s.images, s.motion_px), std::invalid_argument);
}

}  // namespace
}  // namespace reprise::lab
