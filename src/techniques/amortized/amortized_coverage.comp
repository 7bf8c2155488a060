// SPDX-License-Identifier: MIT
//
// Silhouettes: each of four samples of the pixel shows the surface that the rasterizer saw there,
// in the colour that the surface has where a pixel's centre lies on it. Shading stays one sample a
// pixel; coverage costs depth alone.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/frame_inputs.glsl"
#include "core/workgroup.h"
#include "techniques/amortized/amortized_shared.h"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

layout(binding = 0) uniform sampler2D resolved_image;
layout(binding = 1) uniform sampler2D depth_image;
layout(binding = 2) uniform sampler2DMS depth_samples_image;
layout(binding = 3) writeonly uniform image2D output_image;
layout(binding = 4, std140) uniform Constants {
  CoverageConstants k;
};

const int kSamples = 4;
// Depths that differ by this share of the tolerance are as good as each other; the nearer neighbour
// is then better.
const float kIndifferent = 0.1;
// Vulkan's standard positions of four samples, from the pixel's centre.
const vec2 kPositions_px[kSamples] =
    vec2[](vec2(-0.125, -0.375), vec2(0.375, -0.125), vec2(-0.375, 0.125), vec2(0.125, 0.375));

float depthAt(ivec2 px) {
  ivec2 last_px = ivec2(k.frame.extent_px) - 1;
  return viewDepth(k.frame, texelFetch(depth_image, clamp(px, ivec2(0), last_px), 0).x);
}

void main() {
  ivec2 px = ivec2(gl_GlobalInvocationID.xy);
  ivec2 last_px = ivec2(k.frame.extent_px) - 1;
  if (any(greaterThan(px, last_px))) return;
  float around[9];
  for (int i = 0; i < 9; ++i) around[i] = depthAt(px + ivec2(i % 3 - 1, i / 3 - 1));
  float own = around[4];
  // The surface's own slope: across a silhouette the difference would be larger.
  vec2 slope =
      vec2(abs(around[5] - own) < abs(own - around[3]) ? around[5] - own : own - around[3],
           abs(around[7] - own) < abs(own - around[1]) ? around[7] - own : own - around[1]);

  vec3 own_color = texelFetch(resolved_image, px, 0).rgb;
  vec3 sum = vec3(0.0);
  for (int i = 0; i < kSamples; ++i) {
    float seen = viewDepth(k.frame, texelFetch(depth_samples_image, px, i).x);
    float tolerance = k.depth_tolerance * min(seen, own);
    float expected = own + dot(slope, kPositions_px[i]);
    vec3 color = own_color;
    if (abs(seen - expected) > tolerance + abs(slope.x) + abs(slope.y)) {
      // Another surface: that of the neighbour which is nearest in depth, on the sample's side
      // where several are. One that is narrower than a pixel may have no centre: the pixel's own
      // colour stands for it.
      float best = max(abs(seen - own), tolerance);
      for (int n = 0; n < 9; ++n) {
        vec2 step_px = vec2(n % 3 - 1, n / 3 - 1);
        float mismatch = (abs(around[n] - seen) + kIndifferent * tolerance) *
                         (1.0 + length(step_px - kPositions_px[i]));
        if (n == 4 || mismatch >= best) continue;
        best = mismatch;
        ivec2 at_px = clamp(px + ivec2(step_px), ivec2(0), last_px);
        color = texelFetch(resolved_image, at_px, 0).rgb;
      }
    }
    sum += color;
  }
  imageStore(output_image, px, vec4(sum / float(kSamples), 1.0));
}
