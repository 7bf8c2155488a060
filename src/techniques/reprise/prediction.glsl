// SPDX-License-Identifier: MIT
// What the passes agree on: what lies in the prediction image.
#ifndef REPRISE_TECHNIQUES_REPRISE_PREDICTION_GLSL
#define REPRISE_TECHNIQUES_REPRISE_PREDICTION_GLSL

#include "core/frame_inputs.glsl"
#include "equations/color_space.h"
#include "techniques/reprise/reprise_shared.h"

const ivec2 kCross[5] = ivec2[5](ivec2(0, 0), ivec2(-1, 0), ivec2(1, 0), ivec2(0, -1), ivec2(0, 1));
// Added to the index into kCross in alpha: nothing was foretold here.
const float kNoPrediction = 8.0;

float isPredicted(vec4 predicted) {
  return predicted.a < kNoPrediction - 0.5 ? 1.0 : 0.0;
}
int surfaceIndex(vec4 predicted) {
  return int(predicted.a + 0.5) & 7;
}

// Inverse view depth, which is linear over the pixels of a plane.
float nearness(FrameConstants frame, sampler2D depth_image, ivec2 px, ivec2 last_px) {
  return 1.0 / viewDepth(frame, texelFetch(depth_image, clamp(px, ivec2(0), last_px), 0).x);
}
// Of two differences to neighbours the smaller: the larger may lead to another surface.
float smallerOf(float a, float b) {
  return abs(a) < abs(b) ? a : b;
}

#endif
