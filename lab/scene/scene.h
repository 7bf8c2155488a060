// SPDX-License-Identifier: MIT
//
// A scene: meshes, materials, lights and cameras as pure functions of time in seconds. World units
// are metres, right-handed, y up. A run is named "scene/camera"; a camera may take numbers:
// "chart/pan:vx=0.25,vy=0.1".
#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lab/render/frame_data.h"

namespace reprise::lab {

// One range of the scene's triangles that moves as a whole.
struct Instance {
  uint32_t first_index = 0;
  uint32_t index_count = 0;
  uint32_t material = 0;
  uint32_t casts_shadow = 1;  // 0: the sun's map leaves it out
};

enum class ImageRole {
  kColor,   // rgb in sRGB, a: coverage
  kNormal,  // tangent-space normal, xyz * 0.5 + 0.5
  kMask     // linear values
};

// RGBA8, rows from v = 0 on; repeats in u and v.
struct SceneImage {
  uint32_t width = 0;
  uint32_t height = 0;
  ImageRole role = ImageRole::kColor;
  // Above 0: every mip level keeps the share of texels whose alpha is at least this.
  float alpha_cutoff = 0.0f;
  std::vector<uint8_t> rgba;
};

// All triangles of a scene, as the GPU reads them, and its images.
struct Geometry {
  std::vector<GpuVertex> vertices;
  std::vector<uint32_t> indices;
  std::vector<Instance> instances;
  std::vector<GpuMaterial> materials;
  std::vector<SceneImage> images;
  std::vector<GpuSway> sways;  // a vertex each; vertices beyond its end are stiff
};

// Returns what a material's ..._texture names it by.
uint32_t addImage(Geometry& geometry, SceneImage image);

struct CameraPose {
  glm::vec3 eye_world{0.0f};
  glm::vec3 target_world{0.0f, 0.0f, -1.0f};
  glm::vec3 up_world{0.0f, 1.0f, 0.0f};
  float vertical_fov = 0.8f;  // radians
  float near_plane = 0.05f;   // metres; the far plane is at infinity
};

struct CameraParameter {
  std::string name;
  double default_value;
  std::string meaning;
};

struct CameraInfo {
  std::string name;
  std::string motion;  // one line
  std::vector<CameraParameter> parameters;
  // Where set, time stands still at this second: neither the camera nor anything else moves.
  std::optional<double> frozen_at_s = std::nullopt;
};

// Camera parameters by name; every one of CameraInfo::parameters is present.
using CameraValues = std::map<std::string, double, std::less<>>;

struct SceneLights {
  std::vector<GpuLight> lights;  // at most kMaxLights
  glm::vec3 ambient{0.0f};       // GpuFrame::ambient
  // Shadows fall within a ball of this radius (m) that lies ahead of the camera; 0: everywhere.
  float shadow_radius_m = 0.0f;
};

// A light that shines everywhere from a point (m); `color` as GpuLight has it.
GpuLight pointLight(glm::vec3 position_world, glm::vec3 color);
// One from far away; `towards_world` is the way it goes, of any length. The first of a scene's suns
// that casts a shadow at time 0 has the shadow map.
GpuLight sunLight(glm::vec3 towards_world, glm::vec3 color, bool casts_shadow = false);
// Full light within `inner` (radians, half angle), none beyond `outer`.
GpuLight coneLight(glm::vec3 position_world, glm::vec3 towards_world, float inner, float outer,
                   glm::vec3 color);

// A cone behind a mask turned by `turn` radians about its axis; in kLightLayerDeferred.
GpuLight goboLight(glm::vec3 position_world, glm::vec3 towards_world, float inner, float outer,
                   glm::vec3 color, float turn);

class Scene {
 public:
  virtual ~Scene() = default;
  virtual const Geometry& geometry() const = 0;
  // World transform of an instance.
  virtual glm::mat4 transform(uint32_t instance, double time_s) const = 0;
  // `height_px` lets a camera move by pixels.
  virtual CameraPose camera(std::string_view name, const CameraValues& values, double time_s,
                            uint32_t height_px) const = 0;
  virtual SceneLights lights(double time_s) const = 0;
  // Direction and strength of the wind that moves vertices with a GpuSway; 1 is a fresh breeze.
  virtual glm::vec3 wind_world(double) const { return glm::vec3(0.0f); }
  // How many lamps are scattered over it (scattered_lamps.h) where nobody asks for another number.
  virtual uint32_t lampCount() const { return 0; }
  // What the scene's file holds and the lab leaves out, a line each.
  virtual std::vector<std::string> warnings() const { return {}; }
};

struct SceneInfo {
  std::string name;
  std::string content;  // one line
  std::vector<CameraInfo> cameras;
  std::function<std::unique_ptr<Scene>()> create;
};

// The one list of scenes that need no file. gltf/gltf_scene.h has those that are read from one.
const std::vector<SceneInfo>& sceneList();

// A run: a scene, one of its cameras, the camera's numbers.
struct SceneRun {
  std::string name;  // as written
  const SceneInfo* scene = nullptr;
  const CameraInfo* camera = nullptr;
  CameraValues values;
  std::shared_ptr<const SceneInfo> owned = nullptr;  // holds `scene` where no list does
};

// Reads the file of a run "gltf:PATH/camera": throws SceneFileError. Throws std::invalid_argument,
// naming near ones, for unknown scenes, cameras and parameters.
SceneRun parseSceneRun(const std::string& text);
// Whether `text` is meant as a scene: its part before '/' is one, or no such path exists on disk.
bool namesScene(const std::string& text);

// A rectangle of quads in the plane z = 0, facing +z, centred, uv in metres from its corner.
void appendWall(Geometry& geometry, float width_m, float height_m, uint32_t columns, uint32_t rows,
                uint32_t material);

}  // namespace reprise::lab
