// SPDX-License-Identifier: MIT
//
// World positions and normals of every vertex, now and `frames_back` ago: once a frame, so that the
// per-pixel passes read vertices and need no transforms.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/workgroup.h"
#include "lab/render/frame_data.h"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

layout(binding = 0, std140) uniform Frame {
  GpuFrame frame;
};
layout(binding = 1, std430) readonly buffer Vertices {
  GpuVertex vertices[];
};
layout(binding = 2, std430) readonly buffer VertexInstances {
  uint vertex_instances[];
};
layout(binding = 3, std430) readonly buffer Transforms {
  mat4 transforms[];
};
layout(binding = 4, std430) writeonly buffer World {
  GpuVertex world[];
};
layout(binding = 5, std430) writeonly buffer Previous {
  vec4 previous_world[];
};
layout(push_constant) uniform Push {
  TransformConstants push;
};

void main() {
  uint i = gl_GlobalInvocationID.y * push.row_length + gl_GlobalInvocationID.x;
  if (gl_GlobalInvocationID.x >= push.row_length || i >= push.vertex_count) return;
  GpuVertex vertex = vertices[i];
  vec4 position = vec4(vertex.position_u.xyz, 1.0);
  uint instance = vertex_instances[i];
  mat4 now = transforms[instance];
  mat4 then = transforms[push.frames_back * frame.instance_count + instance];
  // Scenes scale uniformly, so that normals turn as positions do.
  world[i] = GpuVertex(vec4((now * position).xyz, vertex.position_u.w),
                       vec4(mat3(now) * vertex.normal_v.xyz, vertex.normal_v.w));
  previous_world[i] = vec4((then * position).xyz, 0.0);
}
