// SPDX-License-Identifier: MIT
//
// Of each pixel the depth of the front-most of nine points two pixels apart, whether that moves
// with it, and whether it lies at a silhouette (eq. 4 of README.md). Here and not in the resolve,
// since pixels two apart share those points: an invocation has a lattice of 4 x 6 points two pixels
// apart, of which the inner 2 x 4 are the pixels that it tells of, and fetches each point once for
// all of them.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/frame_inputs.glsl"
#include "core/workgroup.h"
#include "equations/coarse.h"
#include "techniques/cpst/cpst_shared.h"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

layout(binding = 0) uniform sampler2D depth_image;
layout(binding = 1) uniform sampler2D motion_image;
// A texel for four pixels (cpst_shared.h), a word for each row of them.
layout(binding = 2) writeonly uniform uimage2D silhouette_image;
layout(binding = 3, std140) uniform Constants {
  CpstConstants k;
};

const float kFarthest = 3.0e38;

struct Front {
  float depth;  // in the frame's order: less is nearer
  vec2 motion_px;
  float longest_square;  // of all that were looked at (px^2)
};

// Of equal depths the first counts.
Front frontOf(Front first, Front second) {
  bool nearer = second.depth < first.depth;
  return Front(nearer ? second.depth : first.depth, nearer ? second.motion_px : first.motion_px,
               max(first.longest_square, second.longest_square));
}

Front pointAt(ivec2 px, ivec2 last_px) {
  ivec2 at = clamp(px, ivec2(0), last_px);
  vec2 motion_px = motionPx(k.frame, texelFetch(motion_image, at, 0).xy);
  float depth = texelFetch(depth_image, at, 0).x * k.frame.depth_order;
  // What is no number is behind all that is.
  depth = depth < kFarthest ? depth : kFarthest;
  return Front(depth, motion_px, dot(motion_px, motion_px));
}

// Three points of a row around a column.
struct Row {
  Front own;
  Front beside;  // the other two
  Front all;
};

Row rowOf(Front left, Front own, Front right) {
  return Row(own, frontOf(left, right), frontOf(frontOf(left, own), right));
}

uint toldFrom(Row above, Row row, Row below) {
  // Of (4) are the eight points around.
  Front front = frontOf(frontOf(above.all, row.beside), below.all);
  vec2 own_px = row.own.motion_px;
  float longest_square = max(front.longest_square, row.own.longest_square);
  bool found = isSilhouette(own_px, front.motion_px, longest_square, k.silhouette_share);
  // The pixel itself counts here.
  vec2 apart_px = row.own.depth <= front.depth ? vec2(0.0) : front.motion_px - own_px;
  bool together = dot(apart_px, apart_px) < k.uncover_motion_px * k.uncover_motion_px;
  float depth = min(row.own.depth, front.depth) * k.frame.depth_order;
  return toldBits(viewDepth(k.frame, depth), together, found);
}

Row[2] rowsAt(ivec2 px, ivec2 last_px) {
  Front points[4];
  for (int x = 0; x < 4; ++x) points[x] = pointAt(px + ivec2(2 * x - 2, 0), last_px);
  return Row[2](rowOf(points[0], points[1], points[2]), rowOf(points[1], points[2], points[3]));
}

uint wordFrom(Row above[2], Row row[2], Row below[2]) {
  return toldFrom(above[0], row[0], below[0]) | toldFrom(above[1], row[1], below[1]) << 16;
}

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  // Two texels, one below the other: 2 x 2 of them tell of 4 x 4 pixels.
  texel.y = 4 * (texel.y >> 1) + (texel.y & 1);
  ivec2 px = toldPixel(texel);
  ivec2 last_px = ivec2(k.frame.extent_px) - 1;
  if (any(greaterThan(px, last_px))) return;

  // By hand: a loop over rows is slower than it saves on lavapipe, which keeps what a loop carries
  // in memory.
  Row a[2] = rowsAt(px - ivec2(0, 2), last_px);
  Row b[2] = rowsAt(px, last_px);
  Row c[2] = rowsAt(px + ivec2(0, 2), last_px);
  uint word = wordFrom(a, b, c);
  a = rowsAt(px + ivec2(0, 4), last_px);
  imageStore(silhouette_image, texel, uvec4(word, wordFrom(b, c, a), 0u, 0u));
  if (px.y + 4 > last_px.y) return;
  b = rowsAt(px + ivec2(0, 6), last_px);
  word = wordFrom(c, a, b);
  c = rowsAt(px + ivec2(0, 8), last_px);
  imageStore(silhouette_image, texel + ivec2(0, 2), uvec4(word, wordFrom(a, b, c), 0u, 0u));
}
