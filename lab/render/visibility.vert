// SPDX-License-Identifier: MIT
#version 450
#extension GL_GOOGLE_include_directive : require

const uint kWorldBinding = 1u;
#include "lab/render/visibility_vertex.glsl"
