// SPDX-License-Identifier: MIT
//
// The Utah teapot under moving lights; Voronoi cells make its colour and its bumps. Shading that
// changes although nothing but the lights moves: after the teapot scene of Yang et al. 2009, Figure
// 10. The shading is in shading/cells.glsl.
#include <cmath>

#include "lab/scene/mesh/utah_teapot.h"
#include "lab/scene/scene.h"

namespace reprise::lab {
namespace {

constexpr float kTeapotScale = 0.3f;  // metres a unit of Newell: the body is 1.2 m wide
constexpr float kTableSize_m = 24.0f;
constexpr double kStill_s = 0.3;

// Lights on circles of their own about the pot, none in step with another.
struct Orbit {
  float radius_m, height_m, sway_m, turns_a_second, start;
  glm::vec3 color;
};
constexpr float kTau = 6.28318531f;
const Orbit kOrbits[] = {{1.7f, 1.55f, 0.30f, 0.55f, 0.0f, {2.9f, 2.5f, 2.0f}},
                         {1.9f, 0.95f, 0.35f, -0.40f, 2.1f, {0.9f, 1.5f, 2.6f}},
                         {1.5f, 1.90f, 0.20f, 0.27f, 4.0f, {2.0f, 1.3f, 1.1f}}};

class Teapot final : public Scene {
 public:
  Teapot() {
    // parameters: as cells.glsl has them.
    geometry_.materials.push_back(
        {.parameters = {8.0f, 0.010f, 0.0f, 0.0f}, .kind = kMaterialCells});
    geometry_.materials.push_back(
        {.parameters = {3.3f, 0.022f, 1.0f, 0.0f}, .kind = kMaterialCells});
    addInstance(geometry_, utahTeapotMesh(20, kTeapotScale), 0);
    appendWall(geometry_, kTableSize_m, kTableSize_m, 48, 48, 1);
  }

  const Geometry& geometry() const override { return geometry_; }

  glm::mat4 transform(uint32_t instance, double) const override {
    if (instance == 0) return glm::mat4(1.0f);
    // The wall's +z becomes up.
    return {{1.0f, 0.0f, 0.0f, 0.0f},
            {0.0f, 0.0f, -1.0f, 0.0f},
            {0.0f, 1.0f, 0.0f, 0.0f},
            {0.0f, 0.0f, 0.0f, 1.0f}};
  }

  CameraPose camera(std::string_view name, const CameraValues&, double time_s,
                    uint32_t) const override {
    const auto t = static_cast<float>(name == "orbit" ? time_s : kStill_s);
    CameraPose pose;
    const float azimuth = 0.45f + 0.6f * t;
    const float distance = 2.35f + 0.25f * std::sin(0.8f * t);
    pose.target_world = {0.08f, 0.40f, 0.0f};
    pose.eye_world = pose.target_world + glm::vec3(distance * std::sin(azimuth),
                                                   1.05f + 0.25f * std::sin(1.1f * t),
                                                   distance * std::cos(azimuth));
    return pose;
  }

  SceneLights lights(double time_s) const override {
    SceneLights lights{.lights = {}, .ambient = {0.10f, 0.11f, 0.14f}};
    const auto t = static_cast<float>(time_s);
    for (const Orbit& orbit : kOrbits) {
      const float angle = orbit.start + kTau * orbit.turns_a_second * t;
      lights.lights.push_back(pointLight(
          {orbit.radius_m * std::cos(angle), orbit.height_m + orbit.sway_m * std::sin(1.7f * angle),
           orbit.radius_m * std::sin(angle)},
          orbit.color));
    }
    return lights;
  }

 private:
  Geometry geometry_;
};

}  // namespace

SceneInfo teapotScene();
SceneInfo teapotScene() {
  return {.name = "teapot",
          .content = "Utah teapot, Voronoi cells in colour and height, moving lights",
          .cameras = {{"orbit", "around the pot, while three lights go their own ways", {}},
                      {"lights", "does not move; the three lights do", {}},
                      {"still", "does not move, nor do the lights", {}, kStill_s}},
          .create = [] { return std::unique_ptr<Scene>(std::make_unique<Teapot>()); }};
}

}  // namespace reprise::lab
