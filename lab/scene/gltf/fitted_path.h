// SPDX-License-Identifier: MIT
//
// A camera's way through geometry that nobody made one for: along the longest free line at eye
// height where something stands around, else around the whole.
#pragma once

#include <glm/glm.hpp>

#include "lab/scene/scene.h"

namespace reprise::lab {

class FittedPath {
 public:
  explicit FittedPath(const Geometry& geometry);

  bool inside() const { return inside_; }
  // Moves and turns by sines, never at constant speed; at its start at once.
  CameraPose at(double time_s) const;

 private:
  bool inside_ = false;
  float near_plane_ = 0.05f;
  glm::vec3 from_world_{0.0f};  // of a line inside
  glm::vec3 to_world_{0.0f};
  glm::vec3 center_world_{0.0f};  // of what is gone around
  float radius_m_ = 1.0f;
};

}  // namespace reprise::lab
