// SPDX-License-Identifier: MIT
//
// A wall of random-colour bricks with noisy mortar, pits and bumps under one light: shading aliases
// in every way, geometry does not. After the brick scene of Yang et al. 2009, Figure 11. The
// shading is in shading/brick.glsl.
#include <cmath>

#include "lab/scene/scene.h"

namespace reprise::lab {
namespace {

// Large enough to fill the frame for every camera below, and far beyond.
constexpr float kWallWidth_m = 12.0f;
constexpr float kWallHeight_m = 8.0f;

class Brick final : public Scene {
 public:
  Brick() {
    geometry_.materials.push_back({.parameters = glm::vec4(0.0f), .kind = kMaterialBrick});
    // Tiles keep barycentrics short: one huge triangle would cost digits of position.
    appendWall(geometry_, kWallWidth_m, kWallHeight_m, 24, 16, 0);
  }

  const Geometry& geometry() const override { return geometry_; }
  glm::mat4 transform(uint32_t, double) const override { return glm::mat4(1.0f); }

  CameraPose camera(std::string_view name, const CameraValues& values, double time_s,
                    uint32_t) const override {
    CameraPose pose;
    const auto t = static_cast<float>(time_s);
    glm::vec3 eye(0.0f, 0.0f, 2.0f);
    if (name == "pan") {
      eye.x = static_cast<float>(values.at("speed")) * (t - 0.5f);
      eye.y = 0.37f * eye.x;  // not along an axis of the pixel grid
    } else if (name == "zoom") {
      // In and out once every two seconds, by a factor of about two.
      eye.z = 2.0f * std::pow(2.0f, -0.5f * std::sin(3.14159265f * t));
    }
    pose.eye_world = eye;
    pose.target_world = glm::vec3(eye.x, eye.y, 0.0f);
    if (name == "rotate") {
      const float angle = 0.5f * t;
      pose.up_world = glm::vec3(std::sin(angle), std::cos(angle), 0.0f);
      pose.target_world += glm::vec3(0.15f * std::sin(1.3f * t), 0.1f * std::sin(0.9f * t), 0.0f);
    }
    return pose;
  }

  SceneLights lights(double) const override {
    return {.lights = {pointLight({-1.1f, 1.3f, 0.9f}, {5.2f, 4.6f, 3.8f})},
            .ambient = {0.10f, 0.13f, 0.18f}};
  }

 private:
  Geometry geometry_;
};

}  // namespace

SceneInfo brickScene();
SceneInfo brickScene() {
  return {
      .name = "brick",
      .content = "random-colour bricks, noisy mortar, pits, bump mapping, one light",
      .cameras = {{"pan",
                   "sideways and a little up, constant speed",
                   {{"speed", 0.35, "metres a second; 0.35 is about 1.9 px a frame at 540 rows"}}},
                  {"rotate", "rolls and sways", {}},
                  {"zoom", "in and out, twice the size and back", {}},
                  {"still", "does not move", {}, 0.0}},
      .create = [] { return std::unique_ptr<Scene>(std::make_unique<Brick>()); }};
}

}  // namespace reprise::lab
