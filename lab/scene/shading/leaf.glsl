// SPDX-License-Identifier: MIT
// Leaves and blades of grass: thin, lit from both sides, slightly glossy. parameters: colour of the
// light that passes through rgb, share of it.
#ifndef REPRISE_LAB_LEAF_GLSL
#define REPRISE_LAB_LEAF_GLSL

#include "lab/scene/shading/textured.glsl"

const float kLeafGloss = 40.0;
const float kLeafReflectance = 0.04;

vec3 shadeLeaf(SurfacePoint s) {
  vec3 albedo = textureAt(s, materials[s.material].color_texture).rgb;
  vec3 through = albedo * s.parameters.rgb * s.parameters.w;
  float open = 0.6 + 0.4 * s.normal_world.y;
  vec3 color = litSurface(
      s, Appearance(s.normal_world, albedo, open, kLeafReflectance, kLeafGloss, vec3(0.0)));
  for (uint i = 0u; i < frame.light_count; ++i) {
    Arriving light = lightAt(i, s.position_world);
    color += through * light.color * max(-dot(s.normal_world, light.to_light_world), 0.0);
  }
  for (LampCursor c = beforeLamps(); toLamp(c); passLamp(c)) {
    Arriving light = lampAt(lampOf(c), s.position_world);
    color += through * light.color * max(-dot(s.normal_world, light.to_light_world), 0.0);
  }
  return color;
}

#endif
