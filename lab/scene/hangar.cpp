// SPDX-License-Identifier: MIT
//
// A hall with an open roof of trusses, rails, cables and masts down to less than a pixel, a floor
// of plates, and a ship whose hull mirrors the lamps; the sun wanders and so do the trusses'
// shadows. After the space land of Iglesias-Guitian et al. 2016. The shading is in
// shading/hangar.glsl.
#include <array>
#include <cmath>

#include "lab/scene/mesh/beam.h"
#include "lab/scene/mesh/box.h"
#include "lab/scene/mesh/loft.h"
#include "lab/scene/scene.h"

namespace reprise::lab {
namespace {

constexpr float kHallHalfWidth_m = 15.0f;
constexpr float kHallHalfLength_m = 30.0f;
constexpr float kEaves_m = 11.5f;
constexpr double kStillAt_s = 0.35;
constexpr float kBay_m = 5.0f;  // between trusses, and between lamps

class Hangar final : public Scene {
 public:
  Hangar() {
    const auto metal = [&](glm::vec3 paint, float part) {
      geometry_.materials.push_back(
          {.parameters = glm::vec4(paint, part), .kind = kMaterialHangar});
      return static_cast<uint32_t>(geometry_.materials.size() - 1);
    };
    const uint32_t steel = metal({0.30f, 0.31f, 0.33f}, 0.0f);
    const uint32_t yellow = metal({0.62f, 0.43f, 0.04f}, 0.0f);
    const uint32_t dark = metal({0.05f, 0.05f, 0.06f}, 0.0f);
    const uint32_t floor = metal({0.20f, 0.21f, 0.22f}, 1.0f);
    const uint32_t hull = metal({0.52f, 0.55f, 0.60f}, 2.0f);
    const uint32_t white = metal({0.60f, 0.60f, 0.58f}, 0.0f);
    geometry_.materials.push_back({.parameters = {1.0f, 1.0f, 1.0f, 1.0f},
                                   .emission = {26.0f, 24.0f, 20.0f, 0.0f},
                                   .kind = kMaterialTextured});
    const auto lamp = static_cast<uint32_t>(geometry_.materials.size() - 1);

    addInstance(geometry_, floorMesh(), floor);
    addInstance(geometry_, roofMesh(), steel);
    addInstance(geometry_, wallMesh(), white);
    addInstance(geometry_, railMesh(), yellow);
    addInstance(geometry_, cableMesh(), dark);
    addInstance(geometry_, lampMesh(), lamp);
    addInstance(geometry_, hullMesh(), hull);
    addInstance(geometry_, shipPartsMesh(), steel);
    addInstance(geometry_, mastMesh(), dark);
  }

  const Geometry& geometry() const override { return geometry_; }
  glm::mat4 transform(uint32_t, double) const override { return glm::mat4(1.0f); }

  CameraPose camera(std::string_view name, const CameraValues& values, double time_s,
                    uint32_t) const override {
    const auto t = static_cast<float>(name == "still" ? kStillAt_s : values.at("from") + time_s);
    // A drone: round the ship's bow on a bent path, faster and slower, nodding and banking.
    const float turn = 0.55f + 0.26f * t + 0.09f * std::sin(1.9f * t);
    const float distance = 13.5f - 1.6f * std::sin(0.9f * t);
    CameraPose pose;
    pose.eye_world = {distance * std::sin(turn), 3.1f + 0.9f * std::sin(0.8f * t + 0.3f),
                      distance * std::cos(turn) + 1.0f};
    pose.target_world = {0.9f * std::sin(1.3f * t), 3.4f + 0.35f * std::sin(1.1f * t),
                         -1.0f + 0.8f * std::sin(0.7f * t)};
    pose.up_world = {0.10f * std::sin(1.5f * t), 1.0f, 0.0f};
    pose.vertical_fov = 0.95f;
    return pose;
  }

  SceneLights lights(double time_s) const override {
    const auto t = static_cast<float>(time_s);
    const glm::vec3 towards(-0.55f + 0.22f * std::sin(0.8f * t), -1.0f,
                            -0.25f + 0.16f * std::sin(1.1f * t + 0.7f));
    return {.lights = {sunLight(towards, {2.6f, 2.4f, 2.1f}, true),
                       pointLight({5.0f, 9.5f, 6.0f}, {7.0f, 7.0f, 6.5f}),
                       pointLight({-6.0f, 9.5f, -8.0f}, {6.0f, 6.5f, 7.5f})},
            .ambient = {0.10f, 0.12f, 0.15f},
            .shadow_radius_m = 17.0f};
  }

