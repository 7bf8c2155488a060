// SPDX-License-Identifier: MIT
//
// Silhouettes (eq. 4 of README.md) of 4 x 4 pixels, a bit each. Here and not in the resolve, since
// the points two pixels around of neighbours are the same: a block and what is around it are four
// lattices of 4 x 4 points, one for each parity, of which the inner four are pixels of the block.
// Every texel is fetched once for four pixels.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/frame_inputs.glsl"
#include "core/workgroup.h"
#include "equations/coarse.h"
#include "techniques/cpst/cpst_shared.h"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

layout(binding = 0) uniform sampler2D depth_image;
layout(binding = 1) uniform sampler2D motion_image;
layout(binding = 2) uniform sampler2D motion_box_image;  // cpst_moments.comp
layout(binding = 3) writeonly uniform uimage2D silhouette_image;
layout(binding = 4, std140) uniform Constants {
  CpstConstants k;
};

const int kSide = 4;  // of a lattice
const int kPoints = kSide * kSide;

// Rounding of lengths must not hide what is just beyond the share.
const float kBoxRounding = 0.001;

// Whether a silhouette can be in the block at all: no two motions of a box differ by more than its
// diagonal, nor is one shorter than the way from 0 to it.
bool motionVaries(ivec2 block) {
  ivec2 last = (ivec2(k.frame.extent_px) - 1) / int(kMomentSize);
  vec4 box = texelFetch(motion_box_image, block, 0);
  for (int i = 0; i < 9; ++i) {
    if (i == 4) continue;
    ivec2 at = clamp(block + ivec2(i % 3 - 1, i / 3 - 1), ivec2(0), last);
    vec4 other = texelFetch(motion_box_image, at, 0);
    box = vec4(min(box.xy, other.xy), max(box.zw, other.zw));
  }
  float shortest_px = length(max(max(box.xy, -box.zw), vec2(0.0)));
  return length(box.zw - box.xy) > (1.0 - kBoxRounding) * k.silhouette_share * shortest_px;
}

vec2 motionAt(ivec2 px) {
  return motionPx(k.frame, texelFetch(motion_image, px, 0).xy);
}

void main() {
  ivec2 block = ivec2(gl_GlobalInvocationID.xy);
  ivec2 first_px = block * int(kMomentSize);
  ivec2 last_px = ivec2(k.frame.extent_px) - 1;
  if (any(greaterThan(first_px, last_px))) return;

  uint silhouettes = 0u;
  int count = motionVaries(block) ? 4 : 1;
  int lattice = 0;
  do {
    ivec2 parity = ivec2(lattice & 1, lattice >> 1);
    ivec2 base_px = first_px + parity - 2;
    float depths[kPoints];
    float squares[kPoints];
    vec2 motions[kPoints];
    for (int i = 0; i < kPoints; ++i) {
      ivec2 at = clamp(base_px + 2 * ivec2(i % kSide, i / kSide), ivec2(0), last_px);
      depths[i] = texelFetch(depth_image, at, 0).x * k.frame.depth_order;
      motions[i] = motionAt(at);
      squares[i] = dot(motions[i], motions[i]);
    }
    for (int i = 0; i < 4; ++i) {
      int own = (1 + i / 2) * kSide + 1 + i % 2;
      float nearest = 3.0e38;
      vec2 front = motions[own];
      float longest = squares[own];
      for (int n = 0; n < 9; ++n) {
        if (n == 4) continue;
        int at = own + (n / 3 - 1) * kSide + n % 3 - 1;
        bool nearer = depths[at] < nearest;
        nearest = nearer ? depths[at] : nearest;
        front = nearer ? motions[at] : front;
        longest = max(longest, squares[at]);
      }
      bool found = isSilhouette(motions[own], front, sqrt(longest), k.silhouette_share);
      ivec2 in_block = parity + 2 * ivec2(i % 2, i / 2);
      silhouettes |= uint(found) << (in_block.y * int(kMomentSize) + in_block.x);
    }
    ++lattice;
  } while (lattice < count);
  imageStore(silhouette_image, block, uvec4(count > 1 ? silhouettes : 0u, 0u, 0u, 0u));
}
