// SPDX-License-Identifier: MIT
//
// glTF files under random damage, text and bytes: they open or throw SceneFileError, nothing else.
// Seeds are fixed; REPRISE_FUZZ_ROUNDS raises the number of rounds.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>

#include "lab/capture/temporary_directory.h"
#include "lab/scene/gltf/gltf_scene.h"
#include "lab/scene/gltf/made_up_gltf.h"
#include "lab/scene/gltf/scene_file_error.h"

namespace reprise::lab {
namespace {

using Json = MadeUpGltf::Json;

int rounds(int otherwise) {
  const char* text = std::getenv("REPRISE_FUZZ_ROUNDS");
  return text != nullptr ? std::atoi(text) : otherwise;
}

MadeUpGltf everything() {
  MadeUpGltf made;
  const int picture = made.texture(plainPicture(8, 4, {0.3f, 0.6f, 0.9f}));
  made.json["materials"] =
      Json::array({{{"pbrMetallicRoughness",
                     {{"baseColorTexture",
                       {{"index", picture},
                        {"extensions", {{"KHR_texture_transform", {{"offset", {0.5, 0.25}}}}}}}},
                      {"metallicRoughnessTexture", {{"index", picture}}}}},
                    {"normalTexture", {{"index", picture}}},
                    {"occlusionTexture", {{"index", picture}}},
                    {"alphaMode", "MASK"}}});
  const int mesh = made.quad(0);
  made.node({{"children", {1, 2, 3}}, {"scale", {1, 2, 1}}});
  made.node({{"mesh", mesh}});
  made.json["cameras"] =
      Json::array({{{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.01}}}}});
  made.node({{"camera", 0}, {"name", "eye"}});
  made.json["extensions"]["KHR_lights_punctual"]["lights"] =
      Json::array({{{"type", "spot"}, {"intensity", 500}, {"spot", {{"outerConeAngle", 0.5}}}}});
  made.node(
      {{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}, {"translation", {0, 1, 2}}});
  const int times = made.scalars({0, 1});
  const int values = made.vec3({0, 0, 0, 1, 0, 0});
  made.json["animations"] = Json::array(
      {{{"samplers", {{{"input", times}, {"output", values}}}},
        {"channels", {{{"sampler", 0}, {"target", {{"node", 1}, {"path", "translation"}}}}}}}});
  return made;
}

// Opens the file as a run does; whether it was refused.
bool refused(const std::filesystem::path& path) {
  try {
    const auto info = gltfSceneInfo(path.string());
    const auto scene = info->create();
    for (const CameraInfo& camera : info->cameras) {
      CameraValues values;
      for (const auto& parameter : camera.parameters) {
        values[parameter.name] = parameter.default_value;
      }
      (void)scene->camera(camera.name, values, 0.4, 64);
    }
    for (const GpuLight& light : scene->lights(0.4).lights) {
      EXPECT_TRUE(std::isfinite(light.color.r) && std::isfinite(light.direction_world.x));
    }
    for (const uint32_t index : scene->geometry().indices) {
      if (index >= scene->geometry().vertices.size()) ADD_FAILURE() << "index beyond vertices";
    }
    return false;
  } catch (const SceneFileError& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    return true;
  }
}

std::string damaged(std::string bytes, std::mt19937& random) {
  const int hits = 1 + static_cast<int>(random() % 4);
  for (int i = 0; i < hits && !bytes.empty(); ++i) {
    const size_t at = random() % bytes.size();
    switch (random() % 4) {
      case 0:
        bytes[at] = static_cast<char>(random());
        break;
      case 1:
        bytes[at] = static_cast<char>('0' + random() % 10);
        break;
      case 2:
        bytes.erase(at, 1 + random() % 8);
        break;
      default:
        bytes.insert(at, 1 + random() % 3, static_cast<char>('0' + random() % 10));
        break;
    }
  }
  return bytes;
}

TEST(GltfFuzz, Binary) {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "a.glb";
  const std::string whole = everything().glb();
  std::ofstream(path, std::ios::binary | std::ios::trunc) << whole;
  ASSERT_FALSE(refused(path));
  std::mt19937 random(7);
  int count = 0;
  for (int round = 0; round < rounds(1500); ++round) {
    std::ofstream(path, std::ios::binary | std::ios::trunc) << damaged(whole, random);
    count += refused(path);
  }
  EXPECT_GT(count, 0);
}

// Numbers and names exchanged inside JSON that stays whole: what a parser does not notice.
TEST(GltfFuzz, Values) {
  const TemporaryDirectory directory;
  const MadeUpGltf whole = everything();
  const Json flat = whole.json.flatten();
  std::vector<std::string> keys;
  for (const auto& item : flat.items()) keys.push_back(item.key());
  const std::vector<Json> values = {0,
                                    1,
                                    2,
                                    3,
                                    -1,
                                    255,
                                    65536,
                                    2147483647,
                                    -2147483648.0,
                                    4294967295.0,
                                    1e30,
                                    0.5,
                                    "",
                                    "VEC3",
                                    5121,
                                    5123,
                                    5125,
                                    5126,
                                    nullptr,
                                    true,
                                    Json::array(),
                                    Json::object()};
  std::mt19937 random(11);
  int count = 0;
  for (int round = 0; round < rounds(2500); ++round) {
    MadeUpGltf made = whole;
    for (uint32_t i = 0; i < 1 + random() % 2; ++i) {
      made.json[Json::json_pointer(keys[random() % keys.size()])] =
          values[random() % values.size()];
    }
    count += refused(made.save(directory.path()));
  }
  EXPECT_GT(count, 0);
}

}  // namespace
}  // namespace reprise::lab
