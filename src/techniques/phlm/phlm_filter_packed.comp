// SPDX-License-Identifier: MIT
//
// Algorithm 1 with models of 256 bits (packed_model.glsl).
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/half_rounding.glsl"
#include "equations/filters.h"
#include "core/workgroup.h"
#include "techniques/phlm/pixel.glsl"
#include "techniques/phlm/filter.glsl"
#include "techniques/phlm/packed_model.glsl"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

layout(binding = 0) uniform sampler2D color_image;
layout(binding = 1) uniform sampler2D depth_image;
layout(binding = 2) uniform sampler2D motion_image;
layout(binding = 3) uniform sampler2D made_feature_image;  // this frame's, of the feature pass
layout(binding = 4) uniform sampler2D feature_image;       // the frame's before; rgb, a: view depth
layout(binding = 5) uniform usampler2D model_0;
layout(binding = 6) uniform usampler2D model_1;
layout(binding = 7) writeonly uniform image2D next_feature_image;
layout(binding = 8) writeonly uniform uimage2D next_model_0;
layout(binding = 9) writeonly uniform uimage2D next_model_1;
layout(binding = 10) writeonly uniform image2D output_image;
layout(binding = 11, std140) uniform Constants {
  PhlmConstants k;
};

LinearModel fetchedModel(ivec2 px) {
  return unpackedModel(texelFetch(model_0, px, 0), texelFetch(model_1, px, 0));
}

// Intercepts and level alone.
vec4 colorTexel(ivec2 px) {
  uvec2 bits = texelFetch(model_0, px, 0).xy;
  return vec4(unpackHalf2x16(bits.x), unpackHalf2x16(bits.y));
}

#include "techniques/phlm/cubic_color.glsl"

// Bilinear over what four texels hold: the bits themselves cannot be filtered. At rest the pixel's
// own texel has all the weight, and the loop ends after it.
LinearModel loadModel(vec2 px, vec2 last_center_px) {
  vec2 base_px = floor(px - 0.5);
  vec2 f = px - 0.5 - base_px;
  LinearModel sum = constantModel(vec3(0.0), 0.0, 0.0);
  for (int i = 0; i < 4; ++i) {
    vec2 corner = vec2(i & 1, i >> 1);
    vec2 w = mix(1.0 - f, f, corner);
    float weight = w.x * w.y;
    if (weight <= 0.0) continue;
    ivec2 at_px = ivec2(clamp(base_px + corner, vec2(0.0), last_center_px - 0.5));
    sum = weightedSum(sum, fetchedModel(at_px), weight);
  }
  if (kHistoryFilter == kFilterCatmullRom) {
    vec4 color = cubicColor(px, last_center_px);
    sum.intercept = color.rgb;
    sum.level = color.a;
  }
  return sum;
}

void storeModel(ivec2 px, LinearModel m) {
  m.intercept = evenlyRoundedToHalf(max(m.intercept, vec3(0.0)), px, k.frame.frame_number);
  PackedModel bits = packedModel(m);
  imageStore(next_model_0, px, bits.color);
  imageStore(next_model_1, px, bits.rest);
}

#include "techniques/phlm/filter_main.glsl"
