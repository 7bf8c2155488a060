// SPDX-License-Identifier: MIT
//
// What is composed with amortized shading: silhouettes by multisampled depth, light that is kept
// out of it, motion blur.
#include <gtest/gtest.h>

#include <cmath>

#include "board_scene.h"
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
  options.reference.cache = "none";
  return options;
}

FloatImage lastImage(const SceneRun& scene, const SceneSourceOptions& options,
                     const char* technique) {
  SceneSource source(testDevice(), scene, options);
  Resolver resolver(testDevice(), parseTechnique(technique), source.info());
  return runSequence(testDevice(), source, resolver, options.frames, true, {}).images.back();
}

double lastPsnr(const SceneRun& scene, const SceneSourceOptions& options, const char* technique) {
  SceneSource source(testDevice(), scene, options);
  const FloatImage reference = displayImage(*source.reference(options.frames - 1));
  return psnrDb(meanSquaredError(reference, displayImage(lastImage(scene, options, technique))));
}

class Layers : public testing::Test {
 protected:
  void TearDown() override { expectNoValidationMessages(); }
};
class Coverage : public Layers {};
class MotionBlur : public Layers {};

// PSNR of the last frame over the pixels that touch a silhouette: board and sky within 3 x 3.
double silhouettePsnr(const SceneRun& scene, const char* technique) {
  const SceneSourceOptions options = optionsOf(16);
  SceneSource source(testDevice(), scene, options);
  const FloatImage reference = displayImage(*source.reference(options.frames - 1));
  Resolver resolver(testDevice(), parseTechnique(technique), source.info());
  FloatImage depth;
  FloatImage image;
  runSequence(testDevice(), source, resolver, options.frames, false, [&](const FrameDone& done) {
    if (done.index + 1 < options.frames) return;
    depth = download(testDevice(), *done.inputs.depth);
    image = displayImage(done.image);
  });
  double sum = 0.0;
  uint32_t count = 0;
  for (uint32_t y = 1; y + 1 < depth.height; ++y) {
    for (uint32_t x = 1; x + 1 < depth.width; ++x) {
      uint32_t sky = 0;
      for (uint32_t n = 0; n < 9; ++n) {
        sky += *depth.at(x + n % 3 - 1, y + n / 3 - 1) == 0.0f ? 1 : 0;
      }
      if (sky == 0 || sky == 9) continue;
      for (size_t c = 0; c < 3; ++c) {
        const double d = image.at(x, y)[c] - reference.at(x, y)[c];
        sum += d * d;
        ++count;
      }
    }
  }
  EXPECT_GT(count, 300u);
  return -10.0 * std::log10(sum / count);
}

TEST_F(Coverage, SmoothsSilhouettes) {
  for (const char* camera : {"still", "pan"}) {
    const double without = silhouettePsnr(boardRun(camera), "amortized");
    const double with = silhouettePsnr(boardRun(camera), "amortized:coverage=true");
    EXPECT_GT(with, without + 1.5) << camera;
    EXPECT_GT(with, silhouettePsnr(boardRun(camera), "ss:n=2") + 1.5) << camera;
  }
}

TEST_F(Coverage, ChangesNothingWhereThereAreNoSilhouettes) {
  const SceneRun wall = parseSceneRun("brick/rotate");
  const FloatImage without = lastImage(wall, optionsOf(6), "amortized");
  const FloatImage with = lastImage(wall, optionsOf(6), "amortized:coverage=true");
  // The composed image is kept in half precision.
  for (size_t i = 0; i < without.texels.size(); ++i) {
    ASSERT_NEAR(with.texels[i], without.texels[i], 1.0e-3f * (1.0f + without.texels[i]));
  }
}

FloatImage lateLight(const SceneSourceOptions& options) {
  SceneSource source(testDevice(), boardRun("still"), options);
  Resolver resolver(testDevice(), parseTechnique("none"), source.info());
  FloatImage late;
  runSequence(testDevice(), source, resolver, 1, false,
              [&](const FrameDone& done) { late = download(testDevice(), *done.inputs.late); });
  return late;
}