 private:
  static Mesh floorMesh() {
    Mesh mesh = gridMesh(24, 48, [](uint32_t column, uint32_t row) {
      const glm::vec2 at(kHallHalfWidth_m * (static_cast<float>(column) / 12.0f - 1.0f) * 1.6f,
                         kHallHalfLength_m * (1.0f - static_cast<float>(row) / 24.0f) * 1.6f);
      return GridPoint{{at.x, 0.0f, at.y}, at};
    });
    makeSmooth(mesh, kNoCrease);
    return mesh;
  }

  static Mesh roofMesh() {
    Mesh mesh;
    for (float z = -kHallHalfLength_m; z <= kHallHalfLength_m + 0.1f; z += kBay_m) {
      appendGirder(mesh, {.from = {-kHallHalfWidth_m, kEaves_m, z},
                          .to = {kHallHalfWidth_m, kEaves_m, z},
                          .depth_m = 1.3f,
                          .bays = 20,
                          .chord_m = 0.14f,
                          .brace_m = 0.06f});
    }
    for (float x = -kHallHalfWidth_m; x <= kHallHalfWidth_m + 0.1f; x += 3.0f) {
      const float y = kEaves_m + 1.35f;
      appendBeam(mesh, {x, y, -kHallHalfLength_m}, {x, y, kHallHalfLength_m}, 0.05f);
    }
    // Wind bracing in the roof's plane.
    for (float z = -kHallHalfLength_m; z < kHallHalfLength_m - 0.1f; z += kBay_m) {
      for (float x = -kHallHalfWidth_m; x < kHallHalfWidth_m - 0.1f; x += 6.0f) {
        const float y = kEaves_m + 1.35f;
        appendBeam(mesh, {x, y, z}, {x + 6.0f, y, z + kBay_m}, 0.025f);
        appendBeam(mesh, {x + 6.0f, y, z}, {x, y, z + kBay_m}, 0.025f);
      }
    }
    return mesh;
  }

  static Mesh wallMesh() {
    Mesh mesh;
    for (const float side : {-1.0f, 1.0f}) {
      const float x = side * kHallHalfWidth_m;
      for (float z = -kHallHalfLength_m; z <= kHallHalfLength_m + 0.1f; z += kBay_m) {
        appendBeam(mesh, {x, 0.0f, z}, {x, kEaves_m, z}, 0.30f);
        appendBeam(mesh, {x - 0.45f * side, 0.0f, z}, {x - 0.45f * side, 5.0f, z}, 0.08f);
      }
      // Slats: blinds 6 cm high every 20 cm, open between.
      for (float y = 0.4f; y < kEaves_m - 0.3f; y += 0.20f) {
        appendBeam(mesh, {x + 0.3f * side, y, -kHallHalfLength_m},
                   {x + 0.3f * side, y, kHallHalfLength_m}, 0.06f);
      }
    }
    for (float y = 0.4f; y < kEaves_m; y += 0.25f) {
      appendBeam(mesh, {-kHallHalfWidth_m, y, -kHallHalfLength_m},
                 {kHallHalfWidth_m, y, -kHallHalfLength_m}, 0.07f);
      appendBeam(mesh, {-kHallHalfWidth_m, y, kHallHalfLength_m},
                 {kHallHalfWidth_m, y, kHallHalfLength_m}, 0.07f);
    }
    return mesh;
  }

