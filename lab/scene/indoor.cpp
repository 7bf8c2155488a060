// SPDX-License-Identifier: MIT
//
// A room of brick with a marble floor: shiny sphere, teapot of polished stone, carved chest, a
// rusty creature that walks, and a lamp behind a turning mask. After the indoor scene of Yang et
// al. 2009, Figures 1 and 13. The mask's light lies in kLightLayerDeferred. Mirrors see
// shading/room.glsl, which shares indoor/room_measures.h.
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "lab/scene/indoor/creature.h"
#include "lab/scene/indoor/furniture.h"
#include "lab/scene/indoor/room_measures.h"
#include "lab/scene/mesh/box.h"
#include "lab/scene/mesh/lathe.h"
#include "lab/scene/mesh/utah_teapot.h"
#include "lab/scene/scene.h"

namespace reprise::lab {
namespace {

constexpr float kTau = 6.28318531f;
constexpr glm::vec3 kRoom_m = {kRoomWidth_m, kRoomHeight_m, kRoomLength_m};
constexpr double kStill_s = 0.9;

constexpr glm::vec3 kSphere_m = {-0.95f, 1.18f, -0.75f};
constexpr float kSphereRadius_m = 0.42f;
constexpr glm::vec3 kTeapot_m = {0.95f, 0.62f, -0.55f};
constexpr float kTeapotScale = 0.2f;
constexpr glm::vec3 kChestAt_m = {-0.25f, 0.0f, -1.75f};
constexpr glm::vec3 kCreatureAt_m = {0.05f, 0.0f, 0.75f};
constexpr float kWalkRadius_m = 0.72f;
constexpr float kLampsHeight_m = 2.45f;
constexpr glm::vec3 kLamps_m[] = {{kLampAX_m, kLampsHeight_m, kLampAZ_m},
                                  {kLampBX_m, kLampsHeight_m, kLampBZ_m}};

glm::mat4 movedTo(glm::vec3 at) {
  return glm::translate(glm::mat4(1.0f), at);
}
glm::mat4 turnedAboutY(float angle) {
  return glm::rotate(glm::mat4(1.0f), angle, glm::vec3(0.0f, 1.0f, 0.0f));
}
glm::mat4 tippedUp(float angle) {
  return glm::rotate(glm::mat4(1.0f), angle, glm::vec3(1.0f, 0.0f, 0.0f));
}

class Indoor final : public Scene {
 public:
  Indoor() : creature_(kCreatureAt_m, kWalkRadius_m, 1.0f) {
    const uint32_t brick = material(kMaterialBrick, glm::vec4(0.0f));
    const uint32_t floor = material(kMaterialMarble, {0.5f, 0.10f, 42.0f, 0.16f});
    const uint32_t oak = material(kMaterialWood, {0.34f, 0.17f, 0.065f, 2.0f});
    const uint32_t beam = material(kMaterialWood, {0.16f, 0.09f, 0.045f, 0.0f});
    const uint32_t glaze = material(kMaterialGlazed, {0.05f, 0.16f, 0.34f, 11.0f});
    const uint32_t stone = material(kMaterialStone, {0.34f, 0.060f, 0.120f, 0.0f});
    const uint32_t rust = material(kMaterialRust, {9.0f, 0.52f, 0.0f, 0.0f});

    // Each wall faces the room.
    const float half_turn = 0.5f * kTau;
    wall(kRoom_m.x, kRoom_m.y, 48, 20, brick, movedTo({0.0f, 0.5f * kRoom_m.y, -0.5f * kRoom_m.z}));
    wall(kRoom_m.x, kRoom_m.y, 48, 20, brick,
         movedTo({0.0f, 0.5f * kRoom_m.y, 0.5f * kRoom_m.z}) * turnedAboutY(half_turn));
    wall(kRoom_m.z, kRoom_m.y, 42, 20, brick,
         movedTo({-0.5f * kRoom_m.x, 0.5f * kRoom_m.y, 0.0f}) * turnedAboutY(0.5f * half_turn));
    wall(kRoom_m.z, kRoom_m.y, 42, 20, brick,
         movedTo({0.5f * kRoom_m.x, 0.5f * kRoom_m.y, 0.0f}) * turnedAboutY(-0.5f * half_turn));
    wall(kRoom_m.x, kRoom_m.z, 48, 42, floor, tippedUp(-0.5f * half_turn));
    wall(kRoom_m.x, kRoom_m.z, 48, 42, beam,
         movedTo({0.0f, kRoom_m.y, 0.0f}) * tippedUp(0.5f * half_turn));
    for (int i = -2; i <= 2; ++i) {
      placed(boxMesh({kRoom_m.x, 0.20f, 0.16f}, 12), beam,
             movedTo({0.0f, kRoom_m.y - 0.10f, 1.3f * static_cast<float>(i)}));
    }
    for (const glm::vec3 lamp : kLamps_m) {
      placed(lampShade(kRoom_m.y - lamp.y), rust, movedTo(lamp));
    }
    placed(pedestal(kSphere_m.y - kSphereRadius_m + 0.02f, 0.27f), stone,
           movedTo({kSphere_m.x, 0.0f, kSphere_m.z}));
    placed(pedestal(kTeapot_m.y, 0.36f), oak, movedTo({kTeapot_m.x, 0.0f, kTeapot_m.z}));
    placed(carvedChest(), oak, movedTo(kChestAt_m) * turnedAboutY(1.75f));
    lid_ = placed(carvedLid(), oak, glm::mat4(1.0f));
    sphere_ = placed(sphereMesh(kSphereRadius_m, 112), glaze, glm::mat4(1.0f));
    teapot_ = placed(utahTeapotMesh(14, kTeapotScale), stone, glm::mat4(1.0f));
    first_piece_ = static_cast<uint32_t>(geometry_.instances.size());
    for (const Mesh& piece : creature_.pieces()) placed(piece, rust, glm::mat4(1.0f));
  }

