// SPDX-License-Identifier: MIT
//
// World positions and normals of every vertex, now and `frames_back` ago: once a frame, so that the
// per-pixel passes read vertices and need no transforms.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/workgroup.h"
#include "lab/render/frame_data.h"
#include "lab/render/sway.glsl"

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
layout(binding = 6, std430) readonly buffer Sways {
  GpuSway sways[];
};
layout(push_constant) uniform Push {
  TransformConstants push;
};

// 1: the scene has vertices that follow the wind.
layout(constant_id = 0) const uint kSways = 1u;

// Both instants go through the same arithmetic: what a frame finds as its past is, bit for bit,
// where that past frame drew it.
vec3 placed(vec3 position, mat4 world_from_object, GpuSway sway, vec4 wind) {
  precise vec3 position_world;
  if (kSways != 0u) {
    precise vec3 arm = position - sway.pivot_angle.xyz;
    precise vec3 turned_position =
        sway.pivot_angle.xyz + turned(arm, sway.axis_phase.xyz, swayAngle(sway, wind));
    position_world =
        (world_from_object * vec4(turned_position, 1.0)).xyz + swayPush_world(sway, wind);
  } else {
    position_world = (world_from_object * vec4(position, 1.0)).xyz;
  }
  return position_world;
}

void main() {
  uint i = gl_GlobalInvocationID.y * push.row_length + gl_GlobalInvocationID.x;
  if (gl_GlobalInvocationID.x >= push.row_length || i >= push.vertex_count) return;
  GpuVertex vertex = vertices[i];
  uint instance = vertex_instances[i];
  mat4 now = transforms[instance];
  mat4 then = transforms[push.frames_back * frame.instance_count + instance];
  vec4 wind_now = frame.wind[0];
  vec4 wind_then = frame.wind[push.frames_back];
  GpuSway sway = GpuSway(vec4(0.0), vec4(0.0), vec4(0.0));
  vec3 normal = vertex.normal_v.xyz;
  if (kSways != 0u) {
    sway = sways[i];
    normal = turned(normal, sway.axis_phase.xyz, swayAngle(sway, wind_now));
  }
  // Cofactors: right for any scale. Shading makes normals unit and turns them to the eye.
  mat3 turn = mat3(cross(now[1].xyz, now[2].xyz), cross(now[2].xyz, now[0].xyz),
                   cross(now[0].xyz, now[1].xyz));
  vec3 normal_world = turn * normal;
  float length_squared = dot(normal_world, normal_world);
  if (length_squared > 0.0) normal_world *= inversesqrt(length_squared);
  world[i] =
      GpuVertex(vec4(placed(vertex.position_u.xyz, now, sway, wind_now), vertex.position_u.w),
                vec4(normal_world, vertex.normal_v.w));
  previous_world[i] = vec4(placed(vertex.position_u.xyz, then, sway, wind_then), 0.0);
}
