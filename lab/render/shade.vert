// SPDX-License-Identifier: MIT
// Draws again what visibility_invariant.vert drew, for shade.frag.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "lab/render/frame_data.h"

invariant gl_Position;
const uint kWorldBinding = kFirstPassBinding;
#include "lab/render/visibility_vertex.glsl"
