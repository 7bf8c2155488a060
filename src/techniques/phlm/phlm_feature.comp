// SPDX-License-Identifier: MIT
//
// The temporal feature by itself, as the paper's first kernel; `passes=split`.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/half_rounding.glsl"
#include "core/workgroup.h"
#include "techniques/phlm/pixel.glsl"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

layout(binding = 0) uniform sampler2D color_image;
layout(binding = 1) uniform sampler2D depth_image;
layout(binding = 2) uniform sampler2D motion_image;
layout(binding = 3) uniform sampler2D feature_image;  // rgb, a: view depth
layout(binding = 4) writeonly uniform image2D next_feature_image;
layout(binding = 5, std140) uniform Constants {
  PhlmConstants k;
};

void main() {
  ivec2 px = ivec2(gl_GlobalInvocationID.xy);
  ivec2 last_px = ivec2(k.frame.extent_px) - 1;
  if (any(greaterThan(px, last_px))) return;
  vec3 s[9];
  for (int i = 0; i < 9; ++i) {
    s[i] = toWorking(fetchColor(color_image, px + ivec2(i % 3 - 1, i / 3 - 1), last_px));
  }
  Origin origin = originOf(depth_image, motion_image, k, px, last_px);
  vec4 previous = textureLod(feature_image, origin.px * k.frame.history_texel_uv, 0.0);
  origin.valid = origin.valid && sameSurface(k, origin, px, previous.a);
  vec3 feature = temporalFeature(k, s, exposed(previous.rgb, k.frame.exposure_ratio), origin);
  feature = evenlyRoundedToHalf(min(feature, vec3(kMaxColor)), px, k.frame.frame_number);
  imageStore(next_feature_image, px, vec4(feature, origin.view_depth));
}
