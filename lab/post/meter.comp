// SPDX-License-Identifier: MIT
//
// Sums of logLuminance, one a group of 8 x 8 pixels. No atomics: the same sum in every run.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/frame_inputs.glsl"
#include "core/workgroup.h"
#include "equations/exposure.h"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

layout(binding = 0) uniform sampler2D color_image;
layout(binding = 1, std430) writeonly buffer Sums {
  float sums[];
};

const uint kThreads = REPRISE_WORKGROUP_SIZE * REPRISE_WORKGROUP_SIZE;
shared float partial[kThreads];

void main() {
  ivec2 px = ivec2(gl_GlobalInvocationID.xy);
  uint thread = gl_LocalInvocationIndex;
  bool inside = all(lessThan(px, textureSize(color_image, 0)));
  partial[thread] = inside ? logLuminance(sanitizedColor(texelFetch(color_image, px, 0).rgb)) : 0.0;
  barrier();
  for (uint half_count = kThreads / 2u; half_count > 0u; half_count /= 2u) {
    if (thread < half_count) partial[thread] += partial[thread + half_count];
    barrier();
  }
  if (thread == 0u) sums[gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x] = partial[0];
}
