// SPDX-License-Identifier: MIT
//
// Serves a technique's sample requests: one invocation an entry of the list, one evaluation for
// each quadrant that it asks for. Entries are a pixel's own, so their order does not matter.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_arithmetic : require

#include "equations/shading_offset.h"
#include "lab/render/shade_triangle.glsl"

layout(local_size_x = 64) in;  // REPRISE_REQUEST_GROUP_SIZE

layout(binding = kFirstPassBinding) writeonly uniform image2D
    extra_image;  // rgb: sum, a: evaluations
// As reprise.h lays it out.
layout(binding = kFirstPassBinding + 1u, std430) readonly buffer Requests {
  uint groups_x;
  uint groups_y;
  uint groups_z;
  uint count;
  uint entries[];
};
layout(push_constant) uniform Push {
  ServeConstants push;
};

void main() {
  shown_light_layers = push.light_layers;
  uint index = gl_GlobalInvocationID.x;
  uint served = 0u;
  if (index < count) {
    uint entry = entries[index];
    ivec2 px = ivec2(int(entry & 16383u), int((entry >> 14) & 16383u));
    selectLightTile(px);
    VisibleTriangle seen;
    bool covered = fetchTriangle(px, seen);
    vec4 sum = vec4(0.0);
    for (uint quadrant = 0u; quadrant < 4u; ++quadrant) {
      if ((entry & (1u << (28u + quadrant))) == 0u) continue;
      vec2 sample_px = vec2(px) + 0.5 + quadrantOffset(quadrant);
      sum += vec4(covered ? shadeTriangle(seen, sample_px) : background(), 1.0);
      served += covered ? 1u : 0u;
    }
    imageStore(extra_image, px, sum);
  }
  countEvaluations(served);
}
