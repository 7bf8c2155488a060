// SPDX-License-Identifier: MIT
//
// Mistakes that implementations of temporal antialiasing are known for, each as a test that fails
// when one is made here.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "formula_source.h"
#include "lab/metrics/display_space.h"
#include "lab/metrics/psnr.h"
#include "lab/render/scene_source.h"
#include "lab/run/sequence_run.h"
#include "test_device.h"

namespace reprise::lab {
namespace {

SceneSourceOptions small(uint32_t frames) {
  SceneSourceOptions options;
  options.extent = {120, 68};
  options.frames = frames;
  options.reference.samples = 32;
  options.reference.cache = "none";
  return options;
}

double lastPsnr(const char* scene, const char* technique, uint32_t frames) {
  SceneSource source(testDevice(), parseSceneRun(scene), small(frames));
  Resolver resolver(testDevice(), parseTechnique(technique), source.info());
  const SequenceRun run = runSequence(testDevice(), source, resolver, frames, true, {});
  return psnrDb(meanSquaredError(displayImage(*source.reference(frames - 1)),
                                 displayImage(run.images.back())));
}

TEST(Traps, MotionHoldsNoJitter) {
  SceneSource source(testDevice(), parseSceneRun("brick/still"), small(8));
  Resolver resolver(testDevice(), parseTechnique("taa"), source.info());
  for (uint32_t index = 0; index < 8; ++index) {
    FrameInputs inputs;
    testDevice().submitAndWait([&](VkCommandBuffer commands) {
      inputs = source.frame(commands, index, resolver.plan(index));
    });
    for (const float value : download(testDevice(), *inputs.motion).texels) {
      ASSERT_EQ(value, 0.0f) << index;
    }
  }
}

// The mean of what a cycle accumulates lies where the pixel is: no shift by the jitter's mean, no
// sign turned around. A ramp is shifted by exactly its slope times the error.
TEST(Traps, AConvergedImageIsNotShifted) {
  Formula formula;
  formula.color = [](float x, float y) {
    return Rgb{std::max(0.0f, 0.1f * (x - 20.0f)), std::max(0.0f, 0.1f * (y - 12.0f)), 0.5f};
  };
  FormulaSource source(testDevice(), {48, 32}, formula);
  for (const char* technique :
       {"reprojection", "taa", "taa:input_filter=none", "taa:jitter=r2", "taa:jitter=sobol",
        "taa:jitter=blue-noise", "taa:jitter=n-rooks", "taa:jitter=rotated-grid",
        "taa:jitter=msaa8", "taa:jitter=helix", "taa:input_filter=blackman-harris,input_width=1",
        "taa:average=4"}) {
    SCOPED_TRACE(technique);
    Resolver resolver(testDevice(), parseTechnique(technique), source.info());
    resolveFrames(resolver, source, 64);
    // The mean of one more cycle's outputs.
    double shift_x = 0.0;
    double shift_y = 0.0;
    constexpr uint32_t kCycle = 16;
    for (uint32_t frame = 64; frame < 64 + kCycle; ++frame) {
      const FloatImage image = resolveFrames(resolver, source, 1, frame);
      shift_x += (image.at(24, 16)[0] - 0.1f * 4.5f) / 0.1 / kCycle;
      shift_y += (image.at(24, 16)[1] - 0.1f * 4.5f) / 0.1 / kCycle;
    }
    EXPECT_LT(std::abs(shift_x), 0.02);
    EXPECT_LT(std::abs(shift_y), 0.02);
  }
}

// Half-precision history must not stop the running mean of a still view short of the truth.
TEST(Traps, LongMeansDoNotStallInHalfPrecision) {
  // One pixel in 16 frames is bright: the mean is 1/16 and each step is smaller than half a bit.
  Formula formula;
  formula.damage = [](uint32_t frame, FloatImage& color, FloatImage&, FloatImage&) {
    for (size_t i = 0; i < color.texelCount(); ++i) {
      const float v = frame % 16 == 15 ? 1.9f : 0.9f;
      for (size_t c = 0; c < 3; ++c) color.texels[4 * i + c] = v;
    }
  };
  FormulaSource source(testDevice(), {32, 32}, formula);
  const auto meanAfter = [&](const char* technique) {
    Resolver resolver(testDevice(), parseTechnique(technique), source.info());
    const FloatImage image = resolveFrames(resolver, source, 512);
    double sum = 0.0;
    for (size_t i = 0; i < image.texelCount(); ++i) sum += image.texels[4 * i];
    return sum / static_cast<double>(image.texelCount());
  };
  const double expected = 0.9 + 1.0 / 16.0;
  const std::string base =
      "taa:weighting=none,clip=none,input_filter=none,rejected_blur=false,spatial_frames=0";
  EXPECT_NEAR(meanAfter((base + ",dither=true").c_str()), expected, 0.002);
}

TEST(Traps, BicubicHistoryNeverGoesBelowZero) {
  Formula formula;
  // A bright line on black: the negative lobes fall on black.
  formula.color = [](float x, float) {
    const float v = std::fmod(x + 1000.0f, 12.0f) < 1.0f ? 8.0f : 0.0f;
    return Rgb{v, v, v};
  };
  formula.velocity_px[0] = 0.5f;
  formula.velocity_px[1] = 0.5f;
  FormulaSource source(testDevice(), {64, 32}, formula);
  for (const char* filter : {"catmull-rom-5", "catmull-rom-9", "lanczos"}) {
    Resolver resolver(
        testDevice(),
        parseTechnique(std::string("taa:clip=none,history_sharpness=1,history_filter=") + filter),
        source.info());
    for (const float value : resolveFrames(resolver, source, 24).texels) {
      ASSERT_GE(value, 0.0f) << filter;
      ASSERT_LT(value, 16.0f) << filter;
    }
  }
}

// Panning by exactly one pixel a frame: patterns that follow the frame's parity lock, and history
// that is read at texel centres must come back unblurred.
TEST(Traps, AnIntegerPanConvergesLikeAStillView) {
  const auto error = [](const char* technique, float velocity_px) {
    Formula formula;
    formula.color = [](float x, float y) {
      const bool on = std::fmod(0.31f * x + 0.17f * y + 1000.0f, 2.0f) < 1.0f;
      return on ? Rgb{0.8f, 0.5f, 0.2f} : Rgb{0.1f, 0.1f, 0.6f};
    };
    formula.velocity_px[0] = velocity_px;
    constexpr uint32_t kFrames = 32;
    FormulaSource source(testDevice(), {96, 32}, formula);
    Resolver resolver(testDevice(), parseTechnique(technique), source.info());
    const FloatImage image = resolveFrames(resolver, source, kFrames);
    const FloatImage reference = *source.reference(kFrames - 1);
    double sum = 0.0;
    // Columns that were inside in every frame.
    for (uint32_t y = 4; y < 28; ++y) {
      for (uint32_t x = 40; x < 90; ++x) {
        for (size_t c = 0; c < 3; ++c) {
          const double d = image.at(x, y)[c] - reference.at(x, y)[c];
          sum += d * d;
        }
      }
    }
    return sum;
  };
  const char* technique = "taa:clip=none,alpha=0.06";
  EXPECT_LT(error(technique, 1.0f), 1.5 * error(technique, 0.0f));
  EXPECT_LT(error(technique, 1.0f), 0.5 * error(technique, 0.5f));
  EXPECT_LT(error(technique, 1.0f), 0.1 * error("none", 1.0f));
  // Half of the pixels a frame: strict alternation would show a point one half for ever.
  const char* half = "checkerboard:clip=false,alpha=0.06";
  EXPECT_LT(error(half, 1.0f), 1.5 * error(half, 0.0f));
  EXPECT_LT(error(half, 1.0f), 0.5 * error(half, 0.5f));
  EXPECT_LT(error(half, 1.0f),
            0.8 * error("checkerboard:clip=false,alpha=0.06,halves=alternate", 1.0f));
}

// Moving history is read by a cubic, whose lobes go below the ground beside a lamp.
TEST(Traps, CoarseShadingDrawsNoDarkRingRoundALamp) {
  constexpr float kGround = 0.1f;
  const auto darkest = [&](const char* technique) {
    Formula lamp;
    lamp.velocity_px[0] = 0.37f;
    lamp.velocity_px[1] = 0.21f;
    lamp.color = [](float x_px, float y_px) {
      const float value = std::hypot(x_px - 20.0f, y_px - 14.0f) < 2.5f ? 20.0f : kGround;
      return Rgb{value, value, value};
    };
    FormulaSource source(testDevice(), {48, 32}, lamp);
    Resolver resolver(testDevice(), parseTechnique(technique), source.info());
    const FloatImage image = resolveFrames(resolver, source, 16);
    float least = kGround;
    for (size_t i = 0; i < image.texelCount(); ++i) least = std::min(least, image.texels[4 * i]);
    return least;
  };
  EXPECT_GT(darkest("cpst"), 0.98f * kGround);
  EXPECT_LT(darkest("cpst:history_clamp=false"), 0.9f * kGround);
}

// Mean PSNR of the 16 frames (one cycle of the jitter) before each of `ends`.
std::vector<double> cyclePsnr(const char* scene, const char* technique,
                              std::span<const uint32_t> ends) {
  constexpr uint32_t kCycle = 16;
  SceneSource source(testDevice(), parseSceneRun(scene), small(ends.back()));
  Resolver resolver(testDevice(), parseTechnique(technique), source.info());
  const SequenceRun run = runSequence(testDevice(), source, resolver, ends.back(), true, {});
  const FloatImage reference = displayImage(*source.reference(0));
  std::vector<double> means;
  for (const uint32_t end : ends) {
    double sum = 0.0;
    for (uint32_t i = end - kCycle; i < end; ++i) {
      sum += psnrDb(meanSquaredError(reference, displayImage(run.images[i])));
    }
    means.push_back(sum / kCycle);
  }
  return means;
}

TEST(Traps, MoreFramesOfAStillViewComeCloser) {
  const uint32_t ends[] = {16, 32, 64, 96};
  const std::vector<double> brick = cyclePsnr("brick/still", "taa", ends);
  for (size_t i = 1; i < brick.size(); ++i) EXPECT_GT(brick[i], brick[i - 1]) << ends[i];
  // Lines thinner than a pixel leave neighbourhoods flat: there the bound ends convergence (the
  // technique's page); it may not undo it.
  const std::vector<double> chart = cyclePsnr("chart/still", "taa", ends);
  EXPECT_GT(chart[1], chart[0] + 1.0);
  EXPECT_GT(chart[3], chart[1] - 0.5);
  const std::vector<double> unbounded = cyclePsnr("chart/still", "taa:clip=none", ends);
  for (size_t i = 1; i < unbounded.size(); ++i) EXPECT_GT(unbounded[i], unbounded[i - 1] - 0.02);
  EXPECT_GT(unbounded[3], chart[3] + 3.0);
}

// The current depth belongs to the pixel centre minus the jitter: a plane that recedes steeply must
// pass its own depth test.
TEST(Traps, TheDepthTestPassesOnASteepPlane) {
  const auto kept = [](const char* technique) { return lastPsnr("brick/rotate", technique, 24); };
  EXPECT_GT(kept("taa:depth_test=taps,rejected_blur=false"),
            kept("taa:depth_test=none,rejected_blur=false") - 0.1);
}

TEST(Traps, BlendAndBoundShareTheirSpace) {
  // A firefly of 1000 in one frame must be gone from a still view's neighbours soon, in every
  // space.
  for (const char* weighting : {"none", "luminance", "log"}) {
    Formula formula;
    formula.damage = [](uint32_t frame, FloatImage& color, FloatImage&, FloatImage&) {
      if (frame == 10) color.at(8, 8)[0] = 1000.0f;
    };
    FormulaSource source(testDevice(), {16, 16}, formula);
    Resolver resolver(testDevice(), parseTechnique(std::string("taa:weighting=") + weighting),
                      source.info());
    const FloatImage image = resolveFrames(resolver, source, 40);
    EXPECT_NEAR(image.at(8, 8)[0], 0.5f, 0.02f) << weighting;
  }
}

}  // namespace
}  // namespace reprise::lab
