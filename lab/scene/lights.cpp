// SPDX-License-Identifier: MIT
//
// A gallery under many point and cone lights: columns, ribs, crates and railings over polished
// marble. The workload of Xiao et al. 2018, section 5; scattered_lamps.h places the lights.
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "lab/scene/indoor/furniture.h"
#include "lab/scene/mesh/beam.h"
#include "lab/scene/mesh/box.h"
#include "lab/scene/mesh/lathe.h"
#include "lab/scene/scene.h"

namespace reprise::lab {
namespace {

constexpr float kHalfTurn = 3.14159265f;
constexpr float kWidth_m = 12.0f;
constexpr float kHeight_m = 6.0f;
constexpr float kLength_m = 32.0f;
constexpr float kBay_m = 4.0f;
constexpr float kColumnAt_m = 3.4f;  // from the middle
constexpr uint32_t kLamps = 128;
constexpr double kStillAt_s = 0.4;

glm::mat4 movedTo(glm::vec3 at) {
  return glm::translate(glm::mat4(1.0f), at);
}
glm::mat4 turned(float angle, glm::vec3 axis) {
  return glm::rotate(glm::mat4(1.0f), angle, axis);
}

class Lights final : public Scene {
 public:
  Lights() {
    const uint32_t brick = material(kMaterialBrick, glm::vec4(0.0f));
    const uint32_t floor = material(kMaterialMarble, {0.5f, 0.10f, 42.0f, 0.0f});
    const uint32_t wood = material(kMaterialWood, {0.34f, 0.17f, 0.065f, 2.0f});
    const uint32_t stone = material(kMaterialStone, {0.34f, 0.30f, 0.45f, 0.0f});
    const uint32_t rust = material(kMaterialRust, {9.0f, 0.52f, 0.0f, 0.0f});
    const glm::vec3 x(1.0f, 0.0f, 0.0f);
    const glm::vec3 y(0.0f, 1.0f, 0.0f);
    wall(kLength_m, kHeight_m, 96, 20, brick,
         movedTo({-0.5f * kWidth_m, 0.5f * kHeight_m, 0.0f}) * turned(0.5f * kHalfTurn, y));
    wall(kLength_m, kHeight_m, 96, 20, brick,
         movedTo({0.5f * kWidth_m, 0.5f * kHeight_m, 0.0f}) * turned(-0.5f * kHalfTurn, y));
    for (const float end : {-1.0f, 1.0f}) {
      wall(kWidth_m, kHeight_m, 40, 20, brick,
           movedTo({0.0f, 0.5f * kHeight_m, 0.5f * end * kLength_m}) *
               turned(end > 0.0f ? kHalfTurn : 0.0f, y));
    }
    wall(kWidth_m, kLength_m, 40, 96, floor, turned(-0.5f * kHalfTurn, x));
    wall(kWidth_m, kLength_m, 40, 96, wood,
         movedTo({0.0f, kHeight_m, 0.0f}) * turned(0.5f * kHalfTurn, x));
    Mesh ribs;
    Mesh rails;
    for (float z = -0.5f * kLength_m + 0.5f * kBay_m; z < 0.5f * kLength_m; z += kBay_m) {
      appendGirder(ribs, {.from = {-0.5f * kWidth_m, kHeight_m - 0.8f, z},
                          .to = {0.5f * kWidth_m, kHeight_m - 0.8f, z},
                          .depth_m = 0.6f,
                          .bays = 20,
                          .chord_m = 0.08f,
                          .brace_m = 0.035f});
      for (const float side : {-1.0f, 1.0f}) {
        placed(columnMesh(), stone, movedTo({side * kColumnAt_m, 0.0f, z}));
        const float turn = 0.37f * z + side;
        placed(boxMesh({0.7f, 0.6f, 0.7f}, 4), wood,
               movedTo({side * (kColumnAt_m + 1.2f), 0.3f, z + 1.3f}) * turned(turn, y));
        placed(boxMesh({0.4f, 0.4f, 0.4f}, 4), wood,
               movedTo({side * (kColumnAt_m + 1.3f), 0.8f, z + 1.35f}) * turned(2.0f * turn, y));
        placed(carvedChest(), wood,
               movedTo({side * (kColumnAt_m - 1.1f), 0.0f, z + 0.4f}) * turned(turn, y));
        appendRailing(rails, {side * (kColumnAt_m - 0.6f), 0.0f, z + 0.6f},
                      {side * (kColumnAt_m - 0.6f), 0.0f, z + kBay_m - 0.6f});
      }
    }
    placed(ribs, rust, glm::mat4(1.0f));
    placed(rails, rust, glm::mat4(1.0f));
  }

