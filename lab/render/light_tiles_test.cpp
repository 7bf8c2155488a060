// SPDX-License-Identifier: MIT
//
// Binning lamps to tiles saves work and changes nothing else.
#include "lab/render/light_tiles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <numeric>

#include "lab/render/made_up_scene.h"
#include "lab/scene/scattered_lamps.h"

namespace reprise::lab {
namespace {

struct Lit {
  FloatImage image;
  double lamps_a_tile = 0.0;
};

// A scene under lamps; its pipelines, which cost most of a test, are made once.
class LitScene {
 public:
  LitScene(Device& device, const std::string& run, VkExtent2D extent, uint32_t lamps, bool cull)
      : device_(device), source_(device, parseSceneRun(run), options(extent, lamps, cull)) {}

  Lit frame(const RepriseSamplePlan& asked) {
    SamplePlan plan;
    plan.library = asked;
    source_.prepare(plan);
    FrameInputs inputs;
    device_.submitAndWait(
        [&](VkCommandBuffer commands) { inputs = source_.frame(commands, 3, plan); });
    const std::vector<uint32_t> counts = source_.renderer().lightTiles().counts();
    const double sum = std::accumulate(counts.begin(), counts.end(), 0.0);
    return {download(device_, *inputs.color),
            sum / static_cast<double>(std::max<size_t>(counts.size(), 1))};
  }

 private:
  static SceneSourceOptions options(VkExtent2D extent, uint32_t lamps, bool cull) {
    SceneSourceOptions options = testOptions(extent);
    options.switches.lamps = lamps;
    options.switches.cull_lamps = cull;
    return options;
  }

  Device& device_;
  SceneSource source_;
};

double differing(const FloatImage& a, const FloatImage& b) {
  size_t count = 0;
  for (size_t i = 0; i < a.texelCount(); ++i) {
    count += std::memcmp(&a.texels[4 * i], &b.texels[4 * i], 3 * sizeof(float)) != 0 ? 1 : 0;
  }
  return static_cast<double>(count) / static_cast<double>(a.texelCount());
}

class LightTilesTest : public DeviceTest {};

TEST_F(LightTilesTest, TilesShowWhatEveryLampShows) {
  LitScene tiles(device, "lights/dolly", {149, 83}, kMaxLamps, true);
  LitScene every(device, "lights/dolly", {149, 83}, kMaxLamps, false);
  for (const auto& [size, half] : {std::pair(1u, 0u), {2u, 0u}, {4u, 0u}, {1u, 1u}}) {
    SCOPED_TRACE("size " + std::to_string(size) + ", half " + std::to_string(half));
    RepriseSamplePlan plan{.size = sizeof(plan), .jitter_px = {0.45f, -0.4f}, .coarse_size = size};
    plan.coarse_origin_px[0] = plan.coarse_origin_px[1] = size > 1 ? 1 : 0;
    plan.checkerboard = half;
    const Lit tiled = tiles.frame(plan);
    const Lit all = every.frame(plan);
    EXPECT_EQ(all.lamps_a_tile, static_cast<double>(kMaxLamps));
    EXPECT_LT(tiled.lamps_a_tile, 0.5 * kMaxLamps);
    EXPECT_GT(tiled.lamps_a_tile, 1.0);
    // A pixel at its own sample lies within the bounds that its depth made. Coarse pixels are
    // extrapolated along planes that a tile knows from depths alone: one pixel in 12367 differs,
    // without the slopes of depths 16 and 31.
    EXPECT_LE(differing(tiled.image, all.image), size == 1 ? 0.0 : 2.0e-4);
  }
}

TEST_F(LightTilesTest, LampsLightTheScene) {
  const RepriseSamplePlan plan{.size = sizeof(plan), .coarse_size = 1};
  const auto mean = [&](uint32_t lamps) {
    const FloatImage image =
        LitScene(device, "lights/still", {64, 36}, lamps, true).frame(plan).image;
    double sum = 0.0;
    for (size_t i = 0; i < image.texelCount(); ++i) sum += image.texels[4 * i + 1];
    return sum / static_cast<double>(image.texelCount());
  };
  const double none = mean(0);
  const double some = mean(64);
  EXPECT_GT(some, 1.1 * none);
  EXPECT_GT(mean(512), 1.5 * some);
}

TEST_F(LightTilesTest, SmallFramesHaveTiles) {
  const RepriseSamplePlan plan{.size = sizeof(plan), .coarse_size = 1};
  for (const VkExtent2D extent : {VkExtent2D{1, 1}, VkExtent2D{17, 1}, VkExtent2D{16, 33}}) {
    const Lit tiled = LitScene(device, "brick/still", extent, 100, true).frame(plan);
    const Lit all = LitScene(device, "brick/still", extent, 100, false).frame(plan);
    EXPECT_EQ(differing(tiled.image, all.image), 0.0);
  }
}

TEST(ScatteredLamps, AreTheSameForEveryNumber) {
  const std::unique_ptr<Scene> scene = parseSceneRun("lights/still").scene->create();
  const std::vector<GpuLamp> many = scatteredLamps(*scene, kMaxLamps);
  const std::vector<GpuLamp> few = scatteredLamps(*scene, 32);
  ASSERT_EQ(many.size(), kMaxLamps);
  ASSERT_EQ(few.size(), 32u);
  EXPECT_EQ(std::memcmp(many.data(), few.data(), few.size() * sizeof(GpuLamp)), 0);
  for (const GpuLamp& lamp : many) {
    EXPECT_GT(lamp.position_range.w, 0.0f);
    EXPECT_NEAR(glm::length(glm::vec3(lamp.direction_outer)), 1.0f, 1e-5f);
    EXPECT_LT(lamp.direction_outer.w, lamp.color_inner.w);
  }
  EXPECT_TRUE(scatteredLamps(*scene, 0).empty());
}

TEST(ScatteredLamps, ReachFartherAtTheSameIntensity) {
  const std::unique_ptr<Scene> scene = parseSceneRun("lights/still").scene->create();
  const std::vector<GpuLamp> usual = scatteredLamps(*scene, 32);
  const std::vector<GpuLamp> wide = scatteredLamps(*scene, 32, 2.0f);
  ASSERT_EQ(wide.size(), usual.size());
  for (size_t i = 0; i < usual.size(); ++i) {
    EXPECT_EQ(wide[i].position_range, usual[i].position_range * glm::vec4(1.0f, 1.0f, 1.0f, 2.0f));
    EXPECT_EQ(wide[i].color_inner, usual[i].color_inner);
  }
}

}  // namespace
}  // namespace reprise::lab