  // Handrails of a gallery along each wall and of a gantry beside the ship, with its grating.
  static Mesh railMesh() {
    Mesh mesh;
    const auto rail = [&](glm::vec3 from, glm::vec3 to, uint32_t posts) {
      for (const float height : {0.45f, 0.80f, 1.1f}) {
        const glm::vec3 up(0.0f, height, 0.0f);
        const std::array<glm::vec3, 2> line{from + up, to + up};
        appendTube(mesh, line, height > 1.0f ? 0.022f : 0.012f, 6);
      }
      for (uint32_t i = 0; i <= posts; ++i) {
        const glm::vec3 foot =
            glm::mix(from, to, static_cast<float>(i) / static_cast<float>(posts));
        const std::array<glm::vec3, 2> post{foot, foot + glm::vec3(0.0f, 1.1f, 0.0f)};
        appendTube(mesh, post, 0.017f, 6);
      }
    };
    const auto walkway = [&](glm::vec3 from, glm::vec3 to, glm::vec3 across) {
      rail(from, to, 24);
      rail(from + across, to + across, 24);
      appendBeam(mesh, from, to, 0.09f);
      appendBeam(mesh, from + across, to + across, 0.09f);
      const float length = glm::distance(from, to);
      const auto bars = static_cast<uint32_t>(length / 0.10f);
      for (uint32_t i = 0; i <= bars; ++i) {
        const glm::vec3 at = glm::mix(from, to, static_cast<float>(i) / static_cast<float>(bars));
        appendBeam(mesh, at, at + across, 0.018f);
      }
    };
    walkway({-14.0f, 5.0f, -kHallHalfLength_m}, {-14.0f, 5.0f, kHallHalfLength_m},
            {1.2f, 0.0f, 0.0f});
    walkway({12.8f, 5.0f, -kHallHalfLength_m}, {12.8f, 5.0f, kHallHalfLength_m},
            {1.2f, 0.0f, 0.0f});
    walkway({-6.6f, 4.1f, -9.0f}, {-6.6f, 4.1f, 7.0f}, {1.0f, 0.0f, 0.0f});
    for (const float z : {-8.5f, -4.5f, -0.5f, 3.5f, 6.5f}) {
      for (const float x : {-6.6f, -5.6f}) appendBeam(mesh, {x, 0.0f, z}, {x, 4.1f, z}, 0.10f);
      appendBeam(mesh, {-6.6f, 0.2f, z}, {-5.6f, 4.0f, z}, 0.04f);
    }
    return mesh;
  }

  static Mesh cableMesh() {
    Mesh mesh;
    for (int i = 0; i < 11; ++i) {
      const auto k = static_cast<float>(i);
      const float z = -22.0f + 4.4f * k;
      appendCable(mesh, {-15.0f, 9.8f, z}, {15.0f, 10.4f, z + 2.0f}, 1.1f + 0.13f * k, 0.012f);
      appendCable(mesh, {-14.0f + 2.5f * k, kEaves_m, -25.0f}, {-13.0f + 2.5f * k, kEaves_m, 25.0f},
                  0.9f + 0.21f * static_cast<float>(i % 4), 0.007f);
    }
    // Hoses from the gantry to the ship, and what hangs from the crane.
    for (int i = 0; i < 4; ++i) {
      const float z = -6.0f + 3.0f * static_cast<float>(i);
      appendCable(mesh, {-5.6f, 4.3f, z}, {-2.2f, 3.6f, z + 0.7f}, 0.8f, 0.035f);
    }
    for (const float x : {-0.25f, 0.25f}) {
      const std::array<glm::vec3, 2> rope{glm::vec3(3.5f + x, kEaves_m, 4.0f),
                                          glm::vec3(3.5f + x, 6.2f, 4.0f)};
      appendTube(mesh, rope, 0.010f, 5);
    }
    return mesh;
  }

