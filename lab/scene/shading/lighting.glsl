// SPDX-License-Identifier: MIT
// The scene's lights at a surface. Includers have `frame` (lab/render/scene_buffers.glsl) and
// sunShare (lab/render/shadow.glsl) and the lamps of a tile (lab/render/lamps.glsl).
#ifndef REPRISE_LAB_LIGHTING_GLSL
#define REPRISE_LAB_LIGHTING_GLSL

#include "lab/scene/shading/surface_point.glsl"

// Mask of kLightLayer...: which light the pass shows. Set once, before anything is shaded.
uint shown_light_layers = kAllLightLayers;
// What the other layers' lights add, of all that was lit so far, and how much of what is shown is
// not the surface's own colour: highlights and mirrored light.
vec3 hidden_light = vec3(0.0);
vec3 shown_gleam = vec3(0.0);

// A gobo's mask: a plate with round holes, seen from the lamp. `q`: 1 at the cone's edge.
float goboMask(vec2 q) {
  const float kHolesAcross = 2.6;
  vec2 hole = fract(q * kHolesAcross) - 0.5;
  // Edges as sharp as a lamp without lens throws them.
  return 1.0 - smoothstep(0.34 * 0.34, 0.37 * 0.37, dot(hole, hole));
}

struct Arriving {
  vec3 to_light_world;  // unit
  vec3 color;           // what a white surface that faces the light shows
};

Arriving lightAt(uint i, vec3 position_world) {
  GpuLight light = frame.lights[i];
  vec3 color = light.color.rgb;
  if (light.kind == kLightSun) {
    if (i == frame.shadow_light) color *= sunShare(position_world);
    return Arriving(-light.direction_world.xyz, color);
  }
  vec3 to_light = light.position_world.xyz - position_world;
  float distance_squared = max(dot(to_light, to_light), 1.0e-6);
  to_light *= inversesqrt(distance_squared);
  color /= distance_squared;
  if (light.kind != kLightPoint) {
    float cosine = -dot(to_light, light.direction_world.xyz);
    color *= smoothstep(light.cone_cosines.y, light.cone_cosines.x, cosine);
    if (light.kind == kLightGobo) {
      // Across the beam: `side` and `up` turn with the plate, (cos, sin) in the spare components.
      vec3 side = normalize(cross(light.direction_world.xyz, vec3(0.31, 0.17, 0.94)));
      vec3 up = cross(side, light.direction_world.xyz);
      vec2 at = -vec2(dot(to_light, side), dot(to_light, up)) / max(cosine, 1.0e-3);
      at *= light.cone_cosines.y *
            inversesqrt(max(1.0 - light.cone_cosines.y * light.cone_cosines.y, 1.0e-6));
      float turn_cos = light.position_world.w;
      float turn_sin = light.color.w;
      color *= goboMask(vec2(turn_cos * at.x - turn_sin * at.y, turn_sin * at.x + turn_cos * at.y));
    }
  }
  return Arriving(to_light, color);
}

// Karis 2013: falls with the square of distance and, by a window, to 0 at the range.
Arriving lampAt(uint i, vec3 position_world) {
  vec4 position_range = lamps[i].position_range;
  vec4 color_inner = lamps[i].color_inner;
  vec4 direction_outer = lamps[i].direction_outer;
  vec3 to_light = position_range.xyz - position_world;
  float distance_squared = max(dot(to_light, to_light), 1.0e-4);
  to_light *= inversesqrt(distance_squared);
  float share = distance_squared / (position_range.w * position_range.w);
  float window = max(1.0 - share * share, 0.0);
  float falloff = window * window / distance_squared;
  falloff *= smoothstep(direction_outer.w, color_inner.w, -dot(to_light, direction_outer.xyz));
  return Arriving(to_light, color_inner.rgb * falloff);
}

vec3 ambientLight() {
  return (shown_light_layers & kLightLayerMain) != 0u ? frame.ambient.rgb : vec3(0.0);
}

// What a material is at a point, before light falls on it.
struct Appearance {
  vec3 normal_world;  // unit
  vec3 albedo;
  float open;         // share of the ambient light that gets here
  float reflectance;  // of the highlight, all directions
  float gloss;        // exponent of the highlight
  vec3 mirror;        // share of the room around that is reflected (room.glsl)
};

// Lambert and normalized Blinn-Phong under one light: what is shown of it.
vec3 litBy(Arriving light, uint layer, SurfacePoint s, Appearance a) {
  vec3 halfway = normalize(light.to_light_world + s.to_eye_world);
  float specular = a.reflectance * (a.gloss + 8.0) * 0.125 *
                   pow(max(dot(a.normal_world, halfway), 0.0), a.gloss);
  float facing = max(dot(a.normal_world, light.to_light_world), 0.0);
  vec3 reflected = (a.albedo + specular) * light.color * facing;
  if ((layer & shown_light_layers) != 0u) {
    shown_gleam += specular * light.color * facing;
    return reflected;
  }
  hidden_light += reflected;
  return vec3(0.0);
}

vec3 litSurface(SurfacePoint s, Appearance a) {
  vec3 color = a.albedo * ambientLight() * a.open;
  for (uint i = 0u; i < frame.light_count; ++i) {
    color += litBy(lightAt(i, s.position_world), frame.lights[i].layer, s, a);
  }
  for (LampCursor c = beforeLamps(); toLamp(c); passLamp(c)) {
    color += litBy(lampAt(lampOf(c), s.position_world), kLightLayerMain, s, a);
  }
  return color;
}

#endif
