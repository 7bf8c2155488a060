// SPDX-License-Identifier: MIT
//
// A resolution chart: zone plate, Siemens star, line pairs of growing frequency. Its camera pans by
// an exact number of pixels a frame, so that resampling blur can be measured against its closed
// form (Yang et al. 2009, Figures 3 and 6). The shading is in shading/chart.glsl.
#include <cmath>

#include "lab/scene/scene.h"

namespace reprise::lab {
namespace {

constexpr float kFramesPerSecond = 60.0f;

class Chart final : public Scene {
 public:
  Chart() {
    geometry_.materials.push_back({.parameters = glm::vec4(0.0f), .kind = kMaterialChart});
    appendWall(geometry_, 16.0f, 9.0f, 16, 9, 0);
  }

  const Geometry& geometry() const override { return geometry_; }
  glm::mat4 transform(uint32_t, double) const override { return glm::mat4(1.0f); }

  CameraPose camera(std::string_view name, const CameraValues& values, double time_s,
                    uint32_t height_px) const override {
    CameraPose pose;
    constexpr float kDistance_m = 2.0f;
    glm::vec3 eye(0.0f, 0.0f, kDistance_m);
    if (name == "pan") {
      // Content moves by (vx, vy) px a frame, y down: the camera moves the other way.
      const float metre_a_px =
          2.0f * kDistance_m * std::tan(0.5f * pose.vertical_fov) / static_cast<float>(height_px);
      const float frames = static_cast<float>(time_s) * kFramesPerSecond;
      eye.x = -static_cast<float>(values.at("vx")) * frames * metre_a_px;
      eye.y = static_cast<float>(values.at("vy")) * frames * metre_a_px;
    }
    pose.eye_world = eye;
    pose.target_world = glm::vec3(eye.x, eye.y, 0.0f);
    return pose;
  }

  SceneLights lights(double) const override { return {}; }

 private:
  Geometry geometry_;
};

}  // namespace

SceneInfo chartScene();
SceneInfo chartScene() {
  return {.name = "chart",
          .content = "resolution chart: zone plate, Siemens star, line pairs",
          .cameras = {{"pan",
                       "constant sub-pixel panning",
                       {{"vx", 0.3, "px a frame, to the right"}, {"vy", 0.2, "px a frame, down"}}},
                      {"still", "does not move", {}, 0.0}},
          .create = [] { return std::unique_ptr<Scene>(std::make_unique<Chart>()); }};
}

}  // namespace reprise::lab
