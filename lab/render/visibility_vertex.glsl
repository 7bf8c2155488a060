// SPDX-License-Identifier: MIT
//
// A triangle's corner on the screen. Includers have kWorldBinding.
#ifndef REPRISE_LAB_VISIBILITY_VERTEX_GLSL
#define REPRISE_LAB_VISIBILITY_VERTEX_GLSL

#include "lab/render/frame_data.h"

layout(binding = 0, std140) uniform Frame {
  GpuFrame frame;
};
layout(binding = kWorldBinding, std430) readonly buffer World {
  GpuVertex world[];
};
layout(binding = kWorldBinding + 1u, std430) readonly buffer Indices {
  uint indices[];
};
layout(push_constant) uniform Push {
  VisibilityConstants push;
};

// The provoking vertex is a triangle's first, so that this is the triangle's number.
layout(location = 0) flat out uint triangle;
layout(location = 1) out vec2 uv;

void main() {
  GpuVertex vertex = world[indices[gl_VertexIndex]];
  vec4 clip = frame.view_projection[0] * vec4(vertex.position_u.xyz, 1.0);
  // Content moves by +jitter (reprise.h, sampling).
  clip.xy += 2.0 * push.jitter_px / frame.extent_px * clip.w;
  gl_Position = clip;
  triangle = uint(gl_VertexIndex) / 3u;
  uv = vec2(vertex.position_u.w, vertex.normal_v.w);
}

#endif
