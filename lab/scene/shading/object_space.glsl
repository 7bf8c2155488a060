// SPDX-License-Identifier: MIT
// Solid textures live in an instance's own space: the grain stays in the wood while it moves.
#ifndef REPRISE_LAB_OBJECT_SPACE_GLSL
#define REPRISE_LAB_OBJECT_SPACE_GLSL

#include "lab/scene/shading/surface_point.glsl"

// Declared by lab/render/shade_triangle.glsl: object_texels (as world_texels, before any
// transform) and transforms.

vec3 positionObject(SurfacePoint s) {
  return texelFetch(object_texels, int(2u * s.vertices.x)).xyz * s.barycentrics.x +
         texelFetch(object_texels, int(2u * s.vertices.y)).xyz * s.barycentrics.y +
         texelFetch(object_texels, int(2u * s.vertices.z)).xyz * s.barycentrics.z;
}

// Directions of the instance's space in the world; scenes scale uniformly.
vec3 directionWorld(SurfacePoint s, vec3 direction_object) {
  return normalize(mat3(transforms[s.instance]) * direction_object);
}

// The normal of a surface displaced by a solid height field: `gradient_object` is the gradient of
// the height (m/m) in the instance's space; its part along the normal does not tilt it.
vec3 bumpedNormal(SurfacePoint s, vec3 gradient_object) {
  mat3 turn = mat3(transforms[s.instance]);
  vec3 gradient_world = turn * gradient_object * inversesqrt(dot(turn[0], turn[0]));
  vec3 tilt = gradient_world - dot(gradient_world, s.normal_world) * s.normal_world;
  return normalize(s.normal_world - tilt);
}

#endif
