// SPDX-License-Identifier: MIT
//
// The one list of scenes; each is defined in its own file.
#include <charconv>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "core/near_names.h"
#include "lab/scene/gltf/gltf_scene.h"
#include "lab/scene/scene.h"

namespace reprise::lab {

SceneInfo brickScene();
SceneInfo chartScene();
SceneInfo foliageScene();
SceneInfo hangarScene();
SceneInfo horseScene();
SceneInfo indoorScene();
SceneInfo lightsScene();
SceneInfo teapotScene();

const std::vector<SceneInfo>& sceneList() {
  static const std::vector<SceneInfo> list = {
      chartScene(),  brickScene(),   horseScene(),  teapotScene(),
      indoorScene(), foliageScene(), hangarScene(), lightsScene(),
  };
  return list;
}

namespace {

template <typename List>
const typename List::value_type& findNamed(const List& list, const std::string& name,
                                           const std::string& what) {
  std::vector<std::string> names;
  std::string all;
  for (const auto& item : list) {
    if (item.name == name) return item;
    names.push_back(item.name);
    all += (all.empty() ? "" : ", ") + item.name;
  }
  const std::string near = nearNames(name, names);
  throw std::invalid_argument("there is no " + what + " '" + name + "'; " +
                              (near.empty() ? "there are: " + all : "near: " + near));
}

// name=number,... of a camera, as "name" of its run.
void readNumbers(SceneRun& run, std::string rest, const std::string& name) {
  while (!rest.empty()) {
    const size_t comma = rest.find(',');
    const std::string pair = rest.substr(0, comma);
    rest = comma == std::string::npos ? "" : rest.substr(comma + 1);
    const size_t equals = pair.find('=');
    const std::string parameter = pair.substr(0, equals);
    findNamed(run.camera->parameters, parameter, "number of camera '" + name + "'");
    const std::string number = equals == std::string::npos ? "" : pair.substr(equals + 1);
    double value = 0.0;
    const char* end = number.data() + number.size();
    const auto read = std::from_chars(number.data(), end, value);
    if (number.empty() || read.ptr != end || !std::isfinite(value)) {
      throw std::invalid_argument("camera '" + name + "': '" + pair + "' is not name=number");
    }
    run.values[parameter] = value;
  }
}

}  // namespace

SceneRun parseSceneRun(const std::string& text) {
  SceneRun run;
  run.name = text;
  std::string scene;
  std::string camera;
  if (namesGltf(text)) {
    GltfName name = splitGltfName(text);
    run.owned = gltfSceneInfo(name.path);
    run.scene = run.owned.get();
    scene = run.scene->name;
    camera = std::move(name.camera);
  } else {
    // A slash after the first colon belongs to numbers.
    const size_t slash = text.substr(0, text.find(':')).find('/');
    scene = slash == std::string::npos ? text.substr(0, text.find(':')) : text.substr(0, slash);
    camera = slash == std::string::npos ? "" : text.substr(slash + 1);
    run.scene = &findNamed(sceneList(), scene, "scene");
  }
  if (camera.empty()) {
    throw std::invalid_argument("scene '" + scene + "' needs a camera: '" + scene + "/" +
                                run.scene->cameras.front().name + "'");
  }
  // Names of a file's own cameras may hold anything, and they take no numbers.
  const bool of_file = run.owned != nullptr && camera.starts_with("camera:");
  const size_t colon = of_file ? std::string::npos : camera.find(':');
  run.camera = &findNamed(run.scene->cameras, camera.substr(0, colon),
                          "camera of scene '" + run.scene->name + "'");
  for (const CameraParameter& parameter : run.camera->parameters) {
    run.values[parameter.name] = parameter.default_value;
  }
  if (colon != std::string::npos) {
    readNumbers(run, camera.substr(colon + 1), scene + "/" + camera.substr(0, colon));
  }
  return run;
}

bool namesScene(const std::string& text) {
  if (namesGltf(text)) return true;
  const std::string scene = text.substr(0, text.find_first_of("/:"));
  for (const SceneInfo& info : sceneList()) {
    if (info.name == scene) return true;
  }
  return !std::filesystem::exists(text);
}

GpuLight pointLight(glm::vec3 position_world, glm::vec3 color) {
  GpuLight light{};
  light.position_world = glm::vec4(position_world, 1.0f);
  light.color = glm::vec4(color, 0.0f);
  light.kind = kLightPoint;
  light.layer = kLightLayerMain;
  return light;
}

GpuLight sunLight(glm::vec3 towards_world, glm::vec3 color, bool casts_shadow) {
  GpuLight light{};
  light.direction_world = glm::vec4(glm::normalize(towards_world), casts_shadow ? 1.0f : 0.0f);
  light.color = glm::vec4(color, 0.0f);
  light.kind = kLightSun;
  light.layer = kLightLayerMain;
  return light;
}

GpuLight coneLight(glm::vec3 position_world, glm::vec3 towards_world, float inner, float outer,
                   glm::vec3 color) {
  GpuLight light = pointLight(position_world, color);
  light.direction_world = glm::vec4(glm::normalize(towards_world), 0.0f);
  light.cone_cosines = glm::vec2(std::cos(inner), std::cos(outer));
  light.kind = kLightCone;
  return light;
}

GpuLight goboLight(glm::vec3 position_world, glm::vec3 towards_world, float inner, float outer,
                   glm::vec3 color, float turn) {
  GpuLight light = coneLight(position_world, towards_world, inner, outer, color);
  light.position_world.w = std::cos(turn);
  light.color.w = std::sin(turn);
  light.kind = kLightGobo;
  light.layer = kLightLayerDeferred;
  return light;
}

uint32_t addImage(Geometry& geometry, SceneImage image) {
  geometry.images.push_back(std::move(image));
  return static_cast<uint32_t>(geometry.images.size());
}

void appendWall(Geometry& geometry, float width_m, float height_m, uint32_t columns, uint32_t rows,
                uint32_t material) {
  const auto base = static_cast<uint32_t>(geometry.vertices.size());
  const auto first_index = static_cast<uint32_t>(geometry.indices.size());
  for (uint32_t y = 0; y <= rows; ++y) {
    for (uint32_t x = 0; x <= columns; ++x) {
      const float u = width_m * static_cast<float>(x) / static_cast<float>(columns);
      const float v = height_m * static_cast<float>(y) / static_cast<float>(rows);
      geometry.vertices.push_back(
          {{u - 0.5f * width_m, v - 0.5f * height_m, 0.0f, u}, {0.0f, 0.0f, 1.0f, v}});
    }
  }
  for (uint32_t y = 0; y < rows; ++y) {
    for (uint32_t x = 0; x < columns; ++x) {
      const uint32_t corner = base + y * (columns + 1) + x;
      const uint32_t above = corner + columns + 1;
      for (const uint32_t index : {corner, corner + 1, above + 1, corner, above + 1, above}) {
        geometry.indices.push_back(index);
      }
    }
  }
  geometry.instances.push_back(
      {first_index, static_cast<uint32_t>(geometry.indices.size()) - first_index, material});
}

}  // namespace reprise::lab
