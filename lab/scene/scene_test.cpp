// SPDX-License-Identifier: MIT
#include "lab/scene/scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <stdexcept>

#include "lab/scene/indoor/creature.h"

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
      const bool stands = camera.name == "still" || camera.name == "lights";
      EXPECT_EQ(moves, !stands) << info.name << "/" << camera.name;
      // At "lights" time goes on.
      EXPECT_EQ(camera.frozen_at_s.has_value(), camera.name == "still");
    }
  }
}

size_t triangleCount(const SceneInfo& info) {
  return info.create()->geometry().indices.size() / 3;
}

TEST(Scenes, HoldTheTrianglesThatTheyClaim) {
  const std::map<std::string, size_t> least = {{"horse", 40000},
                                               {"teapot", 25000},
                                               {"indoor", 100001},
                                               {"foliage", 250000},
                                               {"hangar", 50000}};
  for (const SceneInfo& info : sceneList()) {
    const auto found = least.find(info.name);
    if (found == least.end()) continue;
    const size_t triangles = triangleCount(info);
    EXPECT_GE(triangles, found->second) << info.name;
    RecordProperty(info.name, static_cast<int>(triangles));
  }
}

TEST(Creature, StandsOnItsFeetAndReachesThem) {
  const Creature creature({0.1f, 0.0f, 0.4f}, 0.7f, 1.0f);
  const auto pieces = static_cast<uint32_t>(creature.pieces().size());
  for (int step = 0; step < 200; ++step) {
    const double time_s = 0.017 * step;
    int standing = 0;
    for (uint32_t leg = 0; leg < 6; ++leg) {
      const glm::vec3 foot = creature.foot(leg, time_s);
      ASSERT_GT(foot.y, -1e-4f);
      if (foot.y < 1e-4f) {
        ++standing;
        const glm::vec3 next = creature.foot(leg, time_s + 0.0005);
        if (next.y < 1e-4f) {
          EXPECT_LT(glm::distance(foot, next), 1e-4f) << leg;
        }
      }
      // The tibia's tip is the foot: the leg is long enough for every step.
      const glm::vec3 tip(creature.transform(pieces - 12 + 2 * leg + 1, time_s) *
                          glm::vec4(0.0f, -0.42f, 0.0f, 1.0f));
      EXPECT_LT(glm::distance(tip, foot), 1e-3f) << leg << " at " << time_s;
    }
    EXPECT_GE(standing, 3);
  }
}

TEST(Lights, GoboIsALightOfTheDeferredLayer) {
  const GpuLight light =
      goboLight({1.0f, 2.0f, 3.0f}, {0.0f, -2.0f, 0.0f}, 0.2f, 0.3f, {1.0f, 1.0f, 1.0f}, 0.5f);
  EXPECT_EQ(light.kind, kLightGobo);
  EXPECT_EQ(light.layer, kLightLayerDeferred);
  EXPECT_FLOAT_EQ(light.position_world.w, std::cos(0.5f));
  EXPECT_FLOAT_EQ(light.color.w, std::sin(0.5f));
}

}  // namespace
}  // namespace reprise::lab
