// SPDX-License-Identifier: MIT
#include "lab/scene/scene.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace reprise::lab {
namespace {

std::string messageOf(const std::string& run) {
  try {
    parseSceneRun(run);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(SceneRun, ReadsSceneCameraAndNumbers) {
  const SceneRun run = parseSceneRun("chart/pan:vx=0.25,vy=-0.5");
  EXPECT_EQ(run.scene->name, "chart");
  EXPECT_EQ(run.camera->name, "pan");
  EXPECT_EQ(run.values.at("vx"), 0.25);
  EXPECT_EQ(run.values.at("vy"), -0.5);
  EXPECT_EQ(parseSceneRun("chart/pan").values.at("vx"), 0.3);
}

TEST(SceneRun, WrongNamesGetNearOnes) {
  EXPECT_EQ(messageOf("brik/pan"), "there is no scene 'brik'; near: 'brick'");
  EXPECT_EQ(messageOf("brick/pam"), "there is no camera of scene 'brick' 'pam'; near: 'pan'");
  EXPECT_EQ(messageOf("brick"), "scene 'brick' needs a camera: 'brick/pan'");
  EXPECT_EQ(messageOf("chart/pan:vx=fast"), "camera 'chart/pan': 'vx=fast' is not name=number");
}

TEST(Scenes, GeometryIsWholeAndCamerasArePureFunctionsOfTime) {
  for (const SceneInfo& info : sceneList()) {
    const std::unique_ptr<Scene> a = info.create();
    const std::unique_ptr<Scene> b = info.create();
    const Geometry& geometry = a->geometry();
    ASSERT_FALSE(geometry.instances.empty());
    for (const uint32_t index : geometry.indices) ASSERT_LT(index, geometry.vertices.size());
    for (const Instance& instance : geometry.instances) {
      EXPECT_LE(instance.first_index + instance.index_count, geometry.indices.size());
      EXPECT_EQ(instance.index_count % 3, 0u);
      EXPECT_LT(instance.material, geometry.materials.size());
    }
    for (const CameraInfo& camera : info.cameras) {
      CameraValues values;
      for (const auto& parameter : camera.parameters)
        values[parameter.name] = parameter.default_value;
      // Asked in another order, the answer is the same.
      const CameraPose late = a->camera(camera.name, values, 0.7, 540);
      for (uint32_t i = 0; i < geometry.instances.size(); ++i) {
        const glm::mat4 there = a->transform(i, 0.7);
        a->transform(i, 0.1);
        EXPECT_EQ(there, b->transform(i, 0.7)) << info.name << " instance " << i;
      }
      a->camera(camera.name, values, 0.1, 540);
      const CameraPose again = b->camera(camera.name, values, 0.7, 540);
      EXPECT_EQ(late.eye_world, again.eye_world);
      EXPECT_EQ(late.up_world, again.up_world);
      const bool moves = a->camera(camera.name, values, 0.2, 540).eye_world != late.eye_world ||
                         a->camera(camera.name, values, 0.2, 540).up_world != late.up_world;
      EXPECT_EQ(moves, camera.name != "still") << info.name << "/" << camera.name;
    }
  }
}

}  // namespace
}  // namespace reprise::lab
