// SPDX-License-Identifier: MIT
//
// Textures of a scene: arrays by size class, chosen by a switch, so that no descriptor is indexed.
// Includers say where they are bound: kSamplerBinding, then one binding a class.
#ifndef REPRISE_LAB_TEXTURES_GLSL
#define REPRISE_LAB_TEXTURES_GLSL

layout(binding = kSamplerBinding) uniform sampler texture_sampler;
layout(binding = kSamplerBinding + 1u) uniform texture2DArray textures_0;
layout(binding = kSamplerBinding + 2u) uniform texture2DArray textures_1;
layout(binding = kSamplerBinding + 3u) uniform texture2DArray textures_2;
layout(binding = kSamplerBinding + 4u) uniform texture2DArray textures_3;
layout(binding = kSamplerBinding + 5u) uniform texture2DArray textures_4;
layout(binding = kSamplerBinding + 6u) uniform texture2DArray textures_5;
layout(binding = kSamplerBinding + 7u) uniform texture2DArray textures_6;
layout(binding = kSamplerBinding + 8u) uniform texture2DArray textures_7;

// Classes in use: what lies above is not compiled in.
layout(constant_id = 3) const uint kTextureClasses = 8u;

// Lookups along the longer gradient at most; 1: none.
layout(constant_id = 5) const uint kAnisotropy = 16u;

#define REPRISE_LAB_EXTENT(layers) vec2(textureSize(sampler2DArray(layers, texture_sampler), 0).xy)
// A loop a class and not classes in a loop, and no loop that ends before its first turn: CPU
// drivers run both sides of a branch, so that every lookup would be one in each class, and the body
// of a for loop once more than it has turns.
#define REPRISE_LAB_LOOK_UP(index, layers)                                                  \
  if (kTextureClasses > index) {                                                            \
    uint turns = array == index + 1u ? count : 0u;                                          \
    uint i = 0u;                                                                            \
    do {                                                                                    \
      vec2 at = uv + step_uv * (float(i) + 0.5 - 0.5 * float(count));                       \
      if (i < turns) {                                                                      \
        sum += textureLod(sampler2DArray(layers, texture_sampler), vec3(at, layer), level); \
      }                                                                                     \
      ++i;                                                                                  \
    } while (i < turns);                                                                    \
  }

// Sum of `count` lookups, `step_uv` apart and about `uv`.
vec4 lookUp(uint name, vec2 uv, vec2 step_uv, uint count, float level) {
  float layer = float(name & 0xffffu);
  uint array = name >> 16u;  // + 1
  vec4 sum = vec4(0.0);
  REPRISE_LAB_LOOK_UP(0u, textures_0)
  REPRISE_LAB_LOOK_UP(1u, textures_1)
  REPRISE_LAB_LOOK_UP(2u, textures_2)
  REPRISE_LAB_LOOK_UP(3u, textures_3)
  REPRISE_LAB_LOOK_UP(4u, textures_4)
  REPRISE_LAB_LOOK_UP(5u, textures_5)
  REPRISE_LAB_LOOK_UP(6u, textures_6)
  REPRISE_LAB_LOOK_UP(7u, textures_7)
  return sum;
}

vec2 textureExtent(uint name) {
  uint array = name >> 16u;
  if (kTextureClasses > 0u && array == 1u) return REPRISE_LAB_EXTENT(textures_0);
  if (kTextureClasses > 1u && array == 2u) return REPRISE_LAB_EXTENT(textures_1);
  if (kTextureClasses > 2u && array == 3u) return REPRISE_LAB_EXTENT(textures_2);
  if (kTextureClasses > 3u && array == 4u) return REPRISE_LAB_EXTENT(textures_3);
  if (kTextureClasses > 4u && array == 5u) return REPRISE_LAB_EXTENT(textures_4);
  if (kTextureClasses > 5u && array == 6u) return REPRISE_LAB_EXTENT(textures_5);
  if (kTextureClasses > 6u && array == 7u) return REPRISE_LAB_EXTENT(textures_6);
  if (kTextureClasses > 7u && array == 8u) return REPRISE_LAB_EXTENT(textures_7);
  return vec2(1.0);
}

// Colour of a material's texture (GpuMaterial) by the gradients of uv a pixel; white where it is 0.
// Gradients carry the mip bias: level + b is gradient * 2^b. The level is one number a call: with
// gradients a lookup, the sampler would find it anew each time.
//
// Anisotropy is filtered here, as EXT_texture_filter_anisotropic describes it, and not by the
// sampler: N = ceil(min(P_max / P_min, kAnisotropy)) trilinear lookups along the longer gradient,
// at the level log2(P_max / N). The same on every device, and bounded whatever the gradients: with
// lavapipe 22.3's own anisotropy a frame of `foliage` did not end in 100 s; why was not found out.
vec4 sampleTexture(uint name, vec2 uv, vec2 uv_dx, vec2 uv_dy) {
  if (name == 0u) return vec4(1.0);
  vec2 extent = textureExtent(name);
  float texels_x = length(uv_dx * extent);
  float texels_y = length(uv_dy * extent);
  float most = max(texels_x, texels_y);
  float ratio = most / max(min(texels_x, texels_y), 1.0);
  // Where it is not a number there is one lookup too.
  bool longer = kAnisotropy > 1u && ratio > 1.0 && most < 1.0e6;
  uint count = longer ? uint(ceil(min(ratio, float(kAnisotropy)))) : 1u;
  vec2 step_uv = (texels_x > texels_y ? uv_dx : uv_dy) / float(count);
  if (!longer) step_uv = vec2(0.0);
  float level = log2(most / float(count));
  return lookUp(name, uv, step_uv, count, level) / float(count);
}

#endif
