// SPDX-License-Identifier: MIT
// Colour spaces and tone curves of the resolves and of the figures. Colours are linear RGB, >= 0.
#ifndef REPRISE_EQUATIONS_COLOR_SPACE_H
#define REPRISE_EQUATIONS_COLOR_SPACE_H

#include "equations/language.h"
EQ_BEGIN

// Rec. ITU-R BT.709 luminance of linear RGB.
EQ_FN float luma709(vec3 c) {
  return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z;
}

// Rec. ITU-R BT.601 luma.
EQ_FN float luma601(vec3 c) {
  return 0.299f * c.x + 0.587f * c.y + 0.114f * c.z;
}

// Malvar, Sullivan 2003. x: Y = (R + 2G + B) / 4, y: Co, z: Cg.
EQ_FN vec3 yCoCgFromRgb(vec3 c) {
  return vec3(0.25f * c.x + 0.5f * c.y + 0.25f * c.z, 0.5f * c.x - 0.5f * c.z,
              -0.25f * c.x + 0.5f * c.y - 0.25f * c.z);
}
EQ_FN vec3 rgbFromYCoCg(vec3 c) {
  return vec3(c.x + c.y - c.z, c.x + c.z, c.x - c.y - c.z);
}

// The luma of YCoCg: cheap, and linear in the colour, which expandByLuma needs.
EQ_FN float lumaYCoCg(vec3 c) {
  return 0.25f * c.x + 0.5f * c.y + 0.25f * c.z;
}

// Karis 2014: c / (1 + luma), and its inverse c / (1 - luma). The bound keeps the inverse finite:
// the largest half, 65504, comes back as 65504.
EQ_FN vec3 compressByLuma(vec3 c) {
  return c / (1.0f + lumaYCoCg(c));
}
EQ_FN vec3 expandByLuma(vec3 c) {
  return c / max(1.0f - lumaYCoCg(c), 1.0f / 65505.0f);
}

// c / (1 + max channel), and its inverse.
EQ_FN vec3 compressByMax(vec3 c) {
  return c / (1.0f + max(c.x, max(c.y, c.z)));
}
EQ_FN vec3 expandByMax(vec3 c) {
  return c / max(1.0f - max(c.x, max(c.y, c.z)), 1.0f / 65505.0f);
}

// Lopez 2022, trick 2: the resolve in log space. Black, which has no logarithm, is e^-10.
EQ_CONST float kLogOfBlack = -10.0f;
EQ_FN float logFromLinear(float x) {
  return x > 0.0f ? max(log(x), kLogOfBlack) : kLogOfBlack;
}
EQ_FN vec3 logFromLinear(vec3 c) {
  return vec3(logFromLinear(c.x), logFromLinear(c.y), logFromLinear(c.z));
}
EQ_FN float linearFromLog(float x) {
  return x <= kLogOfBlack ? 0.0f : exp(x);
}
EQ_FN vec3 linearFromLog(vec3 c) {
  return vec3(linearFromLog(c.x), linearFromLog(c.y), linearFromLog(c.z));
}

// The display space of every figure: x / (1 + x) a channel, then power 1 / 2.2. [0, 1).
EQ_FN float displayFromLinear(float x) {
  float v = max(x, 0.0f);
  return pow(v / (1.0f + v), 1.0f / 2.2f);
}
EQ_FN vec3 displayFromLinear(vec3 c) {
  return vec3(displayFromLinear(c.x), displayFromLinear(c.y), displayFromLinear(c.z));
}

// Its inverse on [0, 1]; 1 itself, which no colour reaches, comes back as 65504.
EQ_FN float linearFromDisplay(float x) {
  float v = pow(clamp(x, 0.0f, 1.0f), 2.2f);
  return v / max(1.0f - v, 1.0f / 65505.0f);
}
EQ_FN vec3 linearFromDisplay(vec3 c) {
  return vec3(linearFromDisplay(c.x), linearFromDisplay(c.y), linearFromDisplay(c.z));
}

// Luma as the eye ranks it: Rec. 601 of the display-encoded colour. FXAA's thresholds need it;
// linear luma has no edges in the dark and too many in the light.
EQ_FN float perceptualLuma(vec3 c) {
  return luma601(displayFromLinear(c));
}

EQ_END
#endif
