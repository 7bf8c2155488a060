// SPDX-License-Identifier: MIT
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/workgroup.h"
#include "lab/post/coarser.glsl"
#include "lab/post/post_data.h"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

layout(binding = 0) uniform sampler2D coarse_image;
layout(binding = 1, rgba16f) uniform image2D fine_image;
layout(push_constant) uniform Push {
  BloomConstants push;
};

void main() {
  ivec2 px = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(px, imageSize(fine_image)))) return;
  vec3 own = imageLoad(fine_image, px).rgb;
  imageStore(fine_image, px, vec4(mix(own, coarserAt(coarse_image, px), push.spread), 1.0));
}
