// SPDX-License-Identifier: MIT
#include "lab/render/shadow_map.h"

#include <cmath>

#include "lab/render/made_up_scene.h"

namespace reprise::lab {
namespace {

const glm::vec3 kTowards = glm::normalize(glm::vec3(0.5f, -1.0f, 0.3f));
constexpr float kEye_m = 8.0f;
constexpr VkExtent2D kExtent{128, 128};
// Half an edge's softness: the filter reaches two texels of 8 mm, an edge of alpha 16 mm more.
constexpr float kMargin_m = 0.06f;

// A white floor of 8 m x 8 m seen from above, u to the right (x), v up (-z).
MadeUp floorUnderSun() {
  MadeUp scene;
  scene.geometry.materials.push_back(
      {.parameters = {1.0f, 1.0f, 1.0f, 1.0f}, .kind = kMaterialTextured});
  addQuad(scene.geometry, {-4.0f, 0.0f, 4.0f}, {8.0f, 0.0f, 0.0f}, {0.0f, 0.0f, -8.0f}, {1, 1}, 0);
  scene.lights = {.lights = {sunLight(kTowards, glm::vec3(1.0f), true)}, .shadow_radius_m = 8.0f};
  scene.pose = {.eye_world = {0.0f, kEye_m, 0.0f},
                .target_world = {0.0f, 0.0f, 0.0f},
                .up_world = {0.0f, 0.0f, -1.0f},
                .vertical_fov = 0.8f};
  return scene;
}

// A box from (-0.5, 1, -0.5) to (0.5, 2, 0.5).
constexpr float kBoxHalf_m = 0.5f;
MadeUp boxOverFloor() {
  MadeUp scene = floorUnderSun();
  const float h = kBoxHalf_m;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-h, h}) {
      glm::vec3 corner(-h);
      glm::vec3 u(0.0f);
      glm::vec3 v(0.0f);
      corner[axis] = side;
      u[(axis + 1) % 3] = 2.0f * h;
      v[(axis + 2) % 3] = 2.0f * h;
      addQuad(scene.geometry, corner + glm::vec3(0.0f, 1.5f, 0.0f), u, v, {1, 1}, 0);
    }
  }
  return scene;
}

// A level card of 1 m x 1 m at 1.5 m; its half of x < 0 is a hole.
MadeUp halfCardOverFloor() {
  MadeUp scene = floorUnderSun();
  SceneImage image{64, 64, ImageRole::kColor, 0.5f, std::vector<uint8_t>(4 * 64 * 64, 255)};
  for (uint32_t i = 0; i < 64 * 64; ++i) image.rgba[4 * i + 3] = i % 64 < 32 ? 0 : 255;
  scene.geometry.materials.push_back({.parameters = {1.0f, 1.0f, 1.0f, 1.0f},
                                      .kind = kMaterialTextured,
                                      .color_texture = addImage(scene.geometry, image),
                                      .alpha_cutoff = 0.5f});
  addQuad(scene.geometry, {-0.5f, 1.5f, 0.5f}, {1.0f, 0.0f, 0.0f}, {0.0f, 0.0f, -1.0f}, {1, 1}, 1);
  return scene;
}

