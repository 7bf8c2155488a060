// SPDX-License-Identifier: MIT
//
// How light changed, a tile: as its surroundings say, then as the tile itself says (eq. 6, 7).
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/frame_inputs.glsl"
#include "core/workgroup.h"
#include "equations/evidence.h"
#include "techniques/reprise/reprise_shared.h"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

layout(binding = 0) uniform sampler2D came_image;
layout(binding = 1) uniform sampler2D told_image;
layout(binding = 2) writeonly uniform image2D gain_image;
layout(binding = 3, std140) uniform Constants {
  RepriseConstants k;
};

void main() {
  ivec2 tile = ivec2(gl_GlobalInvocationID.xy);
  ivec2 last_tile = (ivec2(k.frame.extent_px) - 1) / kTileSize_px;
  if (any(greaterThan(tile, last_tile))) return;

  vec3 came = vec3(0.0);
  vec3 told = vec3(0.0);
  vec3 shift_sum = vec3(0.0);
  float square = 0.0;
  float count = 0.0;
  float count_squares = 0.0;
  for (int y = -2; y <= 2; ++y) {
    for (int x = -2; x <= 2; ++x) {
      ivec2 at = tile + ivec2(x, y);
      if (any(lessThan(at, ivec2(0))) || any(greaterThan(at, last_tile))) continue;
      vec4 c = texelFetch(came_image, at, 0);
      vec4 t = texelFetch(told_image, at, 0);
      // Means of the tile times its share of valid pixels.
      vec3 shift = (c.rgb - t.rgb) / max(t.a, 1.0e-3);
      came += c.rgb;
      told += t.rgb;
      shift_sum += t.a * shift;
      square += t.a * dot(shift, shift);
      count += t.a;
      count_squares += t.a * t.a;
    }
  }
  vec3 mean = shift_sum / max(count, 1.0e-3);
  float tiles = count * count / max(count_squares, 1.0e-3);
  float variance = max(square / max(count, 1.0e-3) - dot(mean, mean), 0.0) / max(tiles - 1.0, 0.1);
  float believed = believedShare(dot(mean, mean), variance + kResponseFloor, k.doubt_tile);
  vec3 gain = clamp(came / max(told, vec3(1.0e-3)), vec3(0.25), vec3(4.0));
  gain = mix(vec3(1.0), gain, believed);

  // What of its own the tile says beyond that.
  vec4 c = texelFetch(came_image, tile, 0);
  vec4 t = texelFetch(told_image, tile, 0);
  vec3 rest = c.rgb - t.rgb * gain;
  float own = believedShare(dot(rest, rest), c.a * t.a / k.tile_count, k.x4);
  gain = mix(gain, clamp(c.rgb / max(t.rgb, vec3(1.0e-3)), vec3(0.25), vec3(4.0)), own);
  imageStore(gain_image, tile, vec4(gain, 1.0));
}
