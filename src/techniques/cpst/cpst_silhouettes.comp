// SPDX-License-Identifier: MIT
//
// Of each of 4 x 4 pixels, which of the nine points two pixels apart is front-most, and whether it
// lies at a silhouette (eq. 4 of README.md). Here and not in the resolve, since neighbours share
// those points: a block and what is around it are four lattices of 4 x 4 points, one for each
// parity, of which the inner four are pixels of the block. A texel is fetched once for all of them.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/frame_inputs.glsl"
#include "core/workgroup.h"
#include "equations/coarse.h"
#include "techniques/cpst/cpst_shared.h"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

layout(binding = 0) uniform sampler2D depth_image;
layout(binding = 1) uniform sampler2D motion_image;
// Of pixel 4 * y + x of a block: bit of x: at a silhouette; four bits, of y for the upper half and
// of z for the lower: the front-most point, 0 to 8, 4 being the pixel.
layout(binding = 2) writeonly uniform uimage2D silhouette_image;
layout(binding = 3, std140) uniform Constants {
  CpstConstants k;
};

const int kSide = 4;  // of a lattice
const int kPoints = kSide * kSide;

void main() {
  ivec2 block = ivec2(gl_GlobalInvocationID.xy);
  ivec2 first_px = block * int(kMomentSize);
  ivec2 last_px = ivec2(k.frame.extent_px) - 1;
  if (any(greaterThan(first_px, last_px))) return;

  uint silhouettes = 0u;
  uvec2 fronts = uvec2(0u);
  for (int lattice = 0; lattice < 4; ++lattice) {
    ivec2 parity = ivec2(lattice & 1, lattice >> 1);
    float depths[kPoints];
    float squares[kPoints];
    vec2 motions[kPoints];
    for (int i = 0; i < kPoints; ++i) {
      ivec2 step = ivec2(i % kSide, i / kSide) - 1;
      ivec2 at = clamp(first_px + parity + 2 * step, ivec2(0), last_px);
      depths[i] = texelFetch(depth_image, at, 0).x * k.frame.depth_order;
      motions[i] = motionPx(k.frame, texelFetch(motion_image, at, 0).xy);
      squares[i] = dot(motions[i], motions[i]);
    }
    for (int i = 0; i < 4; ++i) {
      ivec2 step = ivec2(i % 2, i / 2);
      int own = (step.y + 1) * kSide + step.x + 1;
      float nearest_around = 3.0e38;
      vec2 front_motion = motions[own];
      float nearest = 3.0e38;
      uint front = 4u;
      float longest = squares[own];
      for (int n = 0; n < 9; ++n) {
        int at = own + (n / 3 - 1) * kSide + n % 3 - 1;
        front = depths[at] < nearest ? uint(n) : front;
        nearest = depths[at] < nearest ? depths[at] : nearest;
        longest = max(longest, squares[at]);
        if (n == 4) continue;
        front_motion = depths[at] < nearest_around ? motions[at] : front_motion;
        nearest_around = depths[at] < nearest_around ? depths[at] : nearest_around;
      }
      bool found = isSilhouette(motions[own], front_motion, sqrt(longest), k.silhouette_share);
      int pixel = (parity.y + 2 * step.y) * int(kMomentSize) + parity.x + 2 * step.x;
      silhouettes |= uint(found) << pixel;
      fronts[step.y] |= front << (4 * (pixel & 7));
    }
  }
  imageStore(silhouette_image, block, uvec4(silhouettes, fronts, 0u));
}
