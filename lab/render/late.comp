// SPDX-License-Identifier: MIT
//
// The light that is kept from techniques: shaded in every frame at a few positions of each pixel
// that it reaches. rgb: equation hiddenGain, a: its base.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_arithmetic : require

#include "core/workgroup.h"
#include "equations/hidden_light.h"
#include "lab/render/shade_triangle.glsl"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

layout(binding = kFirstPassBinding) writeonly uniform image2D late_image;
layout(push_constant) uniform Push {
  LateConstants push;
};

// Yang et al. 2009, section 1: such layers are sampled once a pixel, or supersampled. It is the
// mask's edges and the surface's bumps that alias in what the quotient leaves.
const int kMostPositions = 4;
const vec2 kPositions_px[kMostPositions] =
    vec2[](vec2(-0.125, -0.375), vec2(0.375, -0.125), vec2(0.125, 0.375), vec2(-0.375, 0.125));

vec2 offsetOf(int position) {
  return push.positions > 1u ? kPositions_px[position] : vec2(0.0);
}

bool hiddenLightReaches(vec3 position_world) {
  for (uint i = 0u; i < frame.light_count; ++i) {
    if ((frame.lights[i].layer & shown_light_layers) != 0u) continue;
    vec3 color = lightAt(i, position_world).color;
    if (color.r + color.g + color.b > 0.0) return true;
  }
  return false;
}

void main() {
  ivec2 px = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(px, ivec2(frame.extent_px)))) return;

  shown_light_layers = kLightLayerMain;
  int positions = int(push.positions);
  vec2 center_px = vec2(px) + 0.5 - push.jitter_px;
  selectLightTile(px);
  VisibleTriangle seen;
  bool reached = false;
  if (fetchTriangle(px, seen)) {
    for (int i = 0; i < positions; ++i) {
      reached =
          reached || hiddenLightReaches(surfaceAt(seen, center_px + offsetOf(i)).position_world);
    }
  }
  vec4 gain = vec4(0.0, 0.0, 0.0, kLeastShownLight);
  if (reached) {
    vec3 shown = vec3(0.0);
    for (int i = 0; i < positions; ++i) shown += shadeTriangle(seen, center_px + offsetOf(i));
    float share = 1.0 / float(positions);
    gain.a = hiddenBase(share * shown_gleam, share * hidden_light);
    gain.rgb = hiddenGain(share * shown, share * hidden_light, gain.a);
  }
  countEvaluations(reached ? push.positions : 0u);
  imageStore(late_image, px, gain);
}
