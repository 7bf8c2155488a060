// SPDX-License-Identifier: MIT
//
// One axis of the residual's box filter (Yang et al. 2009, eq. 24 and 25). The first pass takes at
// each pixel the smallest of the last four residuals; a change must last to count.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/frame_constants.h"
#include "core/workgroup.h"
#include "techniques/amortized/amortized_shared.h"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

// 0: along rows, from the four residuals; 1: along columns, from the rows' means.
layout(constant_id = 0) const uint kColumns = 0u;

layout(binding = 0) uniform sampler2D source_image;
layout(binding = 1) writeonly uniform image2D smoothed_image;
layout(binding = 2, std140) uniform Constants {
  ResidualConstants k;
};

const int kRadius_px = 3;  // (25)

float valueAt(ivec2 px) {
  vec4 texel = texelFetch(source_image, px, 0);
  if (kColumns != 0u) return texel.x;
  float smallest = texel.x;
  for (int i = 1; i < 4; ++i) smallest = abs(texel[i]) < abs(smallest) ? texel[i] : smallest;
  return sign(smallest) * smallest * smallest;  // stored as signed roots
}

void main() {
  ivec2 px = ivec2(gl_GlobalInvocationID.xy);
  ivec2 last_px = ivec2(k.frame.extent_px) - 1;
  if (any(greaterThan(px, last_px))) return;
  float sum = 0.0;
  for (int i = -kRadius_px; i <= kRadius_px; ++i) {
    ivec2 step_px = kColumns != 0u ? ivec2(0, i) : ivec2(i, 0);
    sum += valueAt(clamp(px + step_px, ivec2(0), last_px));
  }
  imageStore(smoothed_image, px, vec4(sum / float(2 * kRadius_px + 1)));
}
