// SPDX-License-Identifier: MIT
//
// A wooden toy horse gallops over a checkered marble floor: solid grain that moves with the wood,
// fine veins and tile edges that slide past. After the horse scene of Yang et al. 2009. Its bones
// and pieces are in horse/, the shading in shading/figured_wood.glsl and
// shading/veined_marble.glsl.
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "lab/scene/horse/horse_model.h"
#include "lab/scene/scene.h"

namespace reprise::lab {
namespace {

// The still view: all four feet gathered in the air would hide the gait; here the lead stands.
constexpr double kStill_s = 0.44;

// Long enough for one run of the horse (kStridesARun) with floor to all horizons of the cameras.
constexpr float kFloorLength_m = 96.0f;
constexpr float kFloorWidth_m = 36.0f;

constexpr float kAxisX = 0.0f;  // of the grain; as figured_wood.glsl reads parameters.w
constexpr float kAxisY = 1.0f;

// In the order of HorseWood.
const glm::vec4 kWoods[] = {{0.62f, 0.36f, 0.15f, kAxisX},   {0.60f, 0.34f, 0.14f, kAxisY},
                            {0.13f, 0.060f, 0.028f, kAxisY}, {0.050f, 0.038f, 0.030f, kAxisY},
                            {0.36f, 0.045f, 0.03f, kAxisX},  {0.012f, 0.010f, 0.010f, kAxisX}};
static_assert(std::size(kWoods) == static_cast<size_t>(HorseWood::kCount));

class Horse final : public Scene {
 public:
  Horse() : parts_(horseParts()) {
    for (const glm::vec4& wood : kWoods) {
      geometry_.materials.push_back({.parameters = wood, .kind = kMaterialFiguredWood});
    }
    for (const HorsePart& part : parts_) {
      addInstance(geometry_, part.mesh, static_cast<uint32_t>(part.wood));
    }
    const auto floor = static_cast<uint32_t>(geometry_.materials.size());
    geometry_.materials.push_back(
        {.parameters = {kTile_m, 0.0f, 0.0f, 0.0f}, .kind = kMaterialVeinedMarble});
    appendWall(geometry_, kFloorLength_m, kFloorWidth_m, 96, 36, floor);
  }

  const Geometry& geometry() const override { return geometry_; }

  glm::mat4 transform(uint32_t instance, double time_s) const override {
    if (instance >= parts_.size()) {
      // The wall's +z becomes up.
      return glm::rotate(glm::mat4(1.0f), -1.57079633f, glm::vec3(1.0f, 0.0f, 0.0f));
    }
    const HorsePart& part = parts_[instance];
    return part.bone(horsePose(time_s), part.index);
  }

  CameraPose camera(std::string_view name, const CameraValues&, double time_s,
                    uint32_t) const override {
    const double at_s = name == "still" ? kStill_s : time_s;
    const auto t = static_cast<float>(at_s);
    CameraPose pose;
    // Beside the horse and a little ahead; it drifts, as a camera car does.
    const float azimuth = 0.42f + 0.30f * std::sin(0.9f * t);
    const float distance = 2.50f + 0.15f * std::sin(0.7f * t + 1.0f);
    pose.target_world = {static_cast<float>(horseTravel(at_s)) + 0.13f, 0.80f, 0.0f};
    pose.eye_world = pose.target_world + glm::vec3(distance * std::sin(azimuth),
                                                   0.75f + 0.12f * std::sin(1.3f * t),
                                                   distance * std::cos(azimuth));
    return pose;
  }

  SceneLights lights(double) const override {
    return {.lights = {sunLight({-0.55f, -1.0f, -0.75f}, {1.75f, 1.62f, 1.42f}),
                       sunLight({0.9f, -0.35f, 0.35f}, {0.30f, 0.38f, 0.52f})},
            .ambient = {0.17f, 0.19f, 0.23f}};
  }

 private:
  static constexpr float kTile_m = 0.5f;

  std::vector<HorsePart> parts_;
  Geometry geometry_;
};

}  // namespace

SceneInfo horseScene();
SceneInfo horseScene() {
  return {.name = "horse",
          .content = "wooden toy horse galloping over a checkered marble floor",
          .cameras = {{"gallop", "runs beside the horse and sways", {}},
                      {"still", "does not move; the horse in mid-stride", {}, kStill_s}},
          .create = [] { return std::unique_ptr<Scene>(std::make_unique<Horse>()); }};
}

}  // namespace reprise::lab
