// SPDX-License-Identifier: MIT
// A shiny surface covered with bumps, a solid texture. parameters.rgb: colour, w: bumps a metre.
#ifndef REPRISE_LAB_GLAZED_GLSL
#define REPRISE_LAB_GLAZED_GLSL

#include "lab/scene/shading/lighting.glsl"
#include "lab/scene/shading/object_space.glsl"

Appearance glazedAppearance(SurfacePoint s) {
  vec3 k = positionObject(s) * (6.2831853 * s.parameters.w);
  // Height (m) 0.055 / frequency * (sin x sin y + sin y sin z + sin z sin x), and its gradient.
  const float kSteepness = 0.055 * 6.2831853;
  vec3 sines = sin(k);
  vec3 gradient =
      kSteepness * cos(k) * vec3(sines.y + sines.z, sines.z + sines.x, sines.x + sines.y);
  float height = dot(sines, sines.yzx);
  return Appearance(bumpedNormal(s, gradient), s.parameters.rgb * (0.8 + 0.2 * height),
                    0.8 + 0.2 * clamp(height, -1.0, 1.0), 0.10, 350.0, vec3(0.75));
}

#endif
