// SPDX-License-Identifier: MIT
//
// How light changed, a tile: as its surroundings say, then as the tile itself says (eq. 4 to 6).
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/frame_inputs.glsl"
#include "core/workgroup.h"
#include "equations/evidence.h"
#include "techniques/reprise/prediction.glsl"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

layout(binding = 0) uniform sampler2D came_image;
layout(binding = 1) uniform sampler2D told_image;
layout(binding = 2) uniform sampler2D light_image;  // rgb shift of the frame before, a: its noise
layout(binding = 3) writeonly uniform image2D next_light_image;
layout(binding = 4) writeonly uniform image2D gain_image;
layout(binding = 5, std140) uniform Constants {
  RepriseConstants k;
};

// Tiles on each side that are the surroundings: 40 px.
const int kSurroundings = 2;
// Samples of a tile that count as independent: aliasing of a straight edge errs along its length.
const float kTileCount = 8.0;
// Weight of a new difference in the mean of the squared differences from frame to frame.
const float kNoiseMemory = 0.2;
// A relative shift beyond this says no more.
const float kMaxShift = 100.0;

vec3 ratio(vec3 came, vec3 told) {
  return clamp(came / max(told, vec3(1.0e-3)), vec3(0.25), vec3(4.0));
}

void main() {
  ivec2 tile = ivec2(gl_GlobalInvocationID.xy);
  ivec2 last_tile = (ivec2(k.frame.extent_px) - 1) / kTileSize_px;
  if (any(greaterThan(tile, last_tile))) return;

  // Weighted means of the tiles, and the scatter of the tiles about them.
  vec3 came = vec3(0.0);
  vec3 told = vec3(0.0);
  vec3 shift_sum = vec3(0.0);
  float square = 0.0;
  float count = 0.0;
  float count_squares = 0.0;
  bool moves = false;
  for (int y = -kSurroundings; y <= kSurroundings; ++y) {
    for (int x = -kSurroundings; x <= kSurroundings; ++x) {
      ivec2 at = tile + ivec2(x, y);
      if (any(lessThan(at, ivec2(0))) || any(greaterThan(at, last_tile))) continue;
      vec4 c = texelFetch(came_image, at, 0);
      vec4 t = texelFetch(told_image, at, 0);
      moves = moves || t.a < 0.0;
      t.a = abs(t.a);
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
  vec4 then = texelFetch(light_image, tile, 0);
  float noise = then.a * k.frame.has_history;
  vec3 step = mean - then.rgb;
  float next_noise = mix(noise, 0.5 * dot(step, step), kNoiseMemory);
  imageStore(next_light_image, tile,
             vec4(clamp(mean, vec3(-kMaxShift), vec3(kMaxShift)), min(next_noise, kMaxColor)));
  float doubt = moves ? k.doubt_light : kPatience * k.doubt_light;
  float believed = believedShare(dot(mean, mean), variance + noise + kSmallestSquare, doubt);
  vec3 gain = ratio(came, told);
  gain = mix(vec3(1.0), gain, believed);

  // What of its own the tile says beyond that.
  vec4 c = texelFetch(came_image, tile, 0);
  vec4 t = texelFetch(told_image, tile, 0);
  t.a = abs(t.a);
  vec3 rest = c.rgb - t.rgb * gain;
  float own_noise = t.a * (c.a / kTileCount + t.a * noise);
  float own = believedShare(dot(rest, rest), own_noise, doubt);
  gain = mix(gain, ratio(c.rgb, t.rgb), own);
  imageStore(gain_image, tile, vec4(gain, 1.0));
}
