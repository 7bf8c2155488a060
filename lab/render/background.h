// SPDX-License-Identifier: MIT
// In GLSL and C++.
#ifndef REPRISE_LAB_BACKGROUND_H
#define REPRISE_LAB_BACKGROUND_H

#ifdef __cplusplus
#include <glm/glm.hpp>
namespace reprise::lab {
using glm::vec3;
#endif

// Seen where there is no surface: a dull sky, linear.
const vec3 kBackground = vec3(0.18, 0.24, 0.33);

#ifdef __cplusplus
}  // namespace reprise::lab
#endif

#endif
