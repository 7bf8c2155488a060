// SPDX-License-Identifier: MIT
//
// Of each pixel the depth of the front-most of nine points two pixels apart, whether that moves
// with it, and whether it lies at a silhouette (eq. 4 of README.md). Here and not in the resolve,
// since pixels two apart share those points: an invocation has a lattice of 4 x 4 points two pixels
// apart, of which the inner four are the pixels that it tells of, and fetches each point once for
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
// A texel for four pixels, 2 * y + x in their lattice, a word each (cpst_shared.h).
layout(binding = 2) writeonly uniform uimage2D silhouette_image;
layout(binding = 3, std140) uniform Constants {
  CpstConstants k;
};

const int kSide = 4;  // of a lattice
const int kPoints = kSide * kSide;

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  ivec2 first_px = toldPixel(texel);
  ivec2 last_px = ivec2(k.frame.extent_px) - 1;
  if (any(greaterThan(first_px, last_px))) return;

  float depths[kPoints];
  float squares[kPoints];
  vec2 motions_px[kPoints];
  for (int i = 0; i < kPoints; ++i) {
    ivec2 at = clamp(first_px + 2 * (ivec2(i % kSide, i / kSide) - 1), ivec2(0), last_px);
    depths[i] = texelFetch(depth_image, at, 0).x * k.frame.depth_order;
    motions_px[i] = motionPx(k.frame, texelFetch(motion_image, at, 0).xy);
    squares[i] = dot(motions_px[i], motions_px[i]);
  }
  uvec2 told = uvec2(0u);
  for (int i = 0; i < 4; ++i) {
    int own = (i / 2 + 1) * kSide + i % 2 + 1;
    // Of (4) are the eight points around; of equal depths the first counts.
    float front = 3.0e38;
    vec2 front_motion_px = motions_px[own];
    float longest = squares[own];
    for (int n = 0; n < 9; ++n) {
      if (n == 4) continue;
      int at = own + (n / 3 - 1) * kSide + n % 3 - 1;
      bool nearer = depths[at] < front;
      front_motion_px = nearer ? motions_px[at] : front_motion_px;
      front = nearer ? depths[at] : front;
      longest = max(longest, squares[at]);
    }
    bool found = isSilhouette(motions_px[own], front_motion_px, longest, k.silhouette_share);
    // The pixel itself counts here.
    vec2 apart_px = depths[own] <= front ? vec2(0.0) : front_motion_px - motions_px[own];
    bool together = dot(apart_px, apart_px) < k.uncover_motion_px * k.uncover_motion_px;
    float front_depth = viewDepth(k.frame, min(depths[own], front) * k.frame.depth_order);
    told[i / 2] |= toldBits(front_depth, together, found) << (16 * (i % 2));
  }
  imageStore(silhouette_image, texel, uvec4(told, 0u, 0u));
}
