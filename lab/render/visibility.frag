// SPDX-License-Identifier: MIT
#version 450
#extension GL_GOOGLE_include_directive : require

#include "lab/render/frame_data.h"

layout(push_constant) uniform Push {
  VisibilityConstants push;
};
layout(location = 0) flat in uint triangle;
layout(location = 0) out uvec2 visible;  // instance + 1 (0: nothing), triangle of the scene

void main() {
  visible = uvec2(push.instance + 1u, triangle);
}
