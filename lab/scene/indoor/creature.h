// SPDX-License-Identifier: MIT
//
// An iron beetle with six jointed legs and a scorpion's tail that walks in a circle, as a pure
// function of time. Feet that stand stay exactly where they were set down.
#pragma once

#include <vector>

#include "lab/scene/mesh/mesh.h"

namespace reprise::lab {

class Creature {
 public:
  // Walks about `center_world` at that distance; `scale` 1: body 0.6 m long.
  Creature(glm::vec3 center_world, float walk_radius, float scale);

  // One rigid piece each, with its place at a time.
  const std::vector<Mesh>& pieces() const { return pieces_; }
  glm::mat4 transform(uint32_t piece, double time_s) const;
  // Where a leg's foot is, [0, 6).
  glm::vec3 foot(uint32_t leg, double time_s) const;

 private:
  glm::mat4 body(double time_s) const;
  // The body's place without its bob and roll.
  glm::mat4 course(double time_s) const;

  glm::vec3 center_world_;
  float walk_radius_;
  float scale_;
  std::vector<Mesh> pieces_;
};

}  // namespace reprise::lab
