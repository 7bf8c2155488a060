// SPDX-License-Identifier: MIT
//
// FXAA 3.11, quality (Lottes 2011): finds the edge through a pixel, follows it to both ends, and
// shifts the pixel's fetch across it by where in the span the pixel lies. Equation numbers refer to
// README.md of this folder.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/frame_inputs.glsl"
#include "core/workgroup.h"
#include "equations/color_space.h"
#include "equations/fxaa.h"
#include "techniques/fxaa/fxaa_shared.h"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

layout(constant_id = 0) const uint kBlend = 0u;

layout(binding = 0) uniform sampler2D color_image;
layout(binding = 1) uniform sampler2D luma_image;  // linear filter
layout(binding = 2) writeonly uniform image2D output_image;
layout(binding = 3, std140) uniform Constants {
  FxaaConstants k;
};

float luma(ivec2 px, ivec2 last_px) {
  return texelFetch(luma_image, clamp(px, ivec2(0), last_px), 0).x;
}

float lumaBetween(vec2 px) {
  vec2 inside_px = clamp(px, vec2(0.5), k.frame.extent_px - 0.5);
  return textureLod(luma_image, inside_px * k.frame.history_texel_uv, 0.0).x;
}

float stepLength_px(int i) {
  vec4 four = i < 4 ? k.steps_0_3_px : i < 8 ? k.steps_4_7_px : k.steps_8_11_px;
  return four[i & 3];
}

// One direction along the edge from `from_px`, which lies between its two rows (eq. 5).
struct SpanEnd {
  float distance_px;
  float luma_offset;  // of the last position looked at, from the edge's mean
};

SpanEnd spanEnd(vec2 from_px, vec2 direction, float edge_mean, float threshold) {
  SpanEnd end = SpanEnd(stepLength_px(0), 0.0);
  int last = int(k.step_count) - 1;
  for (int i = 1; i <= last; ++i) {
    end.luma_offset = lumaBetween(from_px + direction * end.distance_px) - edge_mean;
    if (abs(end.luma_offset) >= threshold) break;
    // The last step is taken on trust: nothing is looked at behind it.
    end.distance_px += stepLength_px(i);
  }
  return end;
}

vec3 toBlend(vec3 linear) {
  return kBlend == kBlendDisplay ? displayFromLinear(linear) : linear;
}
vec3 fromBlend(vec3 c) {
  return kBlend == kBlendDisplay ? linearFromDisplay(c) : c;
}

void main() {
  ivec2 px = ivec2(gl_GlobalInvocationID.xy);
  ivec2 last_px = ivec2(k.frame.extent_px) - 1;
  if (any(greaterThan(px, last_px))) return;

  vec3 color = fetchColor(color_image, px, last_px);
  float m = luma(px, last_px);
  float n = luma(px + ivec2(0, -1), last_px);
  float s = luma(px + ivec2(0, 1), last_px);
  float e = luma(px + ivec2(1, 0), last_px);
  float w = luma(px + ivec2(-1, 0), last_px);
  float brightest = max(max(max(n, s), max(e, w)), m);
  float range = brightest - min(min(min(n, s), min(e, w)), m);
  if (!fxaaIsEdge(range, brightest, k.edge_threshold, k.edge_threshold_min)) {  // eq. 2
    imageStore(output_image, px, vec4(color, 1.0));
    return;
  }

  float nw = luma(px + ivec2(-1, -1), last_px);
  float ne = luma(px + ivec2(1, -1), last_px);
  float sw = luma(px + ivec2(-1, 1), last_px);
  float se = luma(px + ivec2(1, 1), last_px);
  float down = fxaaBend(vec3(nw, w, sw), vec3(n, m, s), vec3(ne, e, se));  // eq. 3
  float along_rows = fxaaBend(vec3(nw, n, ne), vec3(w, m, e), vec3(sw, s, se));
  bool horizontal = down >= along_rows;

  // The side of the steeper step, and the mean of the two rows that the edge divides (eq. 4).
  float side_a = horizontal ? n : w;
  float side_b = horizontal ? s : e;
  bool toward_a = abs(side_a - m) >= abs(side_b - m);
  float steepest = max(abs(side_a - m), abs(side_b - m));
  float edge_mean = 0.5 * (m + (toward_a ? side_a : side_b));
  ivec2 across = horizontal ? ivec2(0, 1) : ivec2(1, 0);
  if (toward_a) across = -across;
  vec2 along = horizontal ? vec2(1.0, 0.0) : vec2(0.0, 1.0);

  vec2 edge_px = vec2(px) + 0.5 + 0.5 * vec2(across);
  SpanEnd before = spanEnd(edge_px, -along, edge_mean, 0.25 * steepest);
  SpanEnd after = spanEnd(edge_px, along, edge_mean, 0.25 * steepest);

  // Only a pixel that lies on the other side of the mean than its nearer end does is cut by the
  // edge (eq. 6).
  float nearer = before.distance_px < after.distance_px ? before.luma_offset : after.luma_offset;
  bool cut = (nearer < 0.0) != (m - edge_mean < 0.0);
  float shift_px = cut ? fxaaSpanShift(before.distance_px, after.distance_px) : 0.0;
  shift_px =
      max(shift_px, fxaaSubpixelShift(n + s + e + w, nw + ne + sw + se, m, range, k.subpixel));

  // A bilinear fetch that is shifted along one axis is a mixture of two texels (eq. 7).
  vec3 other = fetchColor(color_image, px + across, last_px);
  vec3 mixed = fromBlend(mix(toBlend(color), toBlend(other), shift_px));
  imageStore(output_image, px, vec4(mixed, 1.0));
}