  // Where hangar.glsl's hallLight has them.
  static Mesh lampMesh() {
    Mesh mesh;
    for (float x = -10.0f; x <= 10.1f; x += kBay_m) {
      for (float z = -25.0f; z <= 25.1f; z += kBay_m) {
        append(mesh, transformed(
                         boxMesh({0.24f, 0.06f, 3.2f}, 1),
                         glm::mat4({1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {x, 11.2f, z, 1.0f})));
      }
    }
    return mesh;
  }

  static Mesh hullMesh() {
    const std::array<Section, 7> body{{{{0.0f, 2.7f, 8.2f}, 0.10f, 0.12f},
                                       {{0.0f, 2.8f, 6.4f}, 0.65f, 0.80f},
                                       {{0.0f, 3.0f, 3.2f}, 1.25f, 1.50f},
                                       {{0.0f, 3.2f, 0.0f}, 1.60f, 2.00f},
                                       {{0.0f, 3.3f, -3.4f}, 1.65f, 2.15f},
                                       {{0.0f, 3.3f, -6.8f}, 1.45f, 1.85f},
                                       {{0.0f, 3.3f, -9.2f}, 1.05f, 1.30f}}};
    Mesh mesh = loft(body, {.side = {1.0f, 0.0f, 0.0f},
                            .around = 72,
                            .rows_a_span = 12,
                            .cap_rows = 8,
                            .cap_length = 0.6f});
    for (const float side : {-1.0f, 1.0f}) {
      const std::array<Section, 3> wing{{{{1.5f * side, 2.9f, -4.6f}, 0.20f, 2.3f},
                                         {{4.0f * side, 2.6f, -6.0f}, 0.11f, 1.5f},
                                         {{6.2f * side, 2.3f, -7.2f}, 0.04f, 0.8f}}};
      append(mesh, loft(wing, {.side = {0.0f, 0.0f, 1.0f}, .around = 40, .rows_a_span = 10}));
      const std::array<Section, 3> pod{{{{2.5f * side, 3.6f, -6.2f}, 0.45f, 0.45f},
                                        {{2.5f * side, 3.6f, -8.4f}, 0.62f, 0.62f},
                                        {{2.5f * side, 3.6f, -10.4f}, 0.40f, 0.40f}}};
      append(mesh, loft(pod, {.side = {1.0f, 0.0f, 0.0f}, .around = 40, .rows_a_span = 8}));
    }
    return mesh;
  }

  // Landing gear and grab rails along the hull.
  static Mesh shipPartsMesh() {
    Mesh mesh;
    for (const glm::vec2 at : {glm::vec2(0.0f, 5.0f), {-1.6f, -5.5f}, {1.6f, -5.5f}}) {
      appendBeam(mesh, {at.x, 0.0f, at.y}, {0.8f * at.x, 2.6f, at.y - 0.3f}, 0.16f);
      appendBeam(mesh, {at.x, 0.3f, at.y}, {0.6f * at.x, 2.4f, at.y - 1.3f}, 0.05f);
      append(mesh, transformed(boxMesh({0.7f, 0.10f, 0.9f}, 1),
                               glm::mat4({1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0},
                                         {at.x, 0.05f, at.y, 1.0f})));
    }
    for (const float side : {-1.0f, 1.0f}) {
      std::array<glm::vec3, 5> rail{};
      for (size_t i = 0; i < rail.size(); ++i) {
        rail[i] = {0.75f * side, 4.86f - 0.02f * static_cast<float>(i * i),
                   -5.5f + 1.9f * static_cast<float>(i)};
        const std::array<glm::vec3, 2> post{rail[i], rail[i] - glm::vec3(0.0f, 0.4f, 0.0f)};
        appendTube(mesh, post, 0.012f, 6);
      }
      appendTube(mesh, rail, 0.014f, 6);
    }
    return mesh;
  }

  static Mesh mastMesh() {
    Mesh mesh;
    const glm::vec3 foot(0.0f, 4.7f, -4.2f);
    for (int i = 0; i < 7; ++i) {
      const auto k = static_cast<float>(i);
      const std::array<glm::vec3, 2> rod{
          foot + glm::vec3(0.22f * (k - 3.0f), 0.0f, -0.25f * k),
          foot + glm::vec3(0.42f * (k - 3.0f), 2.6f - 0.22f * k, -0.45f * k)};
      appendTube(mesh, rod, 0.012f - 0.001f * k, 5);
    }
    // A ladder mast.
    appendGirder(mesh, {.from = foot + glm::vec3(-0.12f, -0.1f, 1.4f),
                        .to = foot + glm::vec3(-0.12f, 3.2f, 1.4f),
                        .up = {1.0f, 0.0f, 0.0f},
                        .depth_m = 0.24f,
                        .bays = 16,
                        .chord_m = 0.025f,
                        .brace_m = 0.012f});
    appendCable(mesh, foot + glm::vec3(0.0f, 3.2f, 1.4f), {0.0f, 2.9f, 7.9f}, 0.12f, 0.005f);
    appendCable(mesh, foot + glm::vec3(0.0f, 3.2f, 1.4f), {0.0f, 4.2f, -9.0f}, 0.10f, 0.005f);
    return mesh;
  }

  Geometry geometry_;
};

}  // namespace

SceneInfo hangarScene();
SceneInfo hangarScene() {
  return {.name = "hangar",
          .content = "trusses, rails and cables below a pixel, a mirroring hull, a wandering sun",
          .cameras = {{"fly",
                       "round the ship's bow, bent and banking",
                       {{"from", 0.0, "seconds into the path at which it begins"}}},
                      {"still", "does not move, nor does the sun", {}, kStillAt_s}},
          .create = [] { return std::unique_ptr<Scene>(std::make_unique<Hangar>()); }};
}

}  // namespace reprise::lab