  const Geometry& geometry() const override { return geometry_; }
  glm::mat4 transform(uint32_t instance, double) const override { return places_[instance]; }

  CameraPose camera(std::string_view name, const CameraValues& values, double time_s,
                    uint32_t) const override {
    const auto t = static_cast<float>(name == "still" ? kStillAt_s : time_s);
    const float speed = name == "dolly" ? static_cast<float>(values.find("speed")->second) : 2.0f;
    CameraPose pose;
    // There and back, so that every length of run stays inside.
    const float along = 11.0f * std::cos(speed / 11.0f * t);
    pose.eye_world = {1.1f * std::sin(0.5f * t), 1.7f + 0.1f * std::sin(1.3f * t), along};
    pose.target_world =
        pose.eye_world + glm::vec3(0.45f * std::sin(0.4f * t + 0.5f), -0.05f, -1.0f);
    pose.vertical_fov = 0.95f;
    return pose;
  }

  SceneLights lights(double) const override {
    return {.lights = {pointLight({0.0f, 5.0f, 0.0f}, {1.2f, 1.2f, 1.3f})},
            .ambient = {0.05f, 0.05f, 0.06f}};
  }
  uint32_t lampCount() const override { return kLamps; }

 private:
  static Mesh columnMesh() {
    const glm::vec2 profile[] = {{0.0f, 0.0f},   {0.44f, 0.0f},  {0.44f, 0.16f}, {0.36f, 0.22f},
                                 {0.40f, 0.30f}, {0.30f, 0.40f}, {0.26f, 4.6f},  {0.33f, 4.7f},
                                 {0.30f, 4.8f},  {0.45f, 5.0f},  {0.45f, 5.2f},  {0.0f, 5.2f}};
    return lathe(profile, 36, 0.6f);
  }

  static void appendRailing(Mesh& mesh, glm::vec3 from, glm::vec3 to) {
    const glm::vec3 up(0.0f, 1.0f, 0.0f);
    appendBeam(mesh, from + 1.0f * up, to + 1.0f * up, 0.05f);
    appendBeam(mesh, from + 0.15f * up, to + 0.15f * up, 0.03f);
    constexpr int kBars = 22;
    for (int i = 0; i <= kBars; ++i) {
      const glm::vec3 foot = from + (static_cast<float>(i) / kBars) * (to - from);
      appendBeam(mesh, foot, foot + 1.0f * up, 0.016f);
    }
  }

  uint32_t material(uint32_t kind, glm::vec4 parameters) {
    geometry_.materials.push_back({.parameters = parameters, .kind = kind});
    return static_cast<uint32_t>(geometry_.materials.size()) - 1;
  }
  void placed(const Mesh& mesh, uint32_t material, const glm::mat4& place) {
    places_.push_back(place);
    addInstance(geometry_, mesh, material);
  }
  void wall(float width_m, float height_m, uint32_t columns, uint32_t rows, uint32_t material,
            const glm::mat4& place) {
    places_.push_back(place);
    appendWall(geometry_, width_m, height_m, columns, rows, material);
  }

  Geometry geometry_;
  std::vector<glm::mat4> places_;
};

}  // namespace

SceneInfo lightsScene();
SceneInfo lightsScene() {
  return {.name = "lights",
          .content = "gallery with columns, crates and railings under 128 point and cone lights",
          .cameras = {{"dolly", "down the middle, swaying", {{"speed", 2.0, "ahead (m/s)"}}},
                      {"still", "does not move", {}, kStillAt_s}},
          .create = [] { return std::unique_ptr<Scene>(std::make_unique<Lights>()); }};
}

}  // namespace reprise::lab
