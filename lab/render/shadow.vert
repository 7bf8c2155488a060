// SPDX-License-Identifier: MIT
// What the sun sees: orthographic, depth from 0 near it to 1.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "lab/render/frame_data.h"

layout(binding = 0, std140) uniform Frame {
  GpuFrame frame;
};
layout(binding = 1, std430) readonly buffer World {
  GpuVertex world[];
};
layout(binding = 2, std430) readonly buffer Indices {
  uint indices[];
};

layout(location = 1) out vec2 uv;

void main() {
  GpuVertex vertex = world[indices[gl_VertexIndex]];
  gl_Position = frame.shadow_from_world * vec4(vertex.position_u.xyz, 1.0);
  uv = vec2(vertex.position_u.w, vertex.normal_v.w);
}
