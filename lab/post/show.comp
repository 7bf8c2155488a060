// SPDX-License-Identifier: MIT
//
// Bloom, exposure, tone curve: what the display gets.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/frame_inputs.glsl"
#include "core/workgroup.h"
#include "equations/color_space.h"
#include "lab/post/coarser.glsl"
#include "lab/post/post_data.h"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

layout(binding = 0) uniform sampler2D color_image;
layout(binding = 1) uniform sampler2D bloom_image;
layout(binding = 2, std430) readonly buffer Eye {
  Adaptation eye;
};
layout(binding = 3) writeonly uniform image2D shown_image;
layout(push_constant) uniform Push {
  ShowConstants push;
};

void main() {
  ivec2 px = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(px, imageSize(shown_image)))) return;
  vec3 own = sanitizedColor(texelFetch(color_image, px, 0).rgb);
  vec3 color = eye.exposure * mix(own, coarserAt(bloom_image, px), push.bloom);
  imageStore(shown_image, px, vec4(displayFromLinear(color), 1.0));
}
