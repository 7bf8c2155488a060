// SPDX-License-Identifier: MIT
//
// Lights of a glTF file (KHR_lights_punctual), or daylight where it has none.
#pragma once

#include <vector>

#include "lab/scene/gltf/gltf_file.h"
#include "lab/scene/gltf/gltf_nodes.h"
#include "lab/scene/scene.h"

namespace reprise::lab {

class GltfLights {
 public:
  // `geometry` as it is at time 0, apart from what moves; lights are exposed for it.
  GltfLights(GltfFile& file, const GltfNodes& nodes, const Geometry& geometry);

  SceneLights at(const GltfNodes& nodes, double time_s) const;

 private:
  struct Lamp {
    uint32_t node;
    GpuLight light;  // in the node's space
  };
  static GpuLight placed(const Lamp& lamp, const glm::mat4& world);
  void expose(const GltfNodes& nodes, const Geometry& geometry, GltfFile& file);

  std::vector<Lamp> lamps_;
  float shadow_radius_m_ = 0.0f;
};

}  // namespace reprise::lab
