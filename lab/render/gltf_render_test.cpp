// SPDX-License-Identifier: MIT
//
// glTF files as frames: which way up, how they move, and that what moves is lit as what stands.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "lab/capture/temporary_directory.h"
#include "lab/render/made_up_scene.h"
#include "lab/scene/gltf/made_up_gltf.h"

namespace reprise::lab {
namespace {

using Json = MadeUpGltf::Json;

class GltfFrames : public DeviceTest {
 protected:
  SceneRun runOf(const MadeUpGltf& made, const std::string& camera) const {
    return parseSceneRun("gltf:" + made.save(directory.path()).string() + "/" + camera);
  }
  TemporaryDirectory directory;
};

float green(const FloatImage& image, uint32_t x, uint32_t y) {
  return image.at(x, y)[1];
}

// Node 0 from `from` to `to` in a second.
void addMove(MadeUpGltf& made, std::vector<float> from, const std::vector<float>& to) {
  from.insert(from.end(), to.begin(), to.end());
  const int times = made.scalars({0, 1});
  const int values = made.vec3(from);
  made.json["animations"] = Json::array(
      {{{"samplers", {{{"input", times}, {"output", values}}}},
        {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}}});
}

TEST_F(GltfFrames, PicturesStandUpright) {
  MadeUpGltf made;
  // White above; below black to the left and dark to the right.
  FloatImage picture(16, 16, 3);
  for (uint32_t y = 0; y < 16; ++y) {
    for (uint32_t x = 0; x < 16; ++x) {
      for (int c = 0; c < 3; ++c) picture.at(x, y)[c] = y < 8 ? 1.0f : x < 8 ? 0.0f : 0.3f;
    }
  }
  const int texture = made.texture(picture);
  made.json["materials"] =
      Json::array({{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", texture}}}}},
                    {"extensions", {{"KHR_materials_unlit", Json::object()}}}}});
  made.node({{"mesh", made.quad(0)}});
  SceneSource source(device, runOf(made, "view:ez=3,ey=0,ty=0,tz=0,fov=50"), testOptions({64, 64}));
  const FloatImage image = colorOf(device, source);
  EXPECT_NEAR(green(image, 20, 20), 1.0f, 0.01f);
  EXPECT_NEAR(green(image, 44, 20), 1.0f, 0.01f);
  EXPECT_NEAR(green(image, 20, 44), 0.0f, 0.01f);
  EXPECT_NEAR(green(image, 44, 44), std::pow((0.3f + 0.055f) / 1.055f, 2.4f), 0.01f);
  EXPECT_GT(green(image, 1, 1), 0.1f);  // the background
}

TEST_F(GltfFrames, MotionIsThatOfTheAnimation) {
  MadeUpGltf made;
  made.node({{"mesh", made.quad()}});
  addMove(made, {0, 0, 0}, {3, 0, 0});
  SceneSource source(device, runOf(made, "view:ez=4,ey=0,ty=0,tz=0,fov=90"), testOptions({64, 64}));
  FrameInputs inputs;
  device.submitAndWait(
      [&](VkCommandBuffer commands) { inputs = source.frame(commands, 8, SamplePlan{}); });
  const FloatImage motion = download(device, *inputs.motion);
  // 3 m/s at 4 m: 64 px are 8 m. Motion points back to where the surface was.
  const float* here = motion.at(34, 32);
  EXPECT_NEAR(std::abs(here[0]), 3.0f / 60.0f / 8.0f * 64.0f, 1e-3f);
  EXPECT_NEAR(here[1], 0.0f, 1e-3f);
}

TEST_F(GltfFrames, MovingPartsAreLitAsStillOnes) {
  const auto frame = [&](bool moves) {
    MadeUpGltf made;
    const int mesh = made.quad();
    const float h = std::sin(0.39269908f);
    const float w = std::cos(0.39269908f);
    // Turned by 45 degrees about y, then squeezed along x: only right normals give the same.
    made.node({{"scale", {0.25, 1, 1}}, {"children", {1}}});
    made.node({{"rotation", {0, h, 0, w}}, {"mesh", mesh}});
    if (moves) addMove(made, {0, 0, 0}, {0, 0, 0});
    SceneSource source(device, runOf(made, "view:ez=3,ey=0,ty=0,tz=0"), testOptions({48, 48}));
    EXPECT_EQ(source.renderer().scene().geometry().instances.size(), 1u);
    return colorOf(device, source);
  };
  const FloatImage still = frame(false);
  const FloatImage moving = frame(true);
  float largest = 0.0f;
  for (size_t i = 0; i < still.texels.size(); ++i) {
    largest = std::max(largest, std::abs(still.texels[i] - moving.texels[i]));
  }
  EXPECT_LT(largest, 2e-3f);
}

TEST_F(GltfFrames, FilesOfTheDataAreSeen) {
  const char* root = std::getenv("REPRISE_DATA");
  for (const char* name : {"sponza", "bistro", "vegetation"}) {
    const std::string path =
        std::string(root == nullptr ? "" : root) + "/" + name + "/" + name + ".gltf";
    if (root == nullptr || !std::filesystem::exists(path)) {
      std::printf("skipped: %s is not below REPRISE_DATA\n", name);
      continue;
    }
    SceneSource source(device, parseSceneRun("gltf:" + path + "/path"), testOptions({64, 36}));
    const FloatImage image = colorOf(device, source);
    EXPECT_GT(source.takeEvaluations(), 64u * 36u / 3u) << name;
    for (const float value : image.texels) ASSERT_TRUE(std::isfinite(value)) << name;
  }
}

}  // namespace
}  // namespace reprise::lab
