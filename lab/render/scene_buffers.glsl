// SPDX-License-Identifier: MIT
// Bindings 0 to 3 of every compute pass that looks at surfaces.
#ifndef REPRISE_LAB_SCENE_BUFFERS_GLSL
#define REPRISE_LAB_SCENE_BUFFERS_GLSL

#include "lab/render/frame_data.h"
#include "lab/render/surface.glsl"

layout(binding = 0, std140) uniform Frame {
  GpuFrame frame;
};
layout(binding = 1) uniform samplerBuffer world_texels;      // GpuVertex: two texels each
layout(binding = 2) uniform usamplerBuffer triangle_texels;  // GpuTriangle: one texel each
layout(binding = 3) uniform usampler2D visibility_image;

struct VisibleTriangle {
  uvec4 triangle;  // GpuTriangle
  uint instance;
};

// What visibility saw at a pixel; false where it saw nothing.
bool fetchTriangle(ivec2 px, out VisibleTriangle seen) {
  uvec2 visible = texelFetch(visibility_image, px, 0).xy;
  seen.triangle = texelFetch(triangle_texels, int(visible.y));
  seen.instance = visible.x - 1u;
  return visible.x != 0u;
}

vec4 positionU(uint vertex) {
  return texelFetch(world_texels, int(2u * vertex));
}
vec4 normalV(uint vertex) {
  return texelFetch(world_texels, int(2u * vertex + 1u));
}

vec4 clipFromWorld(vec3 position_world, uint frames_back) {
  return frame.view_projection[frames_back] * vec4(position_world, 1.0);
}

vec2 pxFromClip(vec4 clip) {
  return (clip.xy / clip.w * 0.5 + 0.5) * frame.extent_px;
}

#endif