  const Geometry& geometry() const override { return geometry_; }

  glm::mat4 transform(uint32_t instance, double time_s) const override {
    if (instance >= first_piece_) return creature_.transform(instance - first_piece_, time_s);
    const auto t = static_cast<float>(time_s);
    if (instance == sphere_) {
      return movedTo(kSphere_m) *
             glm::rotate(glm::mat4(1.0f), 1.1f * t, glm::normalize(glm::vec3(0.25f, 1.0f, 0.1f)));
    }
    if (instance == teapot_) return movedTo(kTeapot_m) * turnedAboutY(0.7f - 0.8f * t);
    if (instance == lid_) {
      // Opens and claps shut; its hinge is the chest's far upper edge.
      const float open = 0.42f + 0.38f * std::sin(2.6f * t);
      return movedTo(kChestAt_m) * turnedAboutY(1.75f) *
             movedTo({-0.5f * kChest_m.x, kChest_m.y + 0.012f, 0.0f}) *
             glm::rotate(glm::mat4(1.0f), open, glm::vec3(0.0f, 0.0f, 1.0f));
    }
    return fixed_[instance];
  }

  CameraPose camera(std::string_view name, const CameraValues&, double time_s,
                    uint32_t) const override {
    const auto t = static_cast<float>(name == "still" ? kStill_s : time_s);
    // Round the room between the pieces and the walls, up and down, looking ahead and back.
    const float angle = 1.25f + 0.75f * std::sin(1.15f * t) + 0.25f * t;
    CameraPose pose;
    pose.vertical_fov = 0.95f;
    pose.eye_world = {(2.75f + 0.35f * std::sin(1.9f * t)) * std::cos(angle),
                      1.35f + 0.45f * std::sin(1.6f * t + 0.4f),
                      (2.45f + 0.30f * std::cos(1.4f * t)) * std::sin(angle)};
    pose.target_world = {0.30f * std::sin(1.3f * t), 0.72f + 0.12f * std::sin(2.1f * t),
                         -0.35f + 0.25f * std::cos(0.9f * t)};
    return pose;
  }

  SceneLights lights(double time_s) const override {
    const auto t = static_cast<float>(time_s);
    SceneLights lights{.lights = {}, .ambient = {0.13f, 0.13f, 0.15f}};
    for (const glm::vec3 lamp : kLamps_m) {
      lights.lights.push_back(pointLight(lamp, {3.3f, 2.75f, 2.1f}));
    }
    lights.lights.push_back(
        coneLight({3.3f, 2.8f, 2.9f}, {-0.75f, -0.5f, -0.75f}, 0.35f, 0.60f, {3.0f, 3.8f, 5.2f}));
    lights.lights.push_back(goboLight({-2.6f, 2.95f, 2.4f}, {0.62f, -0.62f, -0.60f}, 0.52f, 0.58f,
                                      {34.0f, 29.0f, 19.0f}, 2.2f * t));
    return lights;
  }

 private:
  uint32_t material(uint32_t kind, glm::vec4 parameters) {
    geometry_.materials.push_back({.parameters = parameters, .kind = kind});
    return static_cast<uint32_t>(geometry_.materials.size()) - 1;
  }
  uint32_t placed(const Mesh& mesh, uint32_t material, const glm::mat4& place) {
    fixed_.push_back(place);
    return addInstance(geometry_, mesh, material);
  }
  void wall(float width_m, float height_m, uint32_t columns, uint32_t rows, uint32_t material,
            const glm::mat4& place) {
    fixed_.push_back(place);
    appendWall(geometry_, width_m, height_m, columns, rows, material);
  }

  Creature creature_;
  Geometry geometry_;
  std::vector<glm::mat4> fixed_;  // one an instance; unused where it moves
  uint32_t lid_ = 0;
  uint32_t sphere_ = 0;
  uint32_t teapot_ = 0;
  uint32_t first_piece_ = 0;
};

}  // namespace

SceneInfo indoorScene();
SceneInfo indoorScene() {
  return {
      .name = "indoor",
      .content = "brick room with shiny, carved and rusty pieces, 190,000 triangles, gobo light",
      .cameras = {{"fly", "round the room, fast, up and down", {}},
                  {"still", "does not move, nor does anything else", {}, kStill_s}},
      .create = [] { return std::unique_ptr<Scene>(std::make_unique<Indoor>()); }};
}

}  // namespace reprise::lab