// Whether the segment from `from` along `way` meets the box, grown by `margin_m`.
bool meetsBox(glm::vec3 from, glm::vec3 way, glm::vec3 low, glm::vec3 high, float margin_m) {
  float enter = 0.0f;
  float leave = 1.0e9f;
  for (int c = 0; c < 3; ++c) {
    const float a = (low[c] - margin_m - from[c]) / way[c];
    const float b = (high[c] + margin_m - from[c]) / way[c];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter < leave;
}

struct Judged {
  uint32_t shaded = 0;
  uint32_t lit = 0;
};

// Compares every pixel of the floor with the ray to the sun; pixels near an edge may be either.
Judged judge(const FloatImage& image, glm::vec3 low, glm::vec3 high) {
  Judged judged;
  const float reach = kEye_m * std::tan(0.4f);
  for (uint32_t y = 0; y < image.height; ++y) {
    for (uint32_t x = 0; x < image.width; ++x) {
      const glm::vec3 floor(((x + 0.5f) / image.width * 2.0f - 1.0f) * reach, 0.0f,
                            ((y + 0.5f) / image.height * 2.0f - 1.0f) * reach);
      const glm::vec3 eye(0.0f, kEye_m, 0.0f);
      if (meetsBox(eye, glm::normalize(floor - eye) + 1.0e-6f, low, high, 0.1f)) continue;
      const float white = -kTowards.y * 0.9f;  // of a lit floor, but for the highlight
      const bool inside = meetsBox(floor, -kTowards, low, high, -kMargin_m);
      const bool outside = !meetsBox(floor, -kTowards, low, high, kMargin_m);
      if (inside) {
        EXPECT_LT(image.at(x, y)[0], 0.01f) << x << ", " << y;
        ++judged.shaded;
      } else if (outside) {
        EXPECT_GT(image.at(x, y)[0], white) << x << ", " << y;
        ++judged.lit;
      }
      if (testing::Test::HasFailure()) return judged;
    }
  }
  return judged;
}

// The box over the floor, and one thing that changes as time goes.
enum class Moves { kNothing, kBox, kSun, kCamera, kWind };
template <Moves kMoves>
SceneRun movingRun() {
  class MovingScene final : public Scene {
   public:
    MovingScene() {
      if (kMoves == Moves::kWind) {
        // The box alone: the floor's four vertices are stiff.
        all_.geometry.sways.resize(all_.geometry.vertices.size());
        for (size_t i = 4; i < all_.geometry.vertices.size(); ++i) {
          all_.geometry.sways[i].push = {0.4f, 0.2f, 0.0f, 0.0f};
        }
      }
    }
    const Geometry& geometry() const override { return all_.geometry; }
    glm::mat4 transform(uint32_t instance, double time_s) const override {
      glm::mat4 world(1.0f);
      if (kMoves == Moves::kBox && instance > 0) world[3].x = static_cast<float>(time_s);
      return world;
    }
    CameraPose camera(std::string_view, const CameraValues&, double time_s,
                      uint32_t) const override {
      CameraPose pose = all_.pose;
      if (kMoves == Moves::kCamera) {
        pose.eye_world.x += static_cast<float>(time_s);
        pose.target_world.x += static_cast<float>(time_s);
      }
      return pose;
    }
    SceneLights lights(double time_s) const override {
      SceneLights lights = all_.lights;
      if (kMoves == Moves::kSun) {
        const glm::vec3 towards = kTowards + glm::vec3(static_cast<float>(time_s), 0.0f, 0.0f);
        lights.lights = {sunLight(towards, glm::vec3(1.0f), true)};
      }
      return lights;
    }
    glm::vec3 wind_world(double) const override {
      return {kMoves == Moves::kWind ? 1.0f : 0.0f, 0.0f, 0.0f};
    }

   private:
    MadeUp all_ = boxOverFloor();
  };
  static const SceneInfo info{
      .name = "moving", .content = "", .cameras = {{"still", "", {}, std::nullopt}}, .create = [] {
        return std::unique_ptr<Scene>(std::make_unique<MovingScene>());
      }};
  return {.name = "moving/still", .scene = &info, .camera = &info.cameras[0], .values = {}};
}

using Shadows = DeviceTest;

// Frames of one renderer against those of renderers that made their first map for them.
void expectEveryFramesOwnMap(Device& device, const SceneRun& run, bool kept) {
  const SceneSourceOptions options = testOptions(kExtent);
  SceneSource source(device, run, options);
  FloatImage first;
  for (const uint32_t index : {0u, 9u}) {
    const FloatImage image = colorOf(device, source, index);
    if (index == 0) first = image;
    EXPECT_EQ(image.texels == first.texels, kept || index == 0) << index;
    SceneSource fresh(device, run, options);
    EXPECT_TRUE(image.texels == colorOf(device, fresh, index).texels) << index;
    const ShadowMap& map = source.renderer().shadowMap();
    EXPECT_TRUE(download(device, map.image()).texels ==
                download(device, fresh.renderer().shadowMap().image()).texels)
        << index;
    // By others who render the same frame, and in the next.
    EXPECT_EQ(map.isKept(), kept && index > 0) << index;
    source.renderer().setFrame(index + 1, 0.0f);
    EXPECT_EQ(map.isKept(), kept) << index;
  }
}

TEST_F(Shadows, OfWhatStandsStillAreKept) {
  expectEveryFramesOwnMap(device, movingRun<Moves::kNothing>(), true);
}

TEST_F(Shadows, OfWhatMovesAreNeverAnotherFrames) {
  expectEveryFramesOwnMap(device, movingRun<Moves::kBox>(), false);
  expectEveryFramesOwnMap(device, movingRun<Moves::kSun>(), false);
  expectEveryFramesOwnMap(device, movingRun<Moves::kCamera>(), false);
  expectEveryFramesOwnMap(device, movingRun<Moves::kWind>(), false);
}

TEST_F(Shadows, OfABoxFallsWhereGeometrySays) {
  SceneSource source(device, madeUpRun<boxOverFloor>(), testOptions(kExtent));
  const Judged judged = judge(colorOf(device, source), {-0.5f, 1.0f, -0.5f}, {0.5f, 2.0f, 0.5f});
  EXPECT_GT(judged.shaded, 200u);
  EXPECT_GT(judged.lit, 10000u);
}

TEST_F(Shadows, LightPassesThroughHoles) {
  SceneSource source(device, madeUpRun<halfCardOverFloor>(), testOptions(kExtent));
  const Judged judged = judge(colorOf(device, source), {0.0f, 1.5f - 2.0f * kMargin_m, -0.5f},
                              {0.5f, 1.5f + 2.0f * kMargin_m, 0.5f});
  EXPECT_GT(judged.shaded, 100u);
  EXPECT_GT(judged.lit, 10000u);
}

TEST(SunView, StaysOnItsGridWhenTheBallMoves) {
  const Ball casters{{0.0f, 2.0f, 0.0f}, 20.0f};
  const glm::vec4 fixed(1.3f, 0.2f, -0.7f, 1.0f);
  const SunView first = sunView(kTowards, {{0.0f, 0.0f, 0.0f}, 10.0f}, casters, 1024);
  for (const float step : {0.013f, 0.4f, 3.17f}) {
    const SunView moved =
        sunView(kTowards, {{step, 0.3f * step, -0.7f * step}, 10.0f}, casters, 1024);
    for (int axis = 0; axis < 2; ++axis) {
      const float texels = ((moved.matrix * fixed)[axis] - (first.matrix * fixed)[axis]) * 512.0f;
      EXPECT_NEAR(texels, std::round(texels), 2.0e-3f);
    }
    EXPECT_EQ(moved.texel_m, first.texel_m);
  }
}

TEST(SunView, HoldsReceiversAndEveryCasterBeforeThem) {
  const Ball receivers{{3.0f, 1.0f, -2.0f}, 5.0f};
  const Ball casters{{0.0f, 4.0f, 0.0f}, 30.0f};
  const SunView view = sunView(kTowards, receivers, casters, 512);
  const float texel = 2.0f / 512.0f;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-4.99f, 4.99f}) {
      glm::vec3 p = receivers.center_world;
      p[axis] += side;
      const glm::vec4 clip = view.matrix * glm::vec4(p, 1.0f);
      EXPECT_LE(std::abs(clip.x), 1.0f + texel);
      EXPECT_LE(std::abs(clip.y), 1.0f + texel);
      EXPECT_GE(clip.z, 0.0f);
      EXPECT_LE(clip.z, 1.0f);
    }
  }
  const glm::vec3 highest = casters.center_world - 29.9f * kTowards;
  EXPECT_GE((view.matrix * glm::vec4(highest, 1.0f)).z, 0.0f);
}

}  // namespace
}  // namespace reprise::lab
