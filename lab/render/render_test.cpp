// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <random>

#include "lab/capture/output_file.h"
#include "lab/capture/temporary_directory.h"
#include "lab/metrics/disocclusion.h"
#include "lab/metrics/display_space.h"
#include "lab/metrics/sharpness.h"
#include "lab/render/reference_file.h"
#include "lab/render/scene_source.h"

namespace reprise::lab {
namespace {

SceneSourceOptions optionsOf(VkExtent2D extent, uint32_t samples = 16) {
  SceneSourceOptions options;
  options.extent = extent;
  options.frames = 8;
  options.reference.samples = samples;
  options.reference.cache = "none";
  return options;
}

struct Rendered {
  FloatImage color, depth, motion;
  FrameInputs inputs;
};

Rendered renderFrame(Device& device, SceneSource& source, uint32_t index, float jitter_x = 0.0f,
                     float jitter_y = 0.0f, uint32_t grid = 1, float mip_bias = 0.0f) {
  SamplePlan plan;
  plan.library.jitter_px[0] = jitter_x;
  plan.library.jitter_px[1] = jitter_y;
  plan.library.mip_bias = mip_bias;
  plan.grid = grid;
  Rendered rendered;
  device.submitAndWait(
      [&](VkCommandBuffer commands) { rendered.inputs = source.frame(commands, index, plan); });
  rendered.color = download(device, *rendered.inputs.color);
  rendered.depth = download(device, *rendered.inputs.depth);
  rendered.motion = download(device, *rendered.inputs.motion);
  return rendered;
}

double sharpnessAgainst(const FloatImage& reference, const FloatImage& test) {
  return sharpness(lumaImage(displayImage(reference)), lumaImage(displayImage(test)));
}

class Render : public testing::Test {
 protected:
  Render() : device({.validation = Device::validationAvailable()}) {}
  void TearDown() override {
    for (const std::string& message : device.validationMessages()) ADD_FAILURE() << message;
  }
  Device device;
};

TEST_F(Render, MotionPointsToWhereTheSurfaceWas) {
  SceneSource source(device, parseSceneRun("chart/pan:vx=2,vy=-1"), optionsOf({96, 64}));
  const Rendered before = renderFrame(device, source, 3);
  const Rendered now = renderFrame(device, source, 4);
  const float mx = now.motion.at(48, 32)[0];
  const float my = now.motion.at(48, 32)[1];
  EXPECT_NEAR(std::abs(mx), 2.0f, 1e-3f);
  EXPECT_NEAR(std::abs(my), 1.0f, 1e-3f);
  uint32_t compared = 0;
  for (uint32_t y = 8; y < 56; ++y) {
    for (uint32_t x = 8; x < 88; ++x) {
      ASSERT_NEAR(now.motion.at(x, y)[0], mx, 1e-3f);
      const auto px =
          static_cast<uint32_t>(static_cast<int>(x) + static_cast<int>(std::lround(mx)));
      const auto py =
          static_cast<uint32_t>(static_cast<int>(y) + static_cast<int>(std::lround(my)));
      const float difference = std::abs(now.color.at(x, y)[0] - before.color.at(px, py)[0]);
      compared += difference < 0.02f ? 1 : 0;
    }
  }
  // Hard edges may fall to either side by rounding; nothing else differs.
  EXPECT_GT(compared, 48u * 80u * 98u / 100u);
}

TEST_F(Render, MotionSpansSeveralFrames) {
  const VkExtent2D extent{64, 48};
  Renderer renderer(device, parseSceneRun("brick/pan"), extent, 60.0);
  const auto motionOver = [&](uint32_t frames_back) {
    renderer.setFrame(10, 0.0f);
    device.submitAndWait([&](VkCommandBuffer commands) {
      renderer.recordTransform(commands, frames_back);
      renderer.recordVisibility(commands, eq::vec2(0.0f, 0.0f));
      renderer.recordMotion(commands, eq::vec2(0.0f, 0.0f), frames_back);
    });
    return download(device, renderer.motion());
  };
  const FloatImage one = motionOver(1);
  const FloatImage four = motionOver(4);
  // The camera slides along a plane: four frames are four steps, but for perspective.
  for (uint32_t x : {5u, 30u, 60u}) {
    EXPECT_GT(std::abs(one.at(x, 20)[0]), 0.05f);
    EXPECT_NEAR(four.at(x, 20)[0], 4.0f * one.at(x, 20)[0], 0.05f * std::abs(four.at(x, 20)[0]));
  }
}

// What each pixel says of the frame before is what the frame before says of itself: on a wall that
// a camera passes, nothing is ever uncovered and the depths agree.
TEST_F(Render, GeometryAgreesWithTheFrameBefore) {
  SceneSource source(device, parseSceneRun("brick/pan"), optionsOf({96, 54}));
  AgeTracker tracker;
  FrameGeometry before = source.geometry(4);
  EXPECT_FALSE(before.reset);
  before.reset = true;
  tracker.next(before);
  const FrameGeometry now = source.geometry(5);
  const Ages ages = tracker.next(now);
  size_t followed = 0;
  for (size_t i = 0; i < ages.size(); ++i) {
    EXPECT_NE(ages[i], 1) << i;
    if (!hasPreviousSurface(ages[i])) continue;
    ++followed;
    const float x = static_cast<float>(i % 96) + now.motion_px.texels[2 * i];
    const float y = static_cast<float>(i / 96) + now.motion_px.texels[2 * i + 1];
    const auto px = static_cast<uint32_t>(std::clamp(std::lround(x), 0L, 95L));
    const auto py = static_cast<uint32_t>(std::clamp(std::lround(y), 0L, 53L));
    EXPECT_NEAR(*before.view_depth.at(px, py) / now.previous_view_depth.texels[i], 1.0f, 0.02f);
  }
  EXPECT_GT(followed, ages.size() / 2);
  EXPECT_NE(now.motion_px.texels[0], 0.0f);
}

// Motion of articulated parts against where their own transforms put the point, in double.
TEST_F(Render, MotionOfArticulatedPartsIsThatOfTheirTransforms) {
  const VkExtent2D extent{160, 90};
  for (const char* run : {"horse/gallop", "indoor/fly"}) {
    Renderer renderer(device, parseSceneRun(run), extent, 60.0);
    renderer.setFrame(10, 0.0f);
    device.submitAndWait([&](VkCommandBuffer commands) {
      renderer.recordTransform(commands, 1);
      renderer.recordVisibility(commands, eq::vec2(0.0f, 0.0f));
      renderer.recordMotion(commands, eq::vec2(0.0f, 0.0f), 1);
    });
    const FloatImage motion = download(device, renderer.motion());
    const FloatImage depth = download(device, renderer.depth());
    const RepriseCamera now = renderer.camera();
    renderer.setFrame(9, 0.0f);
    const RepriseCamera then = renderer.camera();
    const auto matrixOf = [](const RepriseCamera& camera) {
      glm::mat4 view;
      glm::mat4 projection;
      std::memcpy(&view, camera.view, sizeof(view));
      std::memcpy(&projection, camera.projection, sizeof(projection));
      return glm::dmat4(projection) * glm::dmat4(view);
    };
    const glm::dmat4 world_from_clip = glm::inverse(matrixOf(now));
    const glm::dmat4 clip_then = matrixOf(then);
    const Scene& scene = renderer.scene();
    const auto instances = static_cast<uint32_t>(scene.geometry().instances.size());
    // Each pixel's motion is that of one of the instances, and moving ones are among them.
    uint32_t moving = 0;
    uint32_t unexplained = 0;
    for (uint32_t y = 2; y < extent.height; y += 5) {
      for (uint32_t x = 2; x < extent.width; x += 5) {
        if (depth.at(x, y)[0] <= 0.0f) continue;
        const glm::dvec4 clip((x + 0.5) / extent.width * 2.0 - 1.0,
                              (y + 0.5) / extent.height * 2.0 - 1.0, depth.at(x, y)[0], 1.0);
        glm::dvec4 world = world_from_clip * clip;
        world /= world.w;
        double best = 1e9;
        bool best_moves = false;
        for (uint32_t i = 0; i < instances; ++i) {
          const glm::dmat4 here(scene.transform(i, 10.0 / 60.0));
          const glm::dmat4 before(scene.transform(i, 9.0 / 60.0));
          glm::dvec4 was = clip_then * (before * (glm::inverse(here) * world));
          was /= was.w;
          const double px = (was.x * 0.5 + 0.5) * extent.width - (x + 0.5);
          const double py = (was.y * 0.5 + 0.5) * extent.height - (y + 0.5);
          const double error = std::hypot(px - motion.at(x, y)[0], py - motion.at(x, y)[1]);
          if (error < best) {
            best = error;
            best_moves = here != before;
          }
        }
        unexplained += best < 0.02 ? 0 : 1;
        moving += best_moves ? 1 : 0;
      }
    }
    EXPECT_EQ(unexplained, 0u) << run;
    EXPECT_GT(moving, 10u) << run;
  }
}

TEST_F(Render, JitterMovesContentByItself) {
  SceneSource source(device, parseSceneRun("chart/still"), optionsOf({96, 64}));
  const Rendered plain = renderFrame(device, source, 0);
  const Rendered moved = renderFrame(device, source, 0, 1.0f, 0.0f);
  uint32_t same = 0;
  for (uint32_t y = 0; y < 64; ++y) {
    for (uint32_t x = 1; x < 96; ++x) {
      same += std::abs(moved.color.at(x, y)[1] - plain.color.at(x - 1, y)[1]) < 0.02f ? 1 : 0;
    }
  }
  EXPECT_GT(same, 64u * 95u * 98u / 100u);
}

TEST_F(Render, UnjitteredTexturesStayWhereTheyAre) {
  SceneSourceOptions options = optionsOf({96, 64});
  SceneSource jittered(device, parseSceneRun("brick/still"), options);
  options.switches.unjitter_textures = true;
  SceneSource steady(device, parseSceneRun("brick/still"), options);
  const auto change = [&](SceneSource& source) {
    const FloatImage a = renderFrame(device, source, 0, 0.4f, 0.3f).color;
    const FloatImage b = renderFrame(device, source, 0, -0.4f, -0.3f).color;
    double sum = 0.0;
    for (size_t i = 0; i < a.texels.size(); ++i) sum += std::abs(a.texels[i] - b.texels[i]);
    return sum;
  };
  EXPECT_LT(change(steady), 0.01 * change(jittered));
}

TEST_F(Render, MipBiasSharpens) {
  // At this extent the wall's grain is just hidden: a negative bias brings it back.
  SceneSource source(device, parseSceneRun("brick/still"), optionsOf({480, 270}));
  const FloatImage plain = renderFrame(device, source, 0).color;
  EXPECT_GT(sharpnessAgainst(plain, renderFrame(device, source, 0, 0, 0, 1, -2.0f).color), 1.02);
}

TEST_F(Render, SupersamplingEvaluatesEachSample) {
  SceneSource source(device, parseSceneRun("brick/pan"), optionsOf({64, 48}, 256));
  const FloatImage reference = *source.reference(2);
  source.takeEvaluations();
  double error_before = 1e9;
  for (const uint32_t n : {1u, 2u, 4u}) {
    const FloatImage color = renderFrame(device, source, 2, 0, 0, n).color;
    EXPECT_EQ(source.takeEvaluations(), uint64_t{n} * n * 64 * 48);
    double error = 0.0;
    for (size_t i = 0; i < reference.texelCount(); ++i) {
      error += std::abs(color.texels[4 * i] - reference.texels[3 * i]);
    }
    EXPECT_LT(error, 0.7 * error_before) << n;
    error_before = error;
  }
}

class EveryScene : public Render, public testing::WithParamInterface<std::string> {};

// Extents that no workgroup divides; what a run costs here is compiling its shaders.
TEST_P(EveryScene, RendersAtOddExtents) {
  for (const VkExtent2D extent : {VkExtent2D{131, 43}, VkExtent2D{1, 1}}) {
    SceneSource source(device, parseSceneRun(GetParam()), optionsOf(extent, 2));
    const Rendered frame = renderFrame(device, source, 1, 0.3f, -0.2f);
    for (const float value : frame.color.texels) ASSERT_TRUE(std::isfinite(value) && value >= 0.0f);
    for (const float value : frame.motion.texels) ASSERT_TRUE(std::isfinite(value));
    for (const float value : frame.depth.texels) ASSERT_TRUE(value >= 0.0f && value <= 1.0f);
  }
}

std::vector<std::string> everyRun() {
  std::vector<std::string> runs;
  for (const SceneInfo& scene : sceneList()) {
    for (const CameraInfo& camera : scene.cameras) runs.push_back(scene.name + "/" + camera.name);
  }
  return runs;
}

INSTANTIATE_TEST_SUITE_P(Render, EveryScene, testing::ValuesIn(everyRun()),
                         [](const testing::TestParamInfo<std::string>& run) {
                           std::string name = run.param;
                           std::replace(name.begin(), name.end(), '/', '_');
                           return name;
                         });

TEST_F(Render, TwoRunsGiveTheSameBytes) {
  for (const SceneInfo& scene : sceneList()) {
    const std::string run = scene.name + "/" + scene.cameras.front().name;
    SceneSource one(device, parseSceneRun(run), optionsOf({65, 33}));
    SceneSource two(device, parseSceneRun(run), optionsOf({65, 33}));
    renderFrame(device, one, 0);  // whatever came before
    const Rendered a = renderFrame(device, one, 5, 0.1f, 0.2f);
    const Rendered b = renderFrame(device, two, 5, 0.1f, 0.2f);
    EXPECT_EQ(a.color.texels, b.color.texels) << run;
    EXPECT_EQ(a.motion.texels, b.motion.texels) << run;
    EXPECT_EQ(a.depth.texels, b.depth.texels) << run;
  }
}

TEST_F(Render, MoreReferenceSamplesAgreeBetter) {
  const auto halves = [&](uint32_t samples) {
    SceneSource source(device, parseSceneRun("brick/still"), optionsOf({64, 48}, samples));
    source.reference(0);
    return source.references().halfAgainstHalfDb();
  };
  EXPECT_GT(halves(128), halves(16) + 6.0);
}

TEST_F(Render, AGaussianReferenceIsSofterThanABox) {
  SceneSourceOptions options = optionsOf({64, 48}, 128);
  SceneSource box(device, parseSceneRun("brick/still"), options);
  options.reference.filter = ReferenceFilter::kGaussian;
  SceneSource gaussian(device, parseSceneRun("brick/still"), options);
  EXPECT_LT(sharpnessAgainst(*box.reference(0), *gaussian.reference(0)), 0.95);
}

TEST_F(Render, ReferencesAreCachedExtendedAndRepaired) {
  const TemporaryDirectory cache;
  const auto open = [&](uint32_t samples) {
    SceneSourceOptions options = optionsOf({40, 24}, samples);
    options.reference.cache = cache.path();
    return SceneSource(device, parseSceneRun("brick/pan"), options);
  };
  const auto files = [&] {
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(cache.path())) {
      if (entry.is_regular_file()) paths.push_back(entry.path());
    }
    return paths;
  };
  SceneSource first = open(16);
  const FloatImage sixteen = *first.reference(1);
  EXPECT_EQ(first.references().samplesRendered(), 16u);
  ASSERT_EQ(files().size(), 1u);

