// SPDX-License-Identifier: MIT
//
// What the next coarser level of a pyramid shows at a texel.
#include "equations/even_pyramid.h"

vec3 coarserAt(sampler2D coarse_image, ivec2 px) {
  ivec2 last_px = textureSize(coarse_image, 0) - 1;
  ivec2 near_px = min(px / 2, last_px);
  ivec2 far_px =
      clamp(ivec2(evenPyramidFarTexel(px.x), evenPyramidFarTexel(px.y)), ivec2(0), last_px);
  vec3 near_row = kEvenPyramidNear * texelFetch(coarse_image, near_px, 0).rgb +
                  kEvenPyramidFar * texelFetch(coarse_image, ivec2(far_px.x, near_px.y), 0).rgb;
  vec3 far_row = kEvenPyramidNear * texelFetch(coarse_image, ivec2(near_px.x, far_px.y), 0).rgb +
                 kEvenPyramidFar * texelFetch(coarse_image, far_px, 0).rgb;
  return kEvenPyramidNear * near_row + kEvenPyramidFar * far_row;
}
