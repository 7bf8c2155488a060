// SPDX-License-Identifier: MIT
//
// Where shading changed (eq. 8): means of this frame's samples against history's, over 3 x 3 texels
// of the moments, 12 x 12 pixels: by one texel at a time what coarse samples make of a fine texture
// passes for change (README.md).
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/frame_constants.h"
#include "core/workgroup.h"
#include "equations/coarse.h"
#include "techniques/cpst/cpst_shared.h"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

layout(binding = 0) uniform usampler2D moments_image;  // cpst_moments.comp
// The same, of which the last word is now gain of history and certainty: the resolve needs both of
// the same texels.
layout(binding = 1) writeonly uniform uimage2D change_image;
layout(binding = 2, std140) uniform Constants {
  CpstConstants k;
};

// History is scaled by no more: what was all but black has no colour to scale. Of no weight on what
// was tried: 2 to 32 differ by 0.01 dB on indoor/fly, hangar/fly and lights/dolly.
const float kMostGain = 8.0;

void main() {
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  ivec2 last = (ivec2(k.frame.extent_px) - 1) / int(kMomentSize);
  if (any(greaterThan(texel, last))) return;
  float difference = 0.0;
  float square_of_error = 0.0;
  for (int i = 0; i < 9; ++i) {
    ivec2 at = clamp(texel + ivec2(i % 3 - 1, i / 3 - 1), ivec2(0), last);
    vec2 change = unpackHalf2x16(texelFetch(moments_image, at, 0).w);
    difference += change.x;
    square_of_error += change.y * change.y;
  }
  // Not divided by the count once more, as for errors that are independent: those of textures are
  // not.
  float error = k.change_errors * sqrt(square_of_error / 9.0);
  float certainty = 0.0;
  if (k.frame.has_history > 0.5) certainty = changeCertainty(difference / 9.0, error);
  uvec4 own = texelFetch(moments_image, texel, 0);
  float now = unpackHalf2x16(own.x).x;
  float own_difference = unpackHalf2x16(own.w).x;
  float gain = changeGain(now - own_difference, certainty * own_difference, kMostGain);
  imageStore(change_image, texel, uvec4(own.xyz, packHalf2x16(vec2(gain, certainty))));
}
