// SPDX-License-Identifier: MIT
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/frame_inputs.glsl"
#include "core/workgroup.h"
#include "equations/even_pyramid.h"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

layout(binding = 0) uniform sampler2D fine_image;
layout(binding = 1, rgba16f) writeonly uniform image2D coarse_image;

void main() {
  ivec2 px = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(px, imageSize(coarse_image)))) return;
  ivec2 last_px = textureSize(fine_image, 0) - 1;
  vec3 sum = vec3(0.0);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) {
      ivec2 fine_px = clamp(2 * px - 1 + ivec2(x, y), ivec2(0), last_px);
      sum += evenPyramidWeight(x) * evenPyramidWeight(y) *
             sanitizedColor(texelFetch(fine_image, fine_px, 0).rgb);
    }
  }
  imageStore(coarse_image, px, vec4(sum, 1.0));
}
