// SPDX-License-Identifier: MIT
// visibility.frag for triangles with holes.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "lab/render/frame_data.h"

layout(binding = 0, std140) uniform Frame {
  GpuFrame frame;
};
const uint kSamplerBinding = 4u;
#include "lab/render/alpha_test.glsl"

layout(push_constant) uniform Push {
  VisibilityConstants push;
};
layout(location = 0) flat in uint triangle;
layout(location = 1) in vec2 uv;
layout(location = 0) out uvec2 visible;  // instance + 1 (0: nothing), triangle of the scene

void main() {
  if (isHole(push.material, uv, frame.mip_bias)) discard;
  visible = uvec2(push.instance + 1u, triangle);
}
