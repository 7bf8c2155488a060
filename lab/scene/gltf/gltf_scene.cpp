// SPDX-License-Identifier: MIT
#include "lab/scene/gltf/gltf_scene.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <set>
#include <stdexcept>

#include "lab/scene/gltf/fitted_path.h"
#include "lab/scene/gltf/gltf_file.h"
#include "lab/scene/gltf/gltf_lights.h"
#include "lab/scene/gltf/gltf_meshes.h"
#include "lab/scene/gltf/gltf_nodes.h"

namespace reprise::lab {
namespace {

constexpr const char* kPrefix = "gltf:";
constexpr const char* kCameraPrefix = "camera:";
constexpr double kStillAt_s = 0.35;
constexpr float kDegree = 0.01745329252f;

// A camera of the file and the node that carries it.
struct FileCamera {
  std::string name;  // "camera:NAME"
  uint32_t node = 0;
  float vertical_fov = 0.8f;
  float near_plane = 0.05f;
};

std::vector<FileCamera> camerasOf(GltfFile& file, const GltfNodes& nodes) {
  const tinygltf::Model& model = file.model();
  std::vector<FileCamera> cameras;
  std::set<std::string> taken;
  for (const uint32_t node : nodes.shown()) {
    if (model.nodes[node].camera < 0) continue;
    const tinygltf::Camera& from =
        model.cameras[file.checked(model.nodes[node].camera, model.cameras.size(), "camera")];
    if (from.type != "perspective") {
      file.warn("cameras other than perspective ones are left out");
      continue;
    }
    FileCamera camera;
    // The node's name is what modelling programs show; one name may stand for several cameras.
    std::string name = model.nodes[node].name;
    if (name.empty()) name = from.name;
    if (name.empty()) name = std::to_string(model.nodes[node].camera);
    while (!taken.insert(name).second) name += "'";
    camera.name = kCameraPrefix + name;
    camera.node = node;
    camera.vertical_fov = static_cast<float>(from.perspective.yfov);
    camera.near_plane = static_cast<float>(from.perspective.znear);
    if (!(camera.vertical_fov > 0.0f && camera.vertical_fov < 3.1f && camera.near_plane > 0.0f &&
          camera.near_plane < 1.0e6f)) {
      file.fail("a camera's angle or near plane is damaged");
    }
    cameras.push_back(std::move(camera));
  }
  return cameras;
}

// What a file holds, read once for all runs that name it.
struct Content {
  explicit Content(const std::string& path)
      : file(path), nodes(file), cameras(camerasOf(file, nodes)) {}

  GltfFile file;
  GltfNodes nodes;
  std::vector<FileCamera> cameras;
};

class GltfScene final : public Scene {
 public:
  explicit GltfScene(std::shared_ptr<Content> content)
      : content_(std::move(content)), nodes_(content_->nodes) {
    GltfFile& file = content_->file;
    appendMeshes(file, nodes_, geometry_, movers_);
    const Geometry placed = placedGeometry();
    lights_.emplace(file, nodes_, placed);
    path_.emplace(placed);
    warnings_ = file.warnings();
  }

  const Geometry& geometry() const override { return geometry_; }

  glm::mat4 transform(uint32_t instance, double time_s) const override {
    if (movers_[instance] < 0) return glm::mat4(1.0f);
    return nodes_.worldFromNode(static_cast<uint32_t>(movers_[instance]), time_s);
  }

  CameraPose camera(std::string_view name, const CameraValues& values, double time_s,
                    uint32_t) const override {
    if (name == "view") return viewed(values, time_s);
    for (const FileCamera& camera : content_->cameras) {
      if (camera.name == name) return carried(camera, time_s);
    }
    return path_->at(time_s);
  }

  SceneLights lights(double time_s) const override { return lights_->at(nodes_, time_s); }
  std::vector<std::string> warnings() const override { return warnings_; }

 private:
  // Triangles in the world at time 0, without materials.
  Geometry placedGeometry() const {
    Geometry placed;
    placed.indices = geometry_.indices;
    placed.vertices = geometry_.vertices;
    for (uint32_t i = 0; i < geometry_.instances.size(); ++i) {
      if (movers_[i] < 0) continue;
      const glm::mat4 world = transform(i, 0.0);
      const Instance& instance = geometry_.instances[i];
      // A mover's vertices are its own and lie together.
      const auto first = geometry_.indices.begin() + instance.first_index;
      const auto [low, high] = std::minmax_element(first, first + instance.index_count);
      for (uint32_t v = *low; v <= *high; ++v) {
        glm::vec4& p = placed.vertices[v].position_u;
        p = glm::vec4(glm::vec3(world * glm::vec4(glm::vec3(p), 1.0f)), p.w);
      }
    }
    return placed;
  }

