// SPDX-License-Identifier: MIT
// The mean of what was summed.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/workgroup.h"
#include "lab/render/frame_data.h"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

layout(binding = 0) uniform sampler2D sum_image;
layout(binding = 1) writeonly uniform image2D color_image;
layout(push_constant) uniform Push {
  FinishConstants push;
};

void main() {
  ivec2 px = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(px, textureSize(sum_image, 0)))) return;
  imageStore(color_image, px, vec4(texelFetch(sum_image, px, 0).rgb * push.scale, 1.0));
}
