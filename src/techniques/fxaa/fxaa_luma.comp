// SPDX-License-Identifier: MIT
//
// Luma of the tone-mapped, display-encoded colour (README.md, eq. 1), for the search to read
// between texels.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/frame_inputs.glsl"
#include "core/workgroup.h"
#include "equations/color_space.h"
#include "techniques/fxaa/fxaa_shared.h"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

layout(binding = 0) uniform sampler2D color_image;
layout(binding = 1) writeonly uniform image2D luma_image;
layout(binding = 2, std140) uniform Constants {
  FxaaConstants k;
};

void main() {
  ivec2 px = ivec2(gl_GlobalInvocationID.xy);
  ivec2 last_px = ivec2(k.frame.extent_px) - 1;
  if (any(greaterThan(px, last_px))) return;
  imageStore(luma_image, px, vec4(perceptualLuma(fetchColor(color_image, px, last_px))));
}