  SceneSource again = open(16);
  EXPECT_EQ(again.reference(1)->texels, sixteen.texels);
  EXPECT_EQ(again.references().samplesRendered(), 0u);

  SceneSource more = open(64);
  const FloatImage sixty_four = *more.reference(1);
  EXPECT_EQ(more.references().samplesRendered(), 48u);
  SceneSource fresh(device, parseSceneRun("brick/pan"), optionsOf({40, 24}, 64));
  EXPECT_EQ(fresh.reference(1)->texels, sixty_four.texels);

  // Fewer samples than are cached: rendered for themselves, the file stays.
  SceneSource fewer = open(16);
  EXPECT_EQ(fewer.reference(1)->texels, sixteen.texels);
  EXPECT_EQ(open(64).reference(1)->texels, sixty_four.texels);

  std::filesystem::resize_file(files().front(), std::filesystem::file_size(files().front()) - 7);
  SceneSource damaged = open(64);
  std::string warning;
  damaged.references().setWarning([&](const std::string& line) { warning = line; });
  EXPECT_EQ(damaged.reference(1)->texels, sixty_four.texels);
  EXPECT_NE(warning.find("is damaged; rendering it anew"), std::string::npos);

  // Another frame is another file.
  damaged.reference(2);
  EXPECT_EQ(files().size(), 2u);
}

// The wall's edge stands in the middle of the frame: beyond it depth is 0 and the sky is seen.
TEST_F(Render, ShadingOnlyLeavesSilhouettesAndMovesShading) {
  const SceneRun run = parseSceneRun("chart/pan:vx=-101,vy=0");
  SceneSourceOptions options = optionsOf({96, 64});
  options.reference.filter = ReferenceFilter::kGaussian;
  SceneSource whole(device, run, options);
  options.switches.shading_only = true;
  options.reference.coverage = ReferenceCoverage::kCentre;
  SceneSource shading(device, run, options);

  const Rendered still = renderFrame(device, whole, 3);
  const Rendered jittered = renderFrame(device, shading, 3, 0.4f, -0.3f);
  EXPECT_EQ(jittered.inputs.jitter_px[0], 0.0f);
  EXPECT_EQ(jittered.depth.texels, still.depth.texels);
  EXPECT_EQ(jittered.motion.texels, still.motion.texels);
  const Rendered jittered_whole = renderFrame(device, whole, 3, 0.4f, -0.3f);
  const Rendered grid = renderFrame(device, shading, 3, 0.0f, 0.0f, 4);
  const Rendered grid_whole = renderFrame(device, whole, 3, 0.0f, 0.0f, 4);
  const FloatImage reference = *shading.reference(3);
  const FloatImage reference_whole = *whole.reference(3);

  const float* sky = still.color.at(95, 0);
  ASSERT_EQ(*still.depth.at(95, 0), 0.0f);
  const auto isSky = [&](const float* rgb) {
    return std::abs(rgb[0] - sky[0]) + std::abs(rgb[2] - sky[2]) < 1.0e-3f;
  };
  uint32_t mixed = 0;
  uint32_t compared = 0;
  for (uint32_t y = 0; y < 64; ++y) {
    for (uint32_t x = 0; x < 96; ++x) {
      const bool covered = *still.depth.at(x, y) > 0.0f;
      EXPECT_EQ(isSky(grid.color.at(x, y)), !covered) << x << " " << y;
      EXPECT_EQ(isSky(reference.at(x, y)), !covered) << x << " " << y;
      if (!covered && !isSky(grid_whole.color.at(x, y))) ++mixed;
      if (!covered && !isSky(reference_whole.at(x, y))) ++mixed;
      // Away from the edge a plane looks the same either way.
      if (x >= 40) continue;
      ++compared;
      for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(jittered.color.at(x, y)[c], jittered_whole.color.at(x, y)[c], 0.02f);
        EXPECT_NEAR(grid.color.at(x, y)[c], grid_whole.color.at(x, y)[c], 0.02f);
        EXPECT_NEAR(reference.at(x, y)[c], reference_whole.at(x, y)[c], 0.02f);
      }
    }
  }
  EXPECT_GT(mixed, 30u);
  EXPECT_GT(compared, 1000u);
}

