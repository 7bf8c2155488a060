// SPDX-License-Identifier: MIT
//
// Holes of alpha-tested triangles, in fragment shaders. Includers have kSamplerBinding; materials
// lie right before the sampler.
#ifndef REPRISE_LAB_ALPHA_TEST_GLSL
#define REPRISE_LAB_ALPHA_TEST_GLSL

#include "lab/render/textures.glsl"

layout(binding = kSamplerBinding - 1u, std430) readonly buffer Materials {
  GpuMaterial materials[];
};

// The coarsest level that is tested has this many texels a side of the picture. Beyond, a leaf is a
// texel or two, their alphas are nearly the same, and a threshold would show all of it or nothing.
const float kCoarsestTested = 16.0;

vec2 limited(vec2 gradient) {
  return gradient * min(1.0, 1.0 / (kCoarsestTested * max(length(gradient), 1.0e-9)));
}

// The level follows from the rasterizer's own differences: all pixels of a quad lie in the plane of
// one triangle, so they are those of the plane, also at its edges.
bool isHole(uint material, vec2 uv, float mip_bias) {
  float scale = exp2(mip_bias);
  vec2 uv_dx = limited(dFdx(uv) * scale);
  vec2 uv_dy = limited(dFdy(uv) * scale);
  float alpha = sampleTexture(materials[material].color_texture, uv, uv_dx, uv_dy).a;
  return alpha < materials[material].alpha_cutoff;
}

#endif