TEST_F(Layers, MainAndDeferredLightMakeTheWhole) {
  // Both antialiased: the late light is the mean of several positions.
  constexpr uint32_t kFrames = 48;
  SceneSourceOptions options = optionsOf(kFrames);
  const FloatImage whole = lastImage(boardRun("still"), options, "amortized");
  options.switches.defer_lights = true;
  const FloatImage composed = lastImage(boardRun("still"), options, "amortized");
  const FloatImage late = lateLight(options);
  double sum_composed = 0.0;
  double sum_whole = 0.0;
  uint32_t reached = 0;
  for (size_t i = 0; i < whole.texels.size(); ++i) {
    if (i % 4 == 3 || late.texels[i] == 0.0f) continue;
    sum_composed += composed.texels[i];
    sum_whole += whole.texels[i];
    ++reached;
  }
  EXPECT_GT(reached, 1000u);
  EXPECT_NEAR(sum_composed / sum_whole, 1.0, 0.02);
  EXPECT_GT(psnrDb(meanSquaredError(displayImage(whole), displayImage(composed))), 30.0);
}

TEST_F(Layers, ShadedAtOnePositionTheyAreExactlyTheWhole) {
  SceneSourceOptions options = optionsOf(1);
  const FloatImage whole = lastImage(boardRun("still"), options, "none");
  options.switches.defer_lights = true;
  options.switches.late_positions = 1;
  const FloatImage composed = lastImage(boardRun("still"), options, "none");
  const FloatImage late = lateLight(options);
  uint32_t reached = 0;
  for (size_t i = 0; i < whole.texels.size(); ++i) {
    if (i % 4 == 3) continue;
    if (late.texels[i] > 0.0f) ++reached;
    // The gain is kept in half precision.
    ASSERT_NEAR(composed.texels[i], whole.texels[i], 2.0e-3f * (0.01f + whole.texels[i])) << i;
  }
  EXPECT_GT(reached, 1000u);
}

TEST_F(Layers, WhereNoDeferredLightFallsNothingChanges) {
  SceneSourceOptions options = optionsOf(1);
  const FloatImage whole = lastImage(boardRun("still"), options, "none");
  options.switches.defer_lights = true;
  const FloatImage composed = lastImage(boardRun("still"), options, "none");
  const FloatImage late = lateLight(options);
  EXPECT_EQ(late.at(0, 0)[1], 0.0f);  // the sky is no surface
  uint32_t compared = 0;
  for (size_t i = 0; i < whole.texels.size(); ++i) {
    if (i % 4 == 3 || late.texels[i] > 0.0f) continue;
    ASSERT_EQ(composed.texels[i], whole.texels[i]);
    ++compared;
  }
  EXPECT_GT(compared, 100u);
}

TEST_F(MotionBlur, ComesNearTheBlurredReferenceAndAwayFromTheSharpOne) {
  // 5 px a frame at this extent.
  const SceneRun pan = parseSceneRun("brick/pan:speed=8");
  SceneSourceOptions options = optionsOf(12);
  options.reference.filter = ReferenceFilter::kGaussian;
  const auto gain = [&] {
    return lastPsnr(pan, options, "amortized:shutter=1") - lastPsnr(pan, options, "amortized");
  };
  // So fast, few samples reach a surface: any average takes out noise, also against a sharp truth.
  const double against_sharp = gain();
  options.reference.shutter = 1.0;
  const double against_blurred = gain();
  EXPECT_GT(against_blurred, 3.0);
  EXPECT_GT(against_blurred, against_sharp + 2.0);
}

TEST_F(MotionBlur, LeavesHistoryAndWhatStandsStillAlone) {
  const SceneRun still = parseSceneRun("brick/still");
  EXPECT_EQ(lastImage(still, optionsOf(8), "amortized:shutter=1").texels,
            lastImage(still, optionsOf(8), "amortized").texels);
}

TEST_F(MotionBlur, TheReferenceOfAViewAtRestIsTheSameWithAShutter) {
  SceneSourceOptions options = optionsOf(3);
  options.reference.samples = 16;
  SceneSource sharp(testDevice(), parseSceneRun("brick/still"), options);
  options.reference.shutter = 1.0;
  SceneSource open(testDevice(), parseSceneRun("brick/still"), options);
  SceneSource moving(testDevice(), parseSceneRun("brick/pan:speed=8"), options);
  const FloatImage a = *sharp.reference(2);
  const FloatImage b = *open.reference(2);
  for (size_t i = 0; i < a.texels.size(); ++i) ASSERT_NEAR(a.texels[i], b.texels[i], 1.0e-5f);
  options.reference.shutter = 0.0;
  SceneSource moving_sharp(testDevice(), parseSceneRun("brick/pan:speed=8"), options);
  EXPECT_LT(psnrDb(meanSquaredError(displayImage(*moving.reference(2)),
                                    displayImage(*moving_sharp.reference(2)))),
            35.0);
  EXPECT_NE(moving.info().reference_filter, moving_sharp.info().reference_filter);
}

}  // namespace
}  // namespace reprise::lab
