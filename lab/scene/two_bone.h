// SPDX-License-Identifier: MIT
//
// A limb of two rigid bones in a plane: where its joint and its end are when it reaches for a
// target.
#pragma once

#include <glm/glm.hpp>

namespace reprise::lab {

struct TwoBone {
  glm::vec2 joint;
  glm::vec2 end;  // the target, or the nearest point that the limb reaches
};

// `bend` > 0: the joint lies to the left of the way from root to target, < 0: to the right.
TwoBone reach(glm::vec2 root, glm::vec2 target, float upper, float lower, float bend);

// Angle about the plane's normal that turns "hanging down", (0, -1), into from -> to.
float hangingAngle(glm::vec2 from, glm::vec2 to);

}  // namespace reprise::lab