TEST(ReferenceFile, DamageIsSeen) {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "a.ref";
  ReferenceSums sums;
  sums.samples_a_half = 4;
  for (FloatImage& half : sums.halves) {
    half = FloatImage(5, 3, 3);
    for (size_t i = 0; i < half.texels.size(); ++i) half.texels[i] = static_cast<float>(i);
  }
  ReferenceSums read;
  EXPECT_EQ(readReferenceFile(path, 5, 3, read), ReferenceFileState::kAbsent);
  ASSERT_TRUE(writeReferenceFile(path, sums));
  EXPECT_EQ(readReferenceFile(path, 5, 3, read), ReferenceFileState::kWhole);
  EXPECT_EQ(read.halves[1].texels, sums.halves[1].texels);
  EXPECT_EQ(readReferenceFile(path, 3, 5, read), ReferenceFileState::kDamaged);
  const std::string whole = readWholeFile(path);
  std::mt19937 random(3);
  for (int round = 0; round < 300; ++round) {
    std::string bytes = whole;
    bytes[random() % bytes.size()] ^= static_cast<char>(1 + random() % 255);
    std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
    EXPECT_EQ(readReferenceFile(path, 5, 3, read), ReferenceFileState::kDamaged) << round;
  }
  for (size_t size = 0; size < whole.size(); size += 7) {
    std::ofstream(path, std::ios::binary | std::ios::trunc) << whole.substr(0, size);
    EXPECT_EQ(readReferenceFile(path, 5, 3, read), ReferenceFileState::kDamaged) << size;
  }
  EXPECT_FALSE(writeReferenceFile("/proc/nowhere/a.ref", sums));
}

}  // namespace
}  // namespace reprise::lab
