// SPDX-License-Identifier: MIT
#include "lab/render/shadow_map.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace reprise::lab {
namespace {

constexpr uint32_t kShadowVertexShader[] = {
#include "shadow.vert.inc"
};
constexpr uint32_t kHolesShader[] = {
#include "holes.frag.inc"
};

// Texels a side: 2 cm over the 20 m around a walker.
constexpr uint32_t kResolution = 2048;

// A surface must not shade itself. The filter reaches two texels from the point it is asked for,
// over which a surface's depth changes by twice its slope a texel: that is added while rendering.
// Half a texel more covers rounding to texel centres where the slope is that of another triangle.
constexpr float kSlopeBias = 2.0f;
constexpr float kConstantBias_texels = 0.5f;

bool castsShadow(const GpuLight& light) {
  return light.kind == kLightSun && light.direction_world.w > 0.0f;
}

bool anyCastsShadow(const SceneLights& lights) {
  return std::any_of(lights.lights.begin(), lights.lights.end(), castsShadow);
}

template <typename T>
void append(std::vector<uint8_t>& bytes, const T* data, size_t count) {
  const auto* begin = reinterpret_cast<const uint8_t*>(data);
  bytes.insert(bytes.end(), begin, begin + count * sizeof(T));
}

}  // namespace

SunView sunView(glm::vec3 towards_world, const Ball& receivers, const Ball& casters,
                uint32_t resolution) {
  const glm::vec3 along = glm::normalize(towards_world);
  const glm::vec3 helper =
      std::abs(along.y) < 0.9f ? glm::vec3(0.0f, 1.0f, 0.0f) : glm::vec3(1.0f, 0.0f, 0.0f);
  const glm::vec3 right = glm::normalize(glm::cross(along, helper));
  const glm::vec3 up = glm::cross(right, along);
  SunView view;
  view.texel_m = 2.0f * receivers.radius_m / static_cast<float>(resolution);
  const auto snapped = [&](float v) { return std::floor(v / view.texel_m) * view.texel_m; };
  const float x = snapped(glm::dot(receivers.center_world, right));
  const float y = snapped(glm::dot(receivers.center_world, up));
  const float far = glm::dot(receivers.center_world, along) + receivers.radius_m;
  const float near = std::min(far - 2.0f * receivers.radius_m,
                              glm::dot(casters.center_world, along) - casters.radius_m);
  view.depth_m = far - near;
  const float scale = 1.0f / receivers.radius_m;
  // Rows: right, up and along of the world, as columns of glm.
  for (int c = 0; c < 3; ++c) {
    view.matrix[c] = glm::vec4(right[c] * scale, up[c] * scale, along[c] / view.depth_m, 0.0f);
  }
  view.matrix[3] = glm::vec4(-x * scale, -y * scale, -near / view.depth_m, 1.0f);
  return view;
}

ShadowMap::ShadowMap(Device& device, const Scene& scene, const SceneBuffers& buffers)
    : scene_(scene),
      buffers_(buffers),
      on_(anyCastsShadow(scene.lights(0.0))),
      image_(device, {.format = VK_FORMAT_D32_SFLOAT,
                      .extent = on_ ? VkExtent2D{kResolution, kResolution} : VkExtent2D{1, 1},
                      .render_target = true}) {
  if (!on_) return;
  GraphicsProgramInfo info{.name = "shadow",
                           .vertex_spirv = kShadowVertexShader,
                           .fragment_spirv = {},
                           .bindings = SceneBuffers::rasterTypes(),
                           .push_bytes = sizeof(VisibilityConstants),
                           .depth_compare = VK_COMPARE_OP_LESS,
                           .depth_bias_slope = kSlopeBias,
                           .specialization = {}};
  opaque_program_ = GraphicsProgram(device, info);
  if (buffers.tested().empty()) return;
  info.name = "shadow, tested";
  info.fragment_spirv = kHolesShader;
  info.bindings = SceneBuffers::testedTypes();
  info.specialization = buffers.rasterSpecialization(false);
  tested_program_ = GraphicsProgram(device, info);
}

void ShadowMap::setFrame(GpuFrame& frame, double number, const SceneLights& lights,
                         glm::vec3 forward_world) {
  frame.shadow_light = kMaxLights;
  frame.shadow_from_world = glm::mat4(1.0f);
  frame.shadow_bias = 0.0f;
  if (!on_) return;
  const auto sun = std::find_if(lights.lights.begin(), lights.lights.end(), castsShadow);
  if (sun == lights.lights.end()) return;
  const Ball casters = buffers_.casterBounds();
  Ball receivers = casters;
  if (lights.shadow_radius_m > 0.0f) {
    receivers.radius_m = lights.shadow_radius_m;
    receivers.center_world = glm::vec3(frame.eye_world) + forward_world * receivers.radius_m;
  }
  const SunView view =
      sunView(glm::vec3(sun->direction_world), receivers, casters, image_.extent().width);
  frame.shadow_light = static_cast<uint32_t>(sun - lights.lights.begin());
  frame.shadow_from_world = view.matrix;
  frame.shadow_bias = kConstantBias_texels * view.texel_m / view.depth_m;
  const std::span<const glm::mat4> transforms = buffers_.transforms();
  seen_ = {.from_world = view.matrix,
           .transforms = {transforms.begin(), transforms.end()},
           .wind = buffers_.sways() ? frame.wind[0] : glm::vec4(0.0f)};
  number_ = number;
}

bool ShadowMap::isKept() const {
  return made_.has_value() && made_->number != number_ && made_->seen == seen_;
}

void ShadowMap::record(VkCommandBuffer commands) {
  if (!on_ || isKept()) return;
  made_ = {seen_, number_};
  beginRendering(commands, nullptr, image_, 1.0f);
  const std::vector<Instance>& instances = scene_.geometry().instances;
  const auto draw = [&](const GraphicsProgram& program, const std::vector<uint32_t>& which,
                        const std::vector<Bound>& bound) {
    if (which.empty()) return;
    program.bind(commands);
    for (const uint32_t i : which) {
      if (instances[i].casts_shadow == 0) continue;
      program.push(commands, bound, VisibilityConstants{{0.0f, 0.0f}, i, instances[i].material});
      vkCmdDraw(commands, instances[i].index_count, 1, instances[i].first_index, 0);
    }
  };
  draw(opaque_program_, buffers_.opaque(), buffers_.rasterBindings());
  draw(tested_program_, buffers_.tested(), buffers_.testedBindings());
  endRendering(commands);
  fullBarrier(commands);
}

void ShadowMap::appendContent(std::vector<uint8_t>& bytes) const {
  if (!on_) return;
  const uint32_t resolution = image_.extent().width;
  append(bytes, &resolution, 1);
  append(bytes, &kSlopeBias, 1);
  append(bytes, kShadowVertexShader, std::size(kShadowVertexShader));
  append(bytes, kHolesShader, std::size(kHolesShader));
}

}  // namespace reprise::lab
