// SPDX-License-Identifier: MIT
// What the passes agree on: what lies in the prediction image.
#ifndef REPRISE_TECHNIQUES_REPRISE_PREDICTION_GLSL
#define REPRISE_TECHNIQUES_REPRISE_PREDICTION_GLSL

#include "core/frame_inputs.glsl"
#include "equations/color_space.h"
#include "techniques/reprise/reprise_shared.h"

const ivec2 kCross[5] = ivec2[5](ivec2(0, 0), ivec2(-1, 0), ivec2(1, 0), ivec2(0, -1), ivec2(0, 1));
// Added to the index into kCross in alpha: nothing was foretold here; the surface moves.
const float kNoPrediction = 8.0;
const float kMoves = 16.0;
// Motion below this is none: what half-precision motion images leave of a still camera (px).
const float kStillMotion_px = 0.01;
// Doubts are this much greater at rest: nothing is lost by waiting, and history is long enough to
// be worth it.
const float kPatience = 4.0;

float isPredicted(vec4 predicted) {
  return (int(predicted.a + 0.5) & 8) == 0 ? 1.0 : 0.0;
}
bool isMoving(vec4 predicted) {
  return predicted.a > kMoves - 0.5;
}
int surfaceIndex(vec4 predicted) {
  return int(predicted.a + 0.5) & 7;
}

// Inverse view depth, which is linear over the pixels of a plane.
float nearness(FrameConstants frame, sampler2D depth_image, ivec2 px, ivec2 last_px) {
  return 1.0 / viewDepth(frame, texelFetch(depth_image, clamp(px, ivec2(0), last_px), 0).x);
}
// History's depths as inverse view depths in halves: of the closest surface (the silhouettes' one),
// and the farthest seen lately, whose last four bits give way to the frames since then. The sign
// says whether they move against each other.
const uint kPartingBit = 0x80000000u;
uint packedDepths(float near, float far, uint age, bool parting) {
  uint word = packHalf2x16(vec2(min(far, 65504.0), min(near, 65504.0)));
  return (word & ~(kPartingBit | 15u)) | min(age, 15u) | (parting ? kPartingBit : 0u);
}
// x: farthest, y: closest.
vec2 unpackedDepths(uint word) {
  return unpackHalf2x16(word & ~(kPartingBit | 15u));
}
bool areParting(uint word) {
  return (word & kPartingBit) != 0u;
}
uint farAge(uint word) {
  return word & 15u;
}

// Of the differences to both sides of a pixel the smaller: the larger may lead to another surface.
// Of opposite signs both do, as from a bar of one pixel: no slope can be seen there.
float slopeOf(float a, float b) {
  return a * b > 0.0 ? (abs(a) < abs(b) ? a : b) : 0.0;
}

#endif
