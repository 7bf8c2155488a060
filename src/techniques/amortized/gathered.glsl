// SPDX-License-Identifier: MIT
//
// What a frame takes from its history, as the gathering passes leave it to the new sample.
#ifndef REPRISE_AMORTIZED_GATHERED_GLSL
#define REPRISE_AMORTIZED_GATHERED_GLSL

#include "techniques/amortized/surface.glsl"

// Depth lies in the alpha of RGBA16F; what is farther than a half can say is equally far.
const float kFarthestHalf = 65504.0;
// Less of a tent than this has shown nothing.
const float kLeastWeight = 1.0e-4;
// Of a blurred pixel: one a pixel of motion, so that the tents overlap; longer motion is sampled
// more sparsely.
const int kMostShutterTaps = 16;

struct Gathered {
  vec3 target;  // (16): the buffer to be written; 0 where nothing lies under its tent
  bool begins;  // nothing does
  vec3 pixel;   // (20), mean
  float pixel_weight;
  float count;     // N of the previous frame
  uint quadrants;  // of buffers whose reprojection failed
};

int shutterTaps(vec2 motion_px) {
  return clamp(int(ceil(k.shutter * length(motion_px))), 1, kMostShutterTaps);
}

// Residuals lie in 8 bits: the square root keeps small ones apart.
vec4 packedResiduals(vec4 residuals) {
  return sign(residuals) * sqrt(min(abs(residuals), vec4(1.0)));
}
vec4 unpackedResiduals(vec4 stored) {
  return sign(stored) * stored * stored;
}

// As buffers keep it. 0 says "never written": the nearest surface is a little in front of the eye.
float storedDepth(ivec2 px, ivec2 last_px) {
  return clamp(depthAt(px, last_px), 1.0e-6, kFarthestHalf);
}

#endif
