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
const uint kGroup = uint(REPRISE_WORKGROUP_SIZE * REPRISE_WORKGROUP_SIZE);

// Proportional to 1 / view depth of the triangle's plane at a position.
float inverseDepth(VisibleTriangle seen, vec2 sample_px) {
  vec2 ndc = sample_px / frame.extent_px * 2.0 - 1.0;
  return perspectiveSum(clipFromWorld(positionU(seen.triangle.x).xyz, 0u),
                        clipFromWorld(positionU(seen.triangle.y).xyz, 0u),
                        clipFromWorld(positionU(seen.triangle.z).xyz, 0u), ndc);
}

// What is to be shaded: pixel of the coarse pixel (from bit 8), coarse pixel of the workgroup.
// Shaded off this list and not by the coarse pixels themselves, of which few have more than one
// triangle: their second evaluations would each hold up a whole subgroup.
shared uint items[kGroup * kMaxCoarseSize * kMaxCoarseSize];
shared uint item_count;

ivec2 pixelOf(ivec2 base_px, int i) {
  return base_px + ivec2(i % int(push.size), i / int(push.size));
}

bool withinFrame(ivec2 px) {
  return all(greaterThanEqual(px, ivec2(0))) && all(lessThan(px, ivec2(frame.extent_px)));
}

ivec2 baseOf(uint coarse_pixel) {
  ivec2 origin_px = ivec2(push.origin_x_px, push.origin_y_px);
  uvec2 at = gl_WorkGroupID.xy * gl_WorkGroupSize.xy +
             uvec2(coarse_pixel % gl_WorkGroupSize.x, coarse_pixel / gl_WorkGroupSize.x);
  // The first coarse pixels may begin outside the frame.
  return origin_px - int(push.size) * ivec2(greaterThan(origin_px, ivec2(0))) +
         int(push.size) * ivec2(at);
}

// The first pixel of each triangle becomes an item; where there is none, the sky is seen.
void listItems(uint coarse_pixel) {
  ivec2 base_px = baseOf(coarse_pixel);
  uvec2 keys[kMaxCoarseSize * kMaxCoarseSize];
  int distinct = 0;
  for (int i = 0; i < int(push.size * push.size); ++i) {
    ivec2 px = pixelOf(base_px, i);
    if (!withinFrame(px)) continue;
    uvec2 key = texelFetch(visibility_image, px, 0).xy;
    if (key.x == 0u) {
      imageStore(color_image, px, vec4(background(), 1.0));
      continue;
    }
    int found = 0;
    while (found < distinct && keys[found] != key) ++found;
    if (found < distinct) continue;
    keys[distinct] = key;
    ++distinct;
    items[atomicAdd(item_count, 1u)] = coarse_pixel | uint(i) << 8;
  }
}

// Of the pixels that show the triangle `key`.
vec2 middleOfCovered(ivec2 base_px, uvec2 key) {
  vec2 sum_px = vec2(0.0);
  float count = 0.0;
  for (int i = 0; i < int(push.size * push.size); ++i) {
    ivec2 px = pixelOf(base_px, i);
    if (!withinFrame(px) || texelFetch(visibility_image, px, 0).xy != key) continue;
    sum_px += vec2(px) + 0.5;
    count += 1.0;
  }
  return sum_px / count;
}

void shadeItem(uint item) {
  ivec2 base_px = baseOf(item & 255u);
  int first = int(item >> 8);
  ivec2 first_px = pixelOf(base_px, first);
  uvec2 key = texelFetch(visibility_image, first_px, 0).xy;
  vec2 sample_px = vec2(base_px) + 0.5 * float(push.size) - push.jitter_px;
  if (push.shade_covered != 0u) sample_px = middleOfCovered(base_px, key) - push.jitter_px;
  selectLightTile(first_px);
  VisibleTriangle seen;
  fetchTriangle(first_px, seen);
  vec2 own_px = vec2(first_px) + 0.5 - push.jitter_px;
  float ratio = inverseDepth(seen, own_px) / inverseDepth(seen, sample_px);
  bool reachable = ratio > 1.0 / kFarthestExtrapolation && ratio < kFarthestExtrapolation;
  vec3 color = shadeTriangle(seen, reachable ? sample_px : own_px);
  for (int i = first; i < int(push.size * push.size); ++i) {
    ivec2 px = pixelOf(base_px, i);
    if (!withinFrame(px)) continue;
    if (texelFetch(visibility_image, px, 0).xy == key) {
      imageStore(color_image, px, vec4(color, 1.0));
    }
  }
}

void main() {
  uint thread = gl_LocalInvocationIndex;
  shown_light_layers = push.light_layers;
  if (thread == 0u) item_count = 0u;
  barrier();
  listItems(thread);
  barrier();
  uint count = item_count;
  if (thread == 0u && count > 0u) atomicAdd(evaluations, count);
  // Asked at the end: CPU drivers run a loop's body once more than its condition holds when that
  // is asked at the beginning, with nothing to do in it.
  uint item = thread;
  do {
    if (item < count) shadeItem(items[item]);
    item += kGroup;
  } while (item < count);
}
