// SPDX-License-Identifier: MIT
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/frame_inputs.glsl"
#include "core/workgroup.h"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

layout(binding = 0) uniform sampler2D color_image;
layout(binding = 1) writeonly uniform image2D output_image;
layout(binding = 2, std140) uniform Constants {
  FrameConstants frame;
};

void main() {
  ivec2 px = ivec2(gl_GlobalInvocationID.xy);
  ivec2 extent_px = ivec2(frame.extent_px);
  if (any(greaterThanEqual(px, extent_px))) return;
  imageStore(output_image, px, vec4(fetchColor(color_image, px, extent_px - 1), 1.0));
}
