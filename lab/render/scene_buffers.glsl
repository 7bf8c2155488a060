// SPDX-License-Identifier: MIT
// Bindings 0 to 4 of every compute pass that looks at surfaces.
#ifndef REPRISE_LAB_SCENE_BUFFERS_GLSL
#define REPRISE_LAB_SCENE_BUFFERS_GLSL

#include "lab/render/frame_data.h"
#include "lab/render/surface.glsl"

layout(binding = 0, std430) readonly buffer Frame { GpuFrame frame; };
layout(binding = 1, std430) readonly buffer Vertices { GpuVertex vertices[]; };
layout(binding = 2, std430) readonly buffer Indices { uint indices[]; };
layout(binding = 3, std430) readonly buffer Transforms { mat4 transforms[]; };
layout(binding = 4) uniform usampler2D visibility_image;

// What visibility saw at a pixel; false where it saw nothing.
bool fetchTriangle(ivec2 px, out Triangle triangle) {
  uvec2 visible = texelFetch(visibility_image, px, 0).xy;
  if (visible.x == 0u) return false;
  uint first = 3u * visible.y;
  triangle = Triangle(uvec3(indices[first], indices[first + 1u], indices[first + 2u]),
                      visible.x - 1u);
  return true;
}

mat4 transformOf(uint instance, uint frames_back) {
  return transforms[frames_back * frame.instance_count + instance];
}

vec4 clipOf(vec3 position, uint instance, uint frames_back) {
  return frame.view_projection[frames_back] * (transformOf(instance, frames_back) * vec4(position, 1.0));
}

vec2 pxFromClip(vec4 clip) { return (clip.xy / clip.w * 0.5 + 0.5) * frame.extent_px; }

#endif
