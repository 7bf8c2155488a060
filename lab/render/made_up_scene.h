// SPDX-License-Identifier: MIT
//
// For tests: scenes put together on the spot, and one frame of them.
#pragma once

#include <gtest/gtest.h>

#include <functional>

#include "lab/render/scene_source.h"

namespace reprise::lab {

struct MadeUp {
  Geometry geometry;
  SceneLights lights;
  CameraPose pose;
  glm::vec3 wind_world{0.0f};
};

// `make` is asked once for each renderer. A scene's camera is "still" and time stands.
template <MadeUp (*make)()>
SceneRun madeUpRun() {
  class MadeUpScene final : public Scene {
   public:
    const Geometry& geometry() const override { return all_.geometry; }
    glm::mat4 transform(uint32_t, double) const override { return glm::mat4(1.0f); }
    CameraPose camera(std::string_view, const CameraValues&, double, uint32_t) const override {
      return all_.pose;
    }
    SceneLights lights(double) const override { return all_.lights; }
    glm::vec3 wind_world(double) const override { return all_.wind_world; }

   private:
    MadeUp all_ = make();
  };
  static const SceneInfo info{
      .name = "made up", .content = "", .cameras = {{"still", "", {}, std::nullopt}}, .create = [] {
        return std::unique_ptr<Scene>(std::make_unique<MadeUpScene>());
      }};
  return {.name = "made-up/still", .scene = &info, .camera = &info.cameras[0], .values = {}};
}

// Four corners counter-clockwise from (low, low) as an instance of its own; uv from 0 to uv_high.
inline void addQuad(Geometry& geometry, glm::vec3 corner, glm::vec3 u_side, glm::vec3 v_side,
                    glm::vec2 uv_high, uint32_t material) {
  const auto base = static_cast<uint32_t>(geometry.vertices.size());
  const auto first = static_cast<uint32_t>(geometry.indices.size());
  const glm::vec3 normal = glm::normalize(glm::cross(u_side, v_side));
  for (const glm::vec2 at : {glm::vec2(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
    geometry.vertices.push_back(
        {glm::vec4(corner + at.x * u_side + at.y * v_side, at.x * uv_high.x),
         glm::vec4(normal, at.y * uv_high.y)});
  }
  for (const uint32_t k : {0u, 1u, 2u, 0u, 2u, 3u}) geometry.indices.push_back(base + k);
  geometry.instances.push_back({first, 6, material});
}

// A frame at a jitter, RGBA.
inline FloatImage colorOf(Device& device, SceneSource& source, uint32_t index = 0,
                          eq::vec2 jitter_px = eq::vec2(0.0f, 0.0f), float mip_bias = 0.0f) {
  SamplePlan plan;
  plan.library.jitter_px[0] = jitter_px.x;
  plan.library.jitter_px[1] = jitter_px.y;
  plan.library.mip_bias = mip_bias;
  FrameInputs inputs;
  device.submitAndWait(
      [&](VkCommandBuffer commands) { inputs = source.frame(commands, index, plan); });
  return download(device, *inputs.color);
}

inline SceneSourceOptions testOptions(VkExtent2D extent) {
  SceneSourceOptions options;
  options.extent = extent;
  options.frames = 16;
  options.reference.samples = 2;
  options.reference.cache = "none";
  return options;
}

// A device with validation; anything that it says fails the test.
class DeviceTest : public testing::Test {
 protected:
  DeviceTest() : device({.validation = Device::validationAvailable()}) {}
  void TearDown() override {
    for (const std::string& message : device.validationMessages()) ADD_FAILURE() << message;
  }
  Device device;
};

}  // namespace reprise::lab
