// SPDX-License-Identifier: MIT
//
// Mean and variance of 4 x 4 pixels, in YCoCg: LoD 2 of a mip chain of moments in one step. The
// variance, not the second moment, is stored: halves have no bits left for their difference. Beside
// it the box of the pixels' motions, by which the resolve knows where no silhouette can be.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/frame_inputs.glsl"
#include "core/workgroup.h"
#include "equations/color_space.h"
#include "techniques/cpst/cpst_shared.h"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

layout(constant_id = 0) const uint kVariance = 0u;

layout(binding = 0) uniform sampler2D color_image;
layout(binding = 1) uniform sampler2D motion_image;
layout(binding = 2) writeonly uniform uimage2D moments_image;    // three words of two halves
layout(binding = 3) writeonly uniform image2D motion_box_image;  // xy: low, zw: high, px
layout(binding = 4, std140) uniform Constants {
  CpstConstants k;
};

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  ivec2 first_px = texel * int(kMomentSize);
  ivec2 last_px = ivec2(k.frame.extent_px) - 1;
  if (any(greaterThan(first_px, last_px))) return;
  vec3 sum = vec3(0.0);
  vec3 sum_of_squares = vec3(0.0);
  for (int i = 0; i < int(kMomentSize * kMomentSize); ++i) {
    ivec2 px = first_px + ivec2(i % int(kMomentSize), i / int(kMomentSize));
    vec3 c = yCoCgFromRgb(fetchColor(color_image, px, last_px));
    sum += c;
    sum_of_squares += c * c;
  }
  float share = 1.0 / float(kMomentSize * kMomentSize);
  vec3 mean = sum * share;
  vec3 variance = min(max(sum_of_squares * share - mean * mean, vec3(0.0)), vec3(kMaxColor));
  imageStore(moments_image, texel,
             uvec4(packHalf2x16(mean.xy), packHalf2x16(vec2(mean.z, variance.x)),
                   packHalf2x16(variance.yz), 0u));
  if (kVariance != kVarianceDynamic) return;
  vec2 low_px = vec2(3.0e38);
  vec2 high_px = vec2(-3.0e38);
  for (int i = 0; i < int(kMomentSize * kMomentSize); ++i) {
    ivec2 px = first_px + ivec2(i % int(kMomentSize), i / int(kMomentSize));
    vec2 motion_px =
        motionPx(k.frame, texelFetch(motion_image, clamp(px, ivec2(0), last_px), 0).xy);
    low_px = min(low_px, motion_px);
    high_px = max(high_px, motion_px);
  }
  imageStore(motion_box_image, texel, vec4(low_px, high_px));
}