  CameraPose carried(const FileCamera& camera, double time_s) const {
    const glm::mat4 world = nodes_.worldFromNode(camera.node, time_s);
    CameraPose pose;
    pose.eye_world = glm::vec3(world[3]);
    const glm::vec3 back(world[2]);
    const glm::vec3 up(world[1]);
    // Scaled away to nothing it looks where cameras look by default.
    const bool whole = glm::length(glm::cross(back, up)) > 0.0f;
    pose.target_world =
        pose.eye_world - (whole ? glm::normalize(back) : glm::vec3(0.0f, 0.0f, 1.0f));
    if (whole) pose.up_world = glm::normalize(up);
    pose.vertical_fov = camera.vertical_fov;
    pose.near_plane = camera.near_plane;
    return pose;
  }

  static CameraPose viewed(const CameraValues& values, double time_s) {
    const auto value = [&](const char* name) {
      return static_cast<float>(values.find(name)->second);
    };
    const auto t = static_cast<float>(time_s);
    CameraPose pose;
    pose.eye_world = {value("ex"), value("ey"), value("ez")};
    glm::vec3 along = glm::vec3(value("tx"), value("ty"), value("tz")) - pose.eye_world;
    if (!(glm::length(along) > 0.0f)) along = glm::vec3(0.0f, 0.0f, -1.0f);
    along = glm::normalize(along);
    const float turn = value("turn") * kDegree * t;
    along = {std::cos(turn) * along.x - std::sin(turn) * along.z, along.y,
             std::sin(turn) * along.x + std::cos(turn) * along.z};
    const glm::vec3 level(along.x, 0.0f, along.z);
    const glm::vec3 side(-along.z, 0.0f, along.x);
    pose.eye_world += t * (value("speed") * level + value("strafe") * side);
    pose.target_world = pose.eye_world + along;
    if (std::abs(along.y) > 0.999f) pose.up_world = {0.0f, 0.0f, -1.0f};
    pose.vertical_fov = std::clamp(value("fov"), 1.0f, 170.0f) * kDegree;
    return pose;
  }

  std::shared_ptr<Content> content_;
  const GltfNodes& nodes_;
  Geometry geometry_;
  std::vector<int> movers_;  // an instance each: its node, -1 for what stands still
  std::optional<GltfLights> lights_;
  std::optional<FittedPath> path_;
  std::vector<std::string> warnings_;
};

}  // namespace

bool namesGltf(const std::string& text) {
  return text.starts_with(kPrefix);
}

GltfName splitGltfName(const std::string& text) {
  const std::string rest = text.substr(std::string(kPrefix).size());
  std::string lower = rest;
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  // The first end of a name that is a file's, else the first that could be one.
  std::optional<GltfName> first;
  for (size_t at = 0; at < lower.size(); ++at) {
    const bool gltf = lower.compare(at, 5, ".gltf") == 0;
    if (!gltf && lower.compare(at, 4, ".glb") != 0) continue;
    const size_t end = at + (gltf ? 5 : 4);
    if (end < rest.size() && rest[end] != '/') continue;
    GltfName name{rest.substr(0, end), end < rest.size() ? rest.substr(end + 1) : ""};
    std::error_code error;
    if (std::filesystem::is_regular_file(name.path, error)) return name;
    if (!first) first = std::move(name);
  }
  if (!first) {
    throw std::invalid_argument("'" + text + "' names no .gltf or .glb file: gltf:PATH/camera");
  }
  return *first;
}

SceneInfo gltfPattern() {
  return {.name = "gltf:PATH",
          .content = "any glTF 2.0 file, .gltf or .glb",
          .cameras = {{"path", "through it, or around it where nothing encloses the camera", {}},
                      {"still", "the path's start; nothing moves", {}, kStillAt_s},
                      {"view",
                       "from a point to a target, moving and turning steadily",
                       {{"ex", 0.0, "eye, x (m)"},
                        {"ey", 1.6, "eye, y (m)"},
                        {"ez", 0.0, "eye, z (m)"},
                        {"tx", 0.0, "target, x (m)"},
                        {"ty", 1.6, "target, y (m)"},
                        {"tz", -1.0, "target, z (m)"},
                        {"fov", 50.0, "vertical angle (degrees)"},
                        {"speed", 0.0, "ahead, level (m/s)"},
                        {"strafe", 0.0, "to the right (m/s)"},
                        {"turn", 0.0, "to the right (degrees/s)"}}},
                      {"camera:NAME", "a camera of the file, moving as the file says", {}}},
          .create = {}};
}

std::shared_ptr<const SceneInfo> gltfSceneInfo(const std::string& path) {
  const auto content = std::make_shared<Content>(path);
  SceneInfo info = gltfPattern();
  info.name = kPrefix + path;
  info.cameras.pop_back();
  for (const FileCamera& camera : content->cameras) {
    info.cameras.push_back({camera.name, "of the file", {}, std::nullopt});
  }
  info.create = [content] { return std::unique_ptr<Scene>(std::make_unique<GltfScene>(content)); };
  return std::make_shared<const SceneInfo>(std::move(info));
}

}  // namespace reprise::lab
