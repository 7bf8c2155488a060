// SPDX-License-Identifier: MIT
#ifndef REPRISE_LAB_SURFACE_POINT_GLSL
#define REPRISE_LAB_SURFACE_POINT_GLSL

// A point of a surface to be shaded, with how far it moves for a step of one pixel.
struct SurfacePoint {
  vec3 position_world;
  vec3 position_dx_world;  // d position / d px.x
  vec3 position_dy_world;  // d position / d px.y
  vec3 normal_world;       // unit, towards the eye
  vec3 to_eye_world;       // unit
  vec2 uv;
  vec2 uv_dx;       // d uv / d px.x
  vec2 uv_dy;       // d uv / d px.y
  float mip_bias;   // levels
  vec4 parameters;  // of the material
  uint material;    // its number
  // For what only some materials ask (object_space.glsl).
  uvec3 vertices;
  vec3 barycentrics;
  uint instance;
};

// Side of the pixel's footprint in uv, scaled by the mip bias as a texture's level would be.
float uvFootprint(SurfacePoint s) {
  return max(length(s.uv_dx), length(s.uv_dy)) * exp2(s.mip_bias);
}

// The same in metres.
float footprint_m(SurfacePoint s) {
  return max(length(s.position_dx_world), length(s.position_dy_world)) * exp2(s.mip_bias);
}

#endif
