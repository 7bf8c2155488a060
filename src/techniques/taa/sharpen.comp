// SPDX-License-Identifier: MIT
//
// Contrast-adaptive sharpening of the resolved image (eq. 9). History stays unsharpened: sharpening
// what is fed back grows without bound.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/frame_inputs.glsl"
#include "core/workgroup.h"
#include "equations/color_space.h"
#include "equations/sharpen.h"
#include "techniques/taa/taa_shared.h"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

layout(binding = 0) uniform sampler2D resolved_image;
layout(binding = 1) writeonly uniform image2D output_image;
layout(binding = 2, std140) uniform Constants {
  TaaConstants k;
};

void main() {
  ivec2 px = ivec2(gl_GlobalInvocationID.xy);
  ivec2 last_px = ivec2(k.frame.extent_px) - 1;
  if (any(greaterThan(px, last_px))) return;
  // The lobe is bounded for values in [0, 1]: sharpen in c / (1 + luma), a monotone tone map.
  vec3 up = compressByLuma(fetchColor(resolved_image, px + ivec2(0, -1), last_px));
  vec3 left = compressByLuma(fetchColor(resolved_image, px + ivec2(-1, 0), last_px));
  vec3 centre = compressByLuma(fetchColor(resolved_image, px, last_px));
  vec3 right = compressByLuma(fetchColor(resolved_image, px + ivec2(1, 0), last_px));
  vec3 down = compressByLuma(fetchColor(resolved_image, px + ivec2(0, 1), last_px));
  vec3 sharp = sharpened(up, left, centre, right, down, k.sharpen);
  imageStore(output_image, px, vec4(expandByLuma(clamp(sharp, vec3(0.0), vec3(0.9999))), 1.0));
}
