// SPDX-License-Identifier: MIT
// Iron that rusts in patches, a solid texture. parameters.x: patches a metre, y: share of rust.
#ifndef REPRISE_LAB_RUST_GLSL
#define REPRISE_LAB_RUST_GLSL

#include "lab/scene/shading/lighting.glsl"
#include "lab/scene/shading/noise.glsl"
#include "lab/scene/shading/object_space.glsl"

const float kCrustStep_m = 0.0012;
const float kCrust_per_m = 240.0;

Appearance rustAppearance(SurfacePoint s) {
  vec3 p = positionObject(s);
  float patches =
      0.65 * valueNoise(p * s.parameters.x, 71u) + 0.35 * valueNoise(p * s.parameters.x * 5.3, 72u);
  float rust = smoothstep(0.42, 0.50, patches + s.parameters.y - 0.5);
  float crust = valueNoise(p * kCrust_per_m, 73u);
  vec3 gradient = vec3(valueNoise((p + vec3(kCrustStep_m, 0.0, 0.0)) * kCrust_per_m, 73u),
                       valueNoise((p + vec3(0.0, kCrustStep_m, 0.0)) * kCrust_per_m, 73u),
                       valueNoise((p + vec3(0.0, 0.0, kCrustStep_m)) * kCrust_per_m, 73u)) -
                  crust;
  gradient *= mix(0.00025, 0.0016, rust) / kCrustStep_m;
  vec3 oxide = mix(vec3(0.15, 0.045, 0.020), vec3(0.48, 0.19, 0.060), crust);
  vec3 iron = vec3(0.20, 0.21, 0.23);
  return Appearance(bumpedNormal(s, gradient), mix(iron, oxide, rust), 1.0, mix(0.30, 0.015, rust),
                    mix(110.0, 12.0, rust), vec3(0.0));
}

#endif
