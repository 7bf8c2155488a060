// SPDX-License-Identifier: MIT
//
// History's texels to output pixels where the two extents differ (eq. 14 of README.md).
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/frame_inputs.glsl"
#include "core/workgroup.h"
#include "equations/filters.h"
#include "techniques/reprise/reprise_shared.h"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

layout(binding = 0) uniform sampler2D history_image;
layout(binding = 1) writeonly uniform image2D output_image;
layout(binding = 2, std140) uniform Constants {
  RepriseConstants k;
};

// Weights of the five texels from `first` on: the cubic read `reach` texels to both sides of `at`.
struct Taps {
  float first;
  float weight[5];
};

Taps pairOfCubics(float at, float reach) {
  float low = floor(at - reach);
  float high = floor(at + reach);
  vec4 a = cubicWeights(at - reach - low, k.sharpness);
  vec4 b = cubicWeights(at + reach - high, k.sharpness);
  Taps taps;
  taps.first = low - 1.0;
  bool apart = high > low;
  taps.weight[0] = 0.5 * (a.x + (apart ? 0.0 : b.x));
  taps.weight[1] = 0.5 * (a.y + (apart ? b.x : b.y));
  taps.weight[2] = 0.5 * (a.z + (apart ? b.y : b.z));
  taps.weight[3] = 0.5 * (a.w + (apart ? b.z : b.w));
  taps.weight[4] = 0.5 * (apart ? b.w : 0.0);
  return taps;
}

void main() {
  ivec2 px = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(px, ivec2(k.output_extent_px)))) return;
  // A pixel is this many texels wide; beyond one texel it is the mean of two places.
  vec2 width = 2.0 * k.frame.extent_px / k.output_extent_px;
  vec2 reach = clamp(0.5 * (width - 1.0), vec2(0.0), vec2(0.5));
  vec2 at = (vec2(px) + 0.5) * width - 0.5;
  Taps x = pairOfCubics(at.x, reach.x);
  Taps y = pairOfCubics(at.y, reach.y);
  vec2 last = 2.0 * k.frame.extent_px - 1.0;
  vec3 sum = vec3(0.0);
  for (int j = 0; j < 5; ++j) {
    for (int i = 0; i < 5; ++i) {
      vec2 texel = clamp(vec2(x.first + float(i), y.first + float(j)), vec2(0.0), last);
      sum += x.weight[i] * y.weight[j] * texelFetch(history_image, ivec2(texel), 0).rgb;
    }
  }
  imageStore(output_image, px, vec4(max(sum, vec3(0.0)), 1.0));
}
