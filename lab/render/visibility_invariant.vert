// SPDX-License-Identifier: MIT
// visibility.vert for depths that shade.vert meets again: by `invariant` alone two shaders have the
// same positions bit for bit.
#version 450
#extension GL_GOOGLE_include_directive : require

invariant gl_Position;
const uint kWorldBinding = 1u;
#include "lab/render/visibility_vertex.glsl"
