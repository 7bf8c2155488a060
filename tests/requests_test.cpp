// SPDX-License-Identifier: MIT
//
// Sample requests and motion over several frames, end to end: the library lists, the lab serves.
#include <gtest/gtest.h>

#include <cstring>

#include "lab/metrics/display_space.h"
#include "lab/metrics/psnr.h"
#include "lab/render/scene_source.h"
#include "lab/run/sequence_run.h"
#include "test_device.h"

namespace reprise::lab {
namespace {

constexpr VkExtent2D kExtent{97, 61};

SceneSourceOptions optionsOf(uint32_t frames) {
  SceneSourceOptions options;
  options.extent = kExtent;
  options.frames = frames;
  options.reference.samples = 64;
  options.reference.filter = ReferenceFilter::kGaussian;
  options.reference.cache = "none";
  return options;
}

SequenceRun run(const char* scene, const char* technique, uint32_t frames) {
  SceneSource source(testDevice(), parseSceneRun(scene), optionsOf(frames));
  Resolver resolver(testDevice(), parseTechnique(technique), source.info());
  return runSequence(testDevice(), source, resolver, frames, true, {});
}

double lastPsnr(const char* scene, const char* technique, uint32_t frames) {
  SceneSource source(testDevice(), parseSceneRun(scene), optionsOf(frames));
  const FloatImage reference = displayImage(*source.reference(frames - 1));
  const SequenceRun sequence = run(scene, technique, frames);
  return psnrDb(meanSquaredError(reference, displayImage(sequence.images.back())));
}

class Requests : public testing::Test {
 protected:
  void TearDown() override { expectNoValidationMessages(); }
};
class MotionBack : public Requests {};

TEST_F(Requests, AFrameWithoutHistoryAsksForEveryQuadrant) {
  EXPECT_DOUBLE_EQ(run("brick/pan", "amortized", 1).evaluations_per_pixel, 5.0);
  EXPECT_DOUBLE_EQ(run("brick/pan", "amortized:requests=false", 1).evaluations_per_pixel, 1.0);
}

TEST_F(Requests, AStillViewWithAllBuffersWrittenAsksForNothing) {
  // By frame 8 every buffer was written: later frames add one evaluation a pixel each.
  const double few = run("brick/still", "amortized", 8).evaluations_per_pixel * 8;
  const double more = run("brick/still", "amortized", 16).evaluations_per_pixel * 16;
  EXPECT_DOUBLE_EQ(more - few, 8.0);
}

TEST_F(Requests, OnlyWhatIsNewIsAskedForInMotion) {
  const double few = run("brick/pan", "amortized", 16).evaluations_per_pixel * 16;
  const double more = run("brick/pan", "amortized", 24).evaluations_per_pixel * 24;
  EXPECT_GT(more - few, 8.0);
  EXPECT_LT(more - few, 8.0 * 1.2);
}

// The camera runs beside the horse: its depth stays, where a point at rest would come nearer.
TEST_F(Requests, WhatMovesByItselfKeepsItsHistory) {
  const auto evaluations = [](const char* technique, uint32_t frames) {
    return run("horse/gallop", technique, frames).evaluations_per_pixel * frames;
  };
  const double asked = evaluations("amortized", 24) - evaluations("amortized", 16);
  const double shaded =
      evaluations("amortized:requests=false", 24) - evaluations("amortized:requests=false", 16);
  EXPECT_LT(asked / shaded, 1.5);
}

TEST_F(Requests, ServingThemImprovesTheFirstFrame) {
  EXPECT_GT(lastPsnr("brick/still", "amortized", 1),
            lastPsnr("brick/still", "amortized:requests=false", 1) + 3.0);
}

// Until all buffers are written, each begins with what is served beside its own sample.
TEST_F(Requests, ServedSamplesBeginTheBuffers) {
  EXPECT_GT(lastPsnr("brick/still", "amortized", 10),
            lastPsnr("brick/still", "amortized:requests=false", 10) + 0.2);
}

// A still pixel is worth one sample more after each frame, and served ones count.
TEST_F(Requests, AQualityIsHeldByAskingForWhatIsMissing) {
  const auto evaluations = [](const char* technique, uint32_t frames) {
    return run("brick/still", technique, frames).evaluations_per_pixel * frames;
  };
  EXPECT_DOUBLE_EQ(evaluations("amortized:quality=1", 4), 4.0);
  EXPECT_DOUBLE_EQ(evaluations("amortized:quality=3", 1), 3.0);
  EXPECT_DOUBLE_EQ(evaluations("amortized:quality=3", 4), 3.0 + 1.0 + 1.0 + 1.0);
  EXPECT_DOUBLE_EQ(evaluations("amortized:quality=64", 2), 5.0 + 5.0);  // the most there is
  EXPECT_LE(evaluations("amortized:quality=64,budget=2", 2), 2.0 * 2.0);
  // Where nothing failed too: in motion every frame is brought to the quality.
  // Served samples count, so that 16 asks for about what 8 would if they were lost.
  EXPECT_GT(lastPsnr("brick/rotate", "amortized:quality=16", 4),
            lastPsnr("brick/rotate", "amortized:quality=1", 4) + 1.0);
}

TEST_F(Requests, TheOrderOfTheListDoesNotShow) {
  const SequenceRun a = run("brick/rotate", "amortized", 12);
  const SequenceRun b = run("brick/rotate", "amortized", 12);
  for (size_t i = 0; i < a.images.size(); ++i) {
    ASSERT_EQ(std::memcmp(a.images[i].texels.data(), b.images[i].texels.data(),
                          a.images[i].texels.size() * sizeof(float)),
              0)
        << i;
  }
}

TEST_F(Requests, AmortizedIsAboveReprojectionAndFewSamples) {
  for (const char* scene : {"brick/pan", "brick/rotate", "brick/still"}) {
    const double amortized = lastPsnr(scene, "amortized", 24);
    EXPECT_GT(amortized, lastPsnr(scene, "reprojection", 24) + 1.0) << scene;
    EXPECT_GT(amortized, lastPsnr(scene, "ss:n=3", 24)) << scene;
  }
}

TEST_F(MotionBack, ChainedMotionComesCloseToExact) {
  for (const char* scene : {"brick/pan", "brick/rotate", "brick/zoom"}) {
    EXPECT_GT(lastPsnr(scene, "amortized:motion=chained", 24),
              lastPsnr(scene, "amortized:motion=exact", 24) - 0.3)
        << scene;
  }
}

// A sphere and a pot that turn, a creature that walks: their depth then is not the camera's doing.
TEST_F(MotionBack, DepthsThatTheHostGivesKeepTheHistoryOfWhatTurns) {
  constexpr uint32_t kFrames = 12;
  const auto evaluations = [](const char* technique) {
    return run("indoor/fly", technique, kFrames).evaluations_per_pixel * kFrames;
  };
  EXPECT_LT(evaluations("amortized:motion=exact"), evaluations("amortized") - 0.25);
}

TEST_F(MotionBack, ThePlanNamesTheAgesThatAreRead) {
  SceneSource source(testDevice(), parseSceneRun("brick/pan"), optionsOf(1));
  Resolver exact(testDevice(), parseTechnique("amortized:motion=exact"), source.info());
  Resolver chained(testDevice(), parseTechnique("amortized"), source.info());
  EXPECT_EQ(exact.plan(0).library.motion_back, 0u);
  EXPECT_EQ(exact.plan(4).library.motion_back, 0b1111u);  // after 0, 1, 2, 3
  EXPECT_EQ(chained.plan(4).library.motion_back, 0u);
}

}  // namespace
}  // namespace reprise::lab
