// SPDX-License-Identifier: MIT
//
// N random point and cone lights over any scene: the workload of Xiao et al. 2018, section 5.
#pragma once

#include <vector>

#include "lab/scene/scene.h"

namespace reprise::lab {

// `count` lamps, at most kMaxLamps, before surfaces of the scene as it is at time 0, at random by
// area; every other one is a cone that looks at its surface. The first of a larger number are those
// of a smaller one. Ranges follow the scene's size, times `reach`; intensities do not depend on it.
std::vector<GpuLamp> scatteredLamps(const Scene& scene, uint32_t count, float reach = 1.0f);

}  // namespace reprise::lab
