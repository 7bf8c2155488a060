// SPDX-License-Identifier: MIT
#include "lab/scene/two_bone.h"

#include <algorithm>
#include <cmath>

namespace reprise::lab {

TwoBone reach(glm::vec2 root, glm::vec2 target, float upper, float lower, float bend) {
  const glm::vec2 way = target - root;
  const float asked = std::max(glm::length(way), 1.0e-5f);
  const float distance =
      std::clamp(asked, 1.0001f * std::abs(upper - lower), 0.9999f * (upper + lower));
  const glm::vec2 along = way / asked;
  const glm::vec2 left(-along.y, along.x);
  // Law of cosines: the joint's foot on the way, and its height above it.
  const float foot = (upper * upper - lower * lower + distance * distance) / (2.0f * distance);
  const float height = std::sqrt(std::max(upper * upper - foot * foot, 0.0f));
  return {root + foot * along + std::copysign(height, bend) * left, root + distance * along};
}

float hangingAngle(glm::vec2 from, glm::vec2 to) {
  const glm::vec2 way = to - from;
  return std::atan2(way.x, -way.y);
}

}  // namespace reprise::lab
