// SPDX-License-Identifier: MIT
//
// The toy horse's parts: turned and carved pieces of wood, each rigid on one bone.
#pragma once

#include <vector>

#include "lab/scene/horse/horse_pose.h"
#include "lab/scene/mesh/mesh.h"

namespace reprise::lab {

enum class HorseWood : uint32_t { kLight, kLightUpright, kDark, kHoof, kLeather, kEye, kCount };

struct HorsePart {
  Mesh mesh;
  HorseWood wood = HorseWood::kLight;
  const glm::mat4& (*bone)(const HorsePose& pose, uint32_t index) = nullptr;
  uint32_t index = 0;  // handed to `bone`
};

std::vector<HorsePart> horseParts();

}  // namespace reprise::lab
