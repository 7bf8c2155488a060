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

// Returns `of` the array that `array` names, its class + 1.
#define REPRISE_LAB_OF_CLASS(of)                                  \
  if (kTextureClasses > 0u && array == 1u) return of(textures_0); \
  if (kTextureClasses > 1u && array == 2u) return of(textures_1); \
  if (kTextureClasses > 2u && array == 3u) return of(textures_2); \
  if (kTextureClasses > 3u && array == 4u) return of(textures_3); \
  if (kTextureClasses > 4u && array == 5u) return of(textures_4); \
  if (kTextureClasses > 5u && array == 6u) return of(textures_5); \
  if (kTextureClasses > 6u && array == 7u) return of(textures_6); \
  if (kTextureClasses > 7u && array == 8u) return of(textures_7)
#define REPRISE_LAB_EXTENT(layers) vec2(textureSize(sampler2DArray(layers, texture_sampler), 0).xy)
#define REPRISE_LAB_LOOK_UP(layers) \
  textureLod(sampler2DArray(layers, texture_sampler), place, level)

vec4 lookUp(uint name, vec2 uv, float level) {
  vec3 place = vec3(uv, float(name & 0xffffu));
  uint array = name >> 16u;
  REPRISE_LAB_OF_CLASS(REPRISE_LAB_LOOK_UP);
  return vec4(1.0);
}

vec2 textureExtent(uint name) {
  uint array = name >> 16u;
  REPRISE_LAB_OF_CLASS(REPRISE_LAB_EXTENT);
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
  vec4 sum = vec4(0.0);
  uint i = 0u;
  // One loop, left after its last turn: CPU drivers run both sides of a branch, and the body of a
  // for loop once more than it has turns. A loop for each class ran a tenth faster, but LLVM does
  // not end compiling the fragment shader of `--shade-by raster` in 300 s.
  do {
    float along = float(i) + 0.5 - 0.5 * float(count);
    sum += lookUp(name, uv + step_uv * along, level);
    ++i;
  } while (i < count);
  return sum / float(count);
}

#endif
