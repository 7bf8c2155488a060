// SPDX-License-Identifier: MIT
#include "board_scene.h"

#include <glm/gtc/matrix_transform.hpp>

namespace reprise::lab {
namespace {

class Board final : public Scene {
 public:
  Board() {
    geometry_.materials.push_back({.parameters = glm::vec4(0.0f), .kind = kMaterialBrick});
    appendWall(geometry_, 1.5f, 1.0f, 6, 4, 0);
  }
  const Geometry& geometry() const override { return geometry_; }
  glm::mat4 transform(uint32_t, double) const override {
    return glm::rotate(glm::mat4(1.0f), 0.4f, glm::vec3(0.3f, 0.5f, 1.0f));
  }
  CameraPose camera(std::string_view name, const CameraValues&, double time_s,
                    uint32_t) const override {
    CameraPose pose;
    pose.eye_world = glm::vec3(0.0f, 0.0f, 2.0f);
    if (name == "pan") pose.eye_world.x = 2.0f * (static_cast<float>(time_s) - 0.2f);
    pose.target_world = glm::vec3(pose.eye_world.x, 0.0f, 0.0f);
    return pose;
  }
  SceneLights lights(double) const override {
    GpuLight late = pointLight({1.0f, 0.5f, 1.0f}, {0.5f, 1.5f, 2.5f});
    late.layer = kLightLayerDeferred;
    return {.lights = {pointLight({-1.1f, 1.3f, 0.9f}, {5.2f, 4.6f, 3.8f}), late},
            .ambient = {0.10f, 0.13f, 0.18f}};
  }

 private:
  Geometry geometry_;
};

const SceneInfo& boardScene() {
  static const SceneInfo info{
      .name = "board",
      .content = "a board before the sky",
      .cameras = {{"still", "does not move", {}, 0.2}, {"pan", "sideways", {}}},
      .create = [] { return std::unique_ptr<Scene>(std::make_unique<Board>()); }};
  return info;
}

}  // namespace

SceneRun boardRun(const char* camera) {
  const SceneInfo& scene = boardScene();
  const CameraInfo& chosen = scene.cameras[scene.cameras[0].name == camera ? 0 : 1];
  return {"board/" + chosen.name, &scene, &chosen, {}};
}

}  // namespace reprise::lab
