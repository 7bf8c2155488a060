// SPDX-License-Identifier: MIT
//
// Shading below the pixels' rate: where samples lie, which pixels share them, how many there are.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

#include "lab/render/made_up_scene.h"

namespace reprise::lab {
namespace {

// A picture whose red is u and whose green is v, on a quad that fills the view of 32 x 32 pixels;
// before its left half a quad of another triangle pair.
MadeUp ramp() {
  MadeUp made;
  SceneImage picture{.width = 256, .height = 256, .role = ImageRole::kMask};
  for (uint32_t y = 0; y < 256; ++y) {
    for (uint32_t x = 0; x < 256; ++x) {
      for (const uint32_t c : {x, y, 0u, 255u}) picture.rgba.push_back(static_cast<uint8_t>(c));
    }
  }
  const uint32_t image = addImage(made.geometry, std::move(picture));
  made.geometry.materials.push_back({.parameters = {0.0f, 0.0f, 0.0f, 1.0f},
                                     .emission = {1.0f, 1.0f, 1.0f, 1.0f},
                                     .kind = kMaterialTextured,
                                     .emission_texture = image,
                                     .normal_scale = 1.0f});
  made.pose.eye_world = {0.0f, 0.0f, 1.0f};
  made.pose.target_world = {0.0f, 0.0f, 0.0f};
  made.pose.vertical_fov = 2.0f * std::atan(1.0f);  // 2 m are the view's height
  // v falls upwards: red and green grow with x and y of the screen.
  addQuad(made.geometry, {-1.0f, 1.0f, 0.0f}, {0.0f, -2.0f, 0.0f}, {2.0f, 0.0f, 0.0f}, {1.0f, 1.0f},
          0);
  for (GpuVertex& vertex : made.geometry.vertices) {
    std::swap(vertex.position_u.w, vertex.normal_v.w);
  }
  return made;
}

FloatImage shaded(Device& device, SceneSource& source, const RepriseSamplePlan& asked) {
  SamplePlan plan;
  plan.library = asked;
  source.prepare(plan);
  FrameInputs inputs;
  device.submitAndWait([&](VkCommandBuffer commands) { inputs = source.frame(commands, 0, plan); });
  return download(device, *inputs.color);
}

class Coarse : public DeviceTest {};

TEST_F(Coarse, PixelsShareTheSampleAtTheirCoarseCentre) {
  constexpr uint32_t kSide = 32;
  SceneSource source(device, madeUpRun<ramp>(), testOptions({kSide, kSide}));
  for (const uint32_t size : {2u, 3u, 4u}) {
    for (const int32_t origin : {0, 1}) {
      RepriseSamplePlan plan{.size = sizeof(plan), .jitter_px = {0.3f, -0.2f}, .coarse_size = size};
      plan.coarse_origin_px[0] = origin;
      plan.mip_bias = -std::log2(static_cast<float>(size));
      const FloatImage image = shaded(device, source, plan);
      // The quad's diagonal runs from the upper left; with this jitter pixels on it see the lower
      // triangle. One evaluation a coarse pixel and triangle.
      std::set<std::array<uint32_t, 3>> seen;
      for (uint32_t y = 0; y < kSide; ++y) {
        for (uint32_t x = 0; x < kSide; ++x) {
          const uint32_t block_x = (x + size - static_cast<uint32_t>(origin)) / size;
          seen.insert({block_x, y / size, y >= x ? 1u : 0u});
          const auto center_x = static_cast<float>(block_x * size + static_cast<uint32_t>(origin)) -
                                0.5f * static_cast<float>(size);
          const float center_y = (static_cast<float>(y / size) + 0.5f) * static_cast<float>(size);
          // Linear between texel centres, half a texel short of each edge.
          const float u = (center_x - 0.3f) / kSide;
          const float v = (center_y + 0.2f) / kSide;
          if (u < 0.05f || u > 0.95f || v < 0.05f || v > 0.95f) continue;
          EXPECT_NEAR(image.at(x, y)[0], (u * 256.0f - 0.5f) / 255.0f, 4.0e-3f) << x << ", " << y;
          EXPECT_NEAR(image.at(x, y)[1], (v * 256.0f - 0.5f) / 255.0f, 4.0e-3f) << x << ", " << y;
        }
      }
      EXPECT_EQ(source.takeEvaluations(), seen.size());
    }
  }
}

TEST_F(Coarse, MayBeShadedAmidThePixelsThatATriangleCovers) {
  constexpr uint32_t kSide = 32;
  SceneSource source(device, madeUpRun<ramp>(), testOptions({kSide, kSide}));
  RepriseSamplePlan plan{.size = sizeof(plan), .jitter_px = {0.3f, -0.2f}, .coarse_size = 2};
  plan.coarse_covered = 1;
  plan.mip_bias = -1.0f;
  const FloatImage image = shaded(device, source, plan);
  // Of four pixels on the diagonal the upper triangle has the upper right one; the lower one's
  // three have their middle at (5/6, 7/6).
  for (uint32_t base = 4; base < kSide - 4; base += 2) {
    const struct {
      uint32_t x, y;
      float middle_x_px, middle_y_px;
    } pixels[] = {{1, 0, 1.5f, 0.5f}, {0, 0, 0.8333f, 1.1667f}, {1, 1, 0.8333f, 1.1667f}};
    for (const auto& pixel : pixels) {
      const float u = (static_cast<float>(base) + pixel.middle_x_px - 0.3f) / kSide;
      const float v = (static_cast<float>(base) + pixel.middle_y_px + 0.2f) / kSide;
      const float* rgb = image.at(base + pixel.x, base + pixel.y);
      EXPECT_NEAR(rgb[0], (u * 256.0f - 0.5f) / 255.0f, 4.0e-3f) << base << ", " << pixel.x;
      EXPECT_NEAR(rgb[1], (v * 256.0f - 0.5f) / 255.0f, 4.0e-3f) << base << ", " << pixel.x;
    }
  }
}

TEST_F(Coarse, LeavesNoPixelOfAnyExtentOut) {
  for (const VkExtent2D extent : {VkExtent2D{1, 1}, {17, 133}, {131, 9}, {66, 66}}) {
    SceneSource source(device, parseSceneRun("brick/still"), testOptions(extent));
    for (const uint32_t size : {2u, 3u, 4u}) {
      RepriseSamplePlan plan{.size = sizeof(plan), .coarse_size = 1};
      plan.checkerboard = 1;
      shaded(device, source, plan);  // alpha 0 in every other pixel
      plan.checkerboard = 0;
      plan.coarse_size = size;
      plan.coarse_origin_px[0] = plan.coarse_origin_px[1] = 1;
      source.takeEvaluations();
      const FloatImage image = shaded(device, source, plan);
      const uint64_t coarse_pixels =
          uint64_t{(extent.width + 2 * size - 2) / size} * ((extent.height + 2 * size - 2) / size);
      const uint64_t evaluations = source.takeEvaluations();
      EXPECT_GE(evaluations, coarse_pixels);
      EXPECT_LE(evaluations, uint64_t{extent.width} * extent.height);
      for (uint32_t y = 0; y < extent.height; ++y) {
        for (uint32_t x = 0; x < extent.width; ++x) {
          EXPECT_EQ(image.at(x, y)[3], 1.0f) << size << ": " << x << ", " << y;
          EXPECT_GT(image.at(x, y)[0], 0.0f) << size << ": " << x << ", " << y;
        }
      }
    }
  }
}

TEST_F(Coarse, ACheckerboardShadesItsHalfAndNothingElse) {
  const VkExtent2D extent{33, 17};
  SceneSource source(device, parseSceneRun("brick/still"), testOptions(extent));
  RepriseSamplePlan plan{.size = sizeof(plan), .jitter_px = {0.2f, 0.1f}, .coarse_size = 1};
  plan.mip_bias = 0.0f;
  const FloatImage full = shaded(device, source, plan);
  source.takeEvaluations();
  plan.mip_bias = -1.0f;  // for derivatives of half the resolution
  for (const uint32_t half : {1u, 2u}) {
    plan.checkerboard = half;
    const FloatImage image = shaded(device, source, plan);
    EXPECT_EQ(source.takeEvaluations(), half == 1 ? 281u : 280u);  // of 561
    for (uint32_t y = 0; y < extent.height; ++y) {
      for (uint32_t x = 0; x < extent.width; ++x) {
        const bool here = (x + y) % 2 == half - 1;
        EXPECT_EQ(image.at(x, y)[3], here ? 1.0f : 0.0f);
        EXPECT_EQ(image.at(x, y)[1], here ? full.at(x, y)[1] : 0.0f) << x << ", " << y;
      }
    }
  }
}

TEST_F(Coarse, SavesByWhatTrianglesLeave) {
  // Small ones on a frame of odd size: between a quarter and all of the pixels.
  SceneSource source(device, parseSceneRun("teapot/still"), testOptions({97, 55}));
  RepriseSamplePlan plan{.size = sizeof(plan), .coarse_size = 2};
  shaded(device, source, plan);
  const uint64_t coarse = source.takeEvaluations();
  plan.coarse_size = 1;
  shaded(device, source, plan);
  const uint64_t pixels = source.takeEvaluations();
  EXPECT_LT(coarse, pixels);
  EXPECT_GT(coarse, pixels / 4);
}

}  // namespace
}  // namespace reprise::lab
