// SPDX-License-Identifier: MIT
//
// Sums over 8 x 8 pixels of what was foretold and of what came (eq. 3).
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/frame_inputs.glsl"
#include "core/workgroup.h"
#include "techniques/reprise/prediction.glsl"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

layout(binding = 0) uniform sampler2D color_image;
layout(binding = 1) uniform sampler2D predicted_image;
layout(binding = 2) writeonly uniform image2D came_image;  // rgb weighted mean, a: square of change
layout(binding = 3) writeonly uniform image2D
    told_image;  // rgb weighted mean, a: share of valid; below 0: some move
layout(binding = 4, std140) uniform Constants {
  RepriseConstants k;
};

void main() {
  ivec2 tile = ivec2(gl_GlobalInvocationID.xy);
  ivec2 last_px = ivec2(k.frame.extent_px) - 1;
  ivec2 first_px = tile * kTileSize_px;
  if (any(greaterThan(first_px, last_px))) return;
  vec3 came = vec3(0.0);
  vec3 told = vec3(0.0);
  float square = 0.0;
  float count = 0.0;
  bool moves = false;
  for (int y = 0; y < kTileSize_px; ++y) {
    for (int x = 0; x < kTileSize_px; ++x) {
      ivec2 px = min(first_px + ivec2(x, y), last_px);
      vec4 predicted = texelFetch(predicted_image, px, 0);
      vec3 texel = texelFetch(color_image, px, 0).rgb;
      vec3 color = sanitizedColor(texel);
      // What was no colour says nothing of light.
      float known = isPredicted(predicted) * (color == texel ? 1.0 : 0.0);
      vec3 change = color - predicted.rgb;
      came += known * color;
      told += known * predicted.rgb;
      square += known * dot(change, change);
      count += known;
      moves = moves || isMoving(predicted);
    }
  }
  const float kShare = 1.0 / float(kTileSize_px * kTileSize_px);
  // Relative to the tile's luma: a weight a pixel would take its noise for change, since where
  // history is too dark by chance it weighs more and light seems to rise. To the larger of both
  // lumas: what vanishes says as much as what appears.
  float luma = max(lumaYCoCg(told), lumaYCoCg(came)) / max(count, 1.0);
  float scale = kShare / (luma + kDarkest);
  came = min(came * scale, vec3(kMaxColor));
  square = min(square * kShare * (scale / kShare) * (scale / kShare), kMaxColor);
  imageStore(came_image, tile, vec4(came, square));
  imageStore(told_image, tile, vec4(told * scale, (moves ? -count : count) * kShare));
}
