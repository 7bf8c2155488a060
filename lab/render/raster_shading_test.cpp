// SPDX-License-Identifier: MIT
//
// Shading by fragments beside shading by compute: the same images, the same counts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "lab/render/made_up_scene.h"

namespace reprise::lab {
namespace {

struct Shot {
  FloatImage image;
  uint64_t evaluations = 0;
};

SamplePlan planOf(const RepriseSamplePlan& asked) {
  SamplePlan plan;
  plan.library = asked;
  return plan;
}

Shot taken(Device& device, SceneSource& source) {
  FloatImage image = download(device, source.renderer().color());
  return {std::move(image), source.takeEvaluations()};
}

Shot shoot(Device& device, SceneSource& source, const RepriseSamplePlan& asked, uint32_t index) {
  const SamplePlan plan = planOf(asked);
  source.prepare(plan);
  source.takeEvaluations();
  device.submitAndWait([&](VkCommandBuffer commands) { source.frame(commands, index, plan); });
  return taken(device, source);
}

// The frame that was shot, once more.
Shot shootByCompute(Device& device, SceneSource& source, const RepriseSamplePlan& asked) {
  const SamplePlan plan = planOf(asked);
  source.prepareCompute(plan);
  device.submitAndWait([&](VkCommandBuffer commands) { source.shadeByCompute(commands, plan); });
  return taken(device, source);
}

SceneSourceOptions optionsBy(ShadeBy shade_by, VkExtent2D extent) {
  SceneSourceOptions options = testOptions(extent);
  options.switches.shade_by = shade_by;
  return options;
}

// Of a difference of `a` and `b`, in steps of half precision at that value: both are rounded to it,
// compute by its store and fragments by the attachment's conversion.
float stepsApart(float a, float b) {
  if (a == b) return 0.0f;
  const float step =
      std::ldexp(1.0f, std::max(-24, std::ilogb(std::max(std::abs(a), std::abs(b))) - 10));
  return std::abs(a - b) / step;
}

struct Apart {
  float most_steps = 0.0f;
  size_t pixels = 0;  // that differ at all
};

Apart apart(const FloatImage& a, const FloatImage& b) {
  Apart found;
  for (size_t i = 0; i < a.texelCount(); ++i) {
    float steps = 0.0f;
    for (size_t c = 0; c < 4; ++c) {
      steps = std::max(steps, stepsApart(a.texels[4 * i + c], b.texels[4 * i + c]));
    }
    found.most_steps = std::max(found.most_steps, steps);
    if (steps > 0.0f) ++found.pixels;
  }
  return found;
}

// Quads one in another, so that every pixel has two triangles of one depth.
MadeUp twins() {
  MadeUp made;
  made.geometry.materials.push_back({.parameters = {0.0f, 0.0f, 0.0f, 1.0f},
                                     .emission = {0.25f, 0.5f, 0.75f, 1.0f},
                                     .kind = kMaterialTextured,
                                     .normal_scale = 1.0f});
  made.geometry.materials.push_back(made.geometry.materials[0]);
  made.geometry.materials[1].emission = {1.0f, 0.0f, 0.0f, 1.0f};
  made.pose.eye_world = {0.0f, 0.0f, 1.0f};
  made.pose.target_world = {0.0f, 0.0f, 0.0f};
  made.pose.vertical_fov = 2.0f * std::atan(1.0f);
  for (const uint32_t material : {0u, 1u}) {
    addQuad(made.geometry, {-0.7f, -0.7f, 0.0f}, {1.4f, 0.0f, 0.0f}, {0.0f, 1.4f, 0.0f},
            {1.0f, 1.0f}, material);
  }
  return made;
}

class RasterShadingTest : public DeviceTest {};

TEST_F(RasterShadingTest, AtFullRateIsWhatComputeShades) {
  // Several materials, holes and a shadow, lamps; a frame of odd size.
  for (const char* run : {"hangar/fly", "foliage/walk", "lights/dolly"}) {
    SceneSource compute(device, parseSceneRun(run), optionsBy(ShadeBy::kCompute, {97, 55}));
    SceneSource raster(device, parseSceneRun(run), optionsBy(ShadeBy::kRaster, {97, 55}));
    RepriseSamplePlan plan{.size = sizeof(plan), .jitter_px = {0.3f, -0.2f}, .coarse_size = 1};
    for (const uint32_t offset : {0u, 1u}) {
      plan.shading_offset =
          offset != 0 ? REPRISE_SHADING_OFFSET_HASH_GAUSSIAN : REPRISE_SHADING_OFFSET_NONE;
      plan.shading_offset_sigma_px = 0.4737f;
      plan.shading_offset_seed = 7;
      const Shot by_compute = shoot(device, compute, plan, 3);
      const Shot by_raster = shoot(device, raster, plan, 3);
      EXPECT_EQ(by_raster.evaluations, by_compute.evaluations) << run;
      EXPECT_GT(by_raster.evaluations, 0u) << run;
      const Apart found = apart(by_compute.image, by_raster.image);
      EXPECT_LE(found.most_steps, 1.0f) << run << ", offset " << offset;
    }
  }
}

TEST_F(RasterShadingTest, OfTwoTrianglesOfOneDepthOneIsShaded) {
  SceneSource compute(device, madeUpRun<twins>(), optionsBy(ShadeBy::kCompute, {40, 40}));
  SceneSource raster(device, madeUpRun<twins>(), optionsBy(ShadeBy::kRaster, {40, 40}));
  const RepriseSamplePlan plan{.size = sizeof(plan), .coarse_size = 1};
  const Shot by_compute = shoot(device, compute, plan, 0);
  const Shot by_raster = shoot(device, raster, plan, 0);
  EXPECT_EQ(by_raster.evaluations, by_compute.evaluations);
  EXPECT_EQ(by_raster.evaluations, 28u * 28u);
  EXPECT_LE(apart(by_compute.image, by_raster.image).most_steps, 1.0f);
}

TEST_F(RasterShadingTest, SaysWhatItCannotShade) {
  SceneSource raster(device, parseSceneRun("brick/still"), optionsBy(ShadeBy::kRaster, {32, 32}));
  const auto said = [&](const SamplePlan& plan) -> std::string {
    try {
      raster.prepare(plan);
    } catch (const std::exception& error) {
      return error.what();
    }
    return "";
  };
  SamplePlan plan;
  EXPECT_EQ(said(plan), "");
  plan.library.checkerboard = 1;
  EXPECT_EQ(said(plan), "--shade-by raster cannot shade a checkerboard");
  plan = {};
  plan.grid = 2;
  EXPECT_EQ(said(plan), "--shade-by raster cannot shade several samples a pixel");
  plan = {};
  plan.library.coarse_size = 3;  // no device has such fragments
  EXPECT_EQ(said(plan), "device '" + device.name() +
                            "' has no VK_KHR_fragment_shading_rate with 3 x 3 pixels a fragment; "
                            "--shade-by compute needs none");
}

// Holes, large and small triangles, at all places of the grid, on a frame that ends within a coarse
// pixel. Skipped where fragments are pixels: raster_shading_coarse_test runs it on every device, by
// tests/fragment_rate_layer.cpp.
TEST_F(RasterShadingTest, CoarseFragmentsAreCoarsePixels) {
  if (!device.hasFragmentSize(2)) {
    GTEST_SKIP() << "device '" << device.name() << "' has no fragments of 2 x 2 pixels";
  }
  for (const char* run : {"foliage/walk", "lights/dolly", "teapot/orbit"}) {
    SceneSource source(device, parseSceneRun(run), optionsBy(ShadeBy::kRaster, {97, 55}));
    RepriseSamplePlan plan{.size = sizeof(plan), .jitter_px = {0.3f, -0.2f}, .coarse_size = 1};
    const uint64_t pixels = shoot(device, source, plan, 3).evaluations;
    plan.coarse_size = 2;
    plan.mip_bias = -1.0f;
    for (uint32_t i = 0; i < 8; ++i) {
      plan.coarse_origin_px[0] = static_cast<int32_t>(i & 1);
      plan.coarse_origin_px[1] = static_cast<int32_t>(i >> 1 & 1);
      plan.coarse_covered = i >> 2;
      const Shot by_raster = shoot(device, source, plan, 3);
      const Shot by_compute = shootByCompute(device, source, plan);
      EXPECT_LE(apart(by_compute.image, by_raster.image).most_steps, 1.0f) << run << ", " << i;
      // A device may shade finer than it is asked to, but not coarser.
      EXPECT_GE(by_raster.evaluations, by_compute.evaluations) << run << ", " << i;
      EXPECT_LE(by_raster.evaluations, pixels) << run << ", " << i;
    }
  }
}

}  // namespace
}  // namespace reprise::lab
