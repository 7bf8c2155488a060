// SPDX-License-Identifier: MIT
#version 450
#extension GL_GOOGLE_include_directive : require

#include "lab/render/frame_data.h"

layout(binding = 0, std430) readonly buffer Frame { GpuFrame frame; };
layout(binding = 1, std430) readonly buffer Vertices { GpuVertex vertices[]; };
layout(binding = 2, std430) readonly buffer Indices { uint indices[]; };
layout(binding = 3, std430) readonly buffer Transforms { mat4 transforms[]; };
layout(push_constant) uniform Push { VisibilityConstants push; };

// The provoking vertex is a triangle's first, so that this is the triangle's number.
layout(location = 0) flat out uint triangle;

void main() {
  vec4 position_world = transforms[push.instance] *
                        vec4(vertices[indices[gl_VertexIndex]].position_u.xyz, 1.0);
  vec4 clip = frame.view_projection[0] * position_world;
  // Content moves by +jitter (reprise.h, sampling).
  clip.xy += 2.0 * push.jitter_px / frame.extent_px * clip.w;
  gl_Position = clip;
  triangle = uint(gl_VertexIndex) / 3u;
}
