// SPDX-License-Identifier: MIT
// Depth of alpha-tested triangles alone: the sun's map, and depth at several samples a pixel.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "lab/render/frame_data.h"

layout(binding = 0, std140) uniform Frame {
  GpuFrame frame;
};
const uint kSamplerBinding = 4u;
#include "lab/render/alpha_test.glsl"

// 1: with the frame's mip bias, as the camera sees holes; the sun knows of none.
layout(constant_id = 6) const uint kBiased = 0u;

layout(push_constant) uniform Push {
  VisibilityConstants push;
};
layout(location = 1) in vec2 uv;

void main() {
  if (isHole(push.material, uv, kBiased != 0u ? frame.mip_bias : 0.0)) discard;
}
