// SPDX-License-Identifier: MIT
#include "lab/scene/gltf/gltf_lights.h"

#include <algorithm>
#include <cmath>

namespace reprise::lab {
namespace {

// Daylight of a file without lights; by eye, on Sponza's court, a street and a wood.
const glm::vec3 kSunTowards(0.30f, -1.0f, 0.22f);
const glm::vec3 kSunColor(3.0f, 2.75f, 2.35f);
const glm::vec3 kSkyColor(0.34f, 0.40f, 0.50f);
// Beside a file's own lights.
const glm::vec3 kFillColor(0.10f, 0.11f, 0.13f);

// A file's lights are in candela and lux, from tens to tens of thousands. One factor brings them
// to where this share of the vertices, were they white, shows at most this much.
constexpr float kExposedShare = 0.9f;
constexpr float kExposedTo = 1.5f;
constexpr size_t kExposureSamples = 4096;

// In scenes wider than this only what lies ahead of the camera has the sun's shadows: a map of
// 2048 texels would have texels of over 2 cm.
constexpr float kWholeShadow_m = 22.0f;

constexpr float kPi = 3.14159265f;

float luminance(glm::vec3 c) {
  return glm::dot(c, glm::vec3(0.2126f, 0.7152f, 0.0722f));
}

// What a white surface there shows of a light without shadow.
float shown(const GpuLight& light, glm::vec3 position, glm::vec3 normal) {
  if (light.kind == kLightSun) {
    const float facing = -glm::dot(glm::vec3(light.direction_world), normal);
    return luminance(glm::vec3(light.color)) * std::max(facing, 0.0f);
  }
  const glm::vec3 to_light = glm::vec3(light.position_world) - position;
  const float distance = std::max(glm::length(to_light), 1.0e-3f);
  const float facing = std::max(glm::dot(to_light, normal) / distance, 0.0f);
  float share = 1.0f;
  if (light.kind == kLightCone) {
    const float cosine = -glm::dot(to_light, glm::vec3(light.direction_world)) / distance;
    share = glm::smoothstep(light.cone_cosines.y, light.cone_cosines.x, cosine);
  }
  return luminance(glm::vec3(light.color)) * share * facing / (distance * distance);
}

// The part of a light that its file tells, at the node's origin, shining along -z.
GpuLight lightOf(const tinygltf::Light& from, GltfFile& file) {
  glm::vec3 color(1.0f);
  if (from.color.size() == 3) {
    for (int c = 0; c < 3; ++c) color[c] = static_cast<float>(from.color[static_cast<size_t>(c)]);
  }
  color *= static_cast<float>(from.intensity) / kPi;
  if (!(luminance(glm::abs(color)) < 1.0e12f) || luminance(color) < 0.0f) {
    file.fail("a light's intensity is damaged");
  }
  color = glm::max(color, glm::vec3(0.0f));
  const glm::vec3 forward(0.0f, 0.0f, -1.0f);
  if (from.type == "directional") return sunLight(forward, color, true);
  if (from.type == "point") return pointLight(glm::vec3(0.0f), color);
  if (from.type != "spot") file.fail("a light is of unknown type");
  const auto outer = static_cast<float>(from.spot.outerConeAngle);
  const auto inner = static_cast<float>(from.spot.innerConeAngle);
  if (!(outer > 0.0f && outer <= 0.5001f * kPi && inner >= 0.0f && inner <= outer)) {
    file.fail("a spot light's angles are damaged");
  }
  // smoothstep needs an edge of some width.
  return coneLight(glm::vec3(0.0f), forward, std::min(inner, outer - 1.0e-3f), outer, color);
}

int lightNumber(const tinygltf::Node& node) {
  const auto found = node.extensions.find("KHR_lights_punctual");
  if (found == node.extensions.end() || !found->second.IsObject()) return -1;
  if (!found->second.Has("light") || !found->second.Get("light").IsNumber()) return -1;
  return found->second.Get("light").GetNumberAsInt();
}

}  // namespace

GltfLights::GltfLights(GltfFile& file, const GltfNodes& nodes, const Geometry& geometry) {
  glm::vec3 low(1.0e30f);
  glm::vec3 high(-1.0e30f);
  for (const GpuVertex& vertex : geometry.vertices) {
    low = glm::min(low, glm::vec3(vertex.position_u));
    high = glm::max(high, glm::vec3(vertex.position_u));
  }
  const float radius_m = 0.5f * glm::distance(low, high);
  if (radius_m > kWholeShadow_m) shadow_radius_m_ = std::max(kWholeShadow_m, 0.2f * radius_m);
  const tinygltf::Model& model = file.model();
  for (const uint32_t node : nodes.shown()) {
    const int number = lightNumber(model.nodes[node]);
    if (number < 0) continue;
    const size_t light = file.checked(number, model.lights.size(), "light");
    lamps_.push_back({node, lightOf(model.lights[light], file)});
  }
  if (!lamps_.empty()) expose(nodes, geometry, file);
}

GpuLight GltfLights::placed(const Lamp& lamp, const glm::mat4& world) {
  GpuLight light = lamp.light;
  const glm::vec3 along = glm::mat3(world) * glm::vec3(0.0f, 0.0f, -1.0f);
  const float length = glm::length(along);
  const float shadow = light.direction_world.w;
  light.direction_world =
      glm::vec4(length > 0.0f ? along / length : glm::vec3(0.0f, -1.0f, 0.0f), shadow);
  if (light.kind != kLightSun) light.position_world = glm::vec4(glm::vec3(world[3]), 1.0f);
  return light;
}

void GltfLights::expose(const GltfNodes& nodes, const Geometry& geometry, GltfFile& file) {
  const size_t step = std::max<size_t>(geometry.vertices.size() / kExposureSamples, 1);
  std::vector<float> sums;
  std::vector<std::pair<float, size_t>> strength;
  std::vector<GpuLight> lights;
  for (size_t i = 0; i < lamps_.size(); ++i) {
    lights.push_back(placed(lamps_[i], nodes.worldFromNode(lamps_[i].node, 0.0)));
    strength.emplace_back(0.0f, i);
  }
  for (size_t v = 0; v < geometry.vertices.size(); v += step) {
    const glm::vec3 position(geometry.vertices[v].position_u);
    const glm::vec3 normal(geometry.vertices[v].normal_v);
    float sum = 0.0f;
    for (size_t i = 0; i < lights.size(); ++i) {
      const float part = shown(lights[i], position, normal);
      strength[i].first += part;
      sum += part;
    }
    if (sum > 0.0f) sums.push_back(sum);
  }
  if (lamps_.size() > kMaxLights) {
    file.warn("of " + std::to_string(lamps_.size()) + " lights the " + std::to_string(kMaxLights) +
              " brightest shine");
    std::stable_sort(strength.begin(), strength.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<Lamp> kept;
    for (size_t i = 0; i < kMaxLights; ++i) kept.push_back(lamps_[strength[i].second]);
    lamps_ = std::move(kept);
  }
  if (sums.empty()) return;
  const auto at = sums.begin() +
                  static_cast<std::ptrdiff_t>(kExposedShare * static_cast<float>(sums.size() - 1));
  std::nth_element(sums.begin(), at, sums.end());
  const float exposure = kExposedTo / std::max(*at, 1.0e-12f);
  for (Lamp& lamp : lamps_) {
    lamp.light.color = glm::vec4(glm::vec3(lamp.light.color) * exposure, lamp.light.color.w);
  }
}

SceneLights GltfLights::at(const GltfNodes& nodes, double time_s) const {
  SceneLights lights;
  lights.shadow_radius_m = shadow_radius_m_;
  if (lamps_.empty()) {
    lights.lights = {sunLight(kSunTowards, kSunColor, true)};
    lights.ambient = kSkyColor;
    return lights;
  }
  for (const Lamp& lamp : lamps_) {
    lights.lights.push_back(placed(lamp, nodes.worldFromNode(lamp.node, time_s)));
  }
  lights.ambient = kFillColor;
  return lights;
}

}  // namespace reprise::lab
