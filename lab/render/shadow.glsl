// SPDX-License-Identifier: MIT
//
// Receiving the sun's shadow. Includers have `frame` (scene_buffers.glsl).
#ifndef REPRISE_LAB_SHADOW_GLSL
#define REPRISE_LAB_SHADOW_GLSL

layout(binding = kShadowMapBinding) uniform sampler2D shadow_map;

// 1: the scene has a sun that casts shadows.
layout(constant_id = 4) const uint kShadows = 1u;

// Share of the sun's light that reaches a point: the mean of 3 x 3 bilinear comparisons one texel
// apart, which together weigh 4 x 4 texels: per axis (1 - f, 1, 1, f) / 3, f the position between
// texel centres. Continuous in the position, so that edges glide and do not step. Lit outside the
// map.
float sunShare(vec3 position_world) {
  if (kShadows == 0u) return 1.0;
  vec3 in_map = (frame.shadow_from_world * vec4(position_world, 1.0)).xyz;
  vec2 size = vec2(textureSize(shadow_map, 0));
  vec2 texel = (in_map.xy * 0.5 + 0.5) * size - 0.5;
  if (any(lessThan(texel, vec2(1.0))) || any(greaterThan(texel, size - 3.0))) return 1.0;
  vec2 base = floor(texel);
  vec2 f = texel - base;
  float depth = in_map.z - frame.shadow_bias;
  vec2 weights_x = vec2(1.0 - f.x, f.x);
  float lit = 0.0;
  for (int row = 0; row < 2; ++row) {
    for (int column = 0; column < 2; ++column) {
      // The corner between the texels of this quarter: (0, 1) (1, 1) (1, 0) (0, 0).
      vec2 corner = (base + vec2(2 * column, 2 * row)) / size;
      vec4 seen = vec4(greaterThanEqual(textureGather(shadow_map, corner), vec4(depth)));
      vec2 x = column == 0 ? vec2(weights_x.x, 1.0) : vec2(1.0, weights_x.y);
      vec2 y = row == 0 ? vec2(1.0 - f.y, 1.0) : vec2(1.0, f.y);
      lit += y.y * dot(seen.xy, x) + y.x * dot(seen.wz, x);
    }
  }
  return lit / 9.0;
}

#endif
