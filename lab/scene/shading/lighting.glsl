// SPDX-License-Identifier: MIT
// The scene's lights at a surface. Includers have `frame` (lab/render/scene_buffers.glsl).
#ifndef REPRISE_LAB_LIGHTING_GLSL
#define REPRISE_LAB_LIGHTING_GLSL

#include "lab/scene/shading/surface_point.glsl"

// Mask of kLightLayer...: which light the pass shows. Set once, before anything is shaded.
uint shown_light_layers = kAllLightLayers;

struct Arriving {
  vec3 to_light_world;  // unit
  vec3 color;           // what a white surface that faces the light shows
};

Arriving lightAt(uint i, vec3 position_world) {
  GpuLight light = frame.lights[i];
  vec3 color = (light.layer & shown_light_layers) != 0u ? light.color.rgb : vec3(0.0);
  if (light.kind == kLightSun) return Arriving(-light.direction_world.xyz, color);
  vec3 to_light = light.position_world.xyz - position_world;
  float distance_squared = max(dot(to_light, to_light), 1.0e-6);
  to_light *= inversesqrt(distance_squared);
  color /= distance_squared;
  if (light.kind != kLightPoint) {
    float cosine = -dot(to_light, light.direction_world.xyz);
    color *= smoothstep(light.cone_cosines.y, light.cone_cosines.x, cosine);
  }
  return Arriving(to_light, color);
}

vec3 ambientLight() {
  return (shown_light_layers & kLightLayerMain) != 0u ? frame.ambient.rgb : vec3(0.0);
}

// Lambert and normalized Blinn-Phong under all lights. `open`: share of the ambient light that gets
// here; `gloss`: exponent of the highlight; `reflectance`: of the highlight, all directions.
vec3 litSurface(SurfacePoint s, vec3 normal_world, vec3 albedo, float open, float reflectance,
                float gloss) {
  vec3 color = albedo * ambientLight() * open;
  for (uint i = 0u; i < frame.light_count; ++i) {
    Arriving light = lightAt(i, s.position_world);
    vec3 halfway = normalize(light.to_light_world + s.to_eye_world);
    float specular =
        reflectance * (gloss + 8.0) * 0.125 * pow(max(dot(normal_world, halfway), 0.0), gloss);
    float facing = max(dot(normal_world, light.to_light_world), 0.0);
    color += (albedo + specular) * light.color * facing;
  }
  return color;
}

#endif
