// SPDX-License-Identifier: MIT
//
// Coarse pixel shading as hardware does it (Vaidyanathan et al. 2014): visibility at every pixel,
// one evaluation for a coarse pixel and each triangle in it, at the coarse pixel's centre, also
// where the triangle does not cover that.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_arithmetic : require

#include "core/workgroup.h"
#include "lab/render/shade_triangle.glsl"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

layout(binding = kFirstPassBinding) writeonly uniform image2D color_image;
layout(push_constant) uniform Push {
  CoarseConstants push;
};

// A plane that is seen edge-on runs through infinity within a few pixels: beyond this ratio of view
// depths to the covered pixel a triangle is shaded where it is covered.
const float kFarthestExtrapolation = 4.0;

// Proportional to 1 / view depth of the triangle's plane at a position.
float inverseDepth(VisibleTriangle seen, vec2 sample_px) {
  vec2 ndc = sample_px / frame.extent_px * 2.0 - 1.0;
  return perspectiveSum(clipFromWorld(positionU(seen.triangle.x).xyz, 0u),
                        clipFromWorld(positionU(seen.triangle.y).xyz, 0u),
                        clipFromWorld(positionU(seen.triangle.z).xyz, 0u), ndc);
}

void main() {
  int size = int(push.size);
  ivec2 origin_px = ivec2(push.origin_x_px, push.origin_y_px);
  // The first coarse pixels may begin outside the frame.
  ivec2 base_px = origin_px - size * ivec2(greaterThan(origin_px, ivec2(0))) +
                  size * ivec2(gl_GlobalInvocationID.xy);
  ivec2 extent_px = ivec2(frame.extent_px);
  if (any(greaterThanEqual(base_px, extent_px))) return;

  shown_light_layers = push.light_layers;
  vec2 sample_px = vec2(base_px) + 0.5 * float(size) - push.jitter_px;
  uvec2 keys[kMaxCoarseSize * kMaxCoarseSize];
  vec3 colors[kMaxCoarseSize * kMaxCoarseSize];
  int distinct = 0;
  uint evaluated = 0u;
  for (int i = 0; i < size * size; ++i) {
    ivec2 px = base_px + ivec2(i % size, i / size);
    if (any(lessThan(px, ivec2(0))) || any(greaterThanEqual(px, extent_px))) continue;
    uvec2 key = texelFetch(visibility_image, px, 0).xy;
    int found = 0;
    while (found < distinct && keys[found] != key) ++found;
    if (found == distinct) {
      selectLightTile(px);
      VisibleTriangle seen;
      vec3 color = background();
      if (fetchTriangle(px, seen)) {
        vec2 own_px = vec2(px) + 0.5 - push.jitter_px;
        float ratio = inverseDepth(seen, own_px) / inverseDepth(seen, sample_px);
        bool reachable = ratio > 1.0 / kFarthestExtrapolation && ratio < kFarthestExtrapolation;
        color = shadeTriangle(seen, reachable ? sample_px : own_px);
        ++evaluated;
      }
      keys[distinct] = key;
      colors[distinct] = color;
      ++distinct;
    }
    imageStore(color_image, px, vec4(colors[found], 1.0));
  }
  countEvaluations(evaluated);
}
