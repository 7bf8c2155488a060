// SPDX-License-Identifier: MIT
#version 450
#extension GL_GOOGLE_include_directive : require

#include "equation_samples.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) writeonly uniform image2D results;

// Column: seed. Row: equation.
void main() {
  ivec2 px = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(px, imageSize(results)))) return;
  imageStore(results, px, equationSample(uint(px.y), uint(px.x)));
}
