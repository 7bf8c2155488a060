// SPDX-License-Identifier: MIT
//
// Shared by the host and the shaders of `cpst`.
#ifndef REPRISE_TECHNIQUES_CPST_SHARED_H
#define REPRISE_TECHNIQUES_CPST_SHARED_H

#include "core/frame_constants.h"

#ifdef __cplusplus
#define CPST_CHOICE constexpr uint32_t
namespace reprise {
namespace cpst {
#else
#define CPST_CHOICE const uint
#endif

// Values of the choice settings, in the order of their names in cpst.cpp.
CPST_CHOICE kVarianceNone = 0u;
CPST_CHOICE kVarianceFine = 1u;
CPST_CHOICE kVarianceCoarse = 2u;
CPST_CHOICE kVarianceDynamic = 3u;

CPST_CHOICE kAboutOwn = 0u;
CPST_CHOICE kAboutMean = 1u;

CPST_CHOICE kDisocclusionNone = 0u;
CPST_CHOICE kDisocclusionScale = 1u;
CPST_CHOICE kDisocclusionTaps = 2u;

CPST_CHOICE kReconstructNone = 0u;
CPST_CHOICE kReconstructFresh = 1u;
CPST_CHOICE kReconstructAlways = 2u;

// Pixels a side that one texel of the moments stands for: LoD 2 of a mip chain.
CPST_CHOICE kMomentSize = 4u;

struct CpstConstants {
  FrameConstants frame;
  vec2 coarse_origin_px;
  float coarse_size;
  float sigma_px;          // of the shading filter
  float held_limit;        // largest summed weight of history that moves
  float held_limit_still;  // and that does not
  float gamma;             // half-size of the bound, in standard deviations
  float gamma_still;
  float silhouette_share;
  float depth_tolerance;
  float history_sharpness;
  float mean_weight;    // of the shading filter over a cycle of the jitter
  float change_errors;  // standard errors beyond which shading is held to have changed
  float uncover_motion_px;
  float padding_0;
  float padding_1;
};

#ifndef __cplusplus
// cpst_silhouettes.comp tells of 4 x 4 pixels by 2 x 2 texels, each of four pixels that are two
// apart: the first of a texel's.
ivec2 toldPixel(ivec2 texel) {
  return 4 * (texel >> 1) + (texel & 1);
}
ivec2 toldTexel(ivec2 px) {
  return 2 * (px >> 2) + (px & 1);
}

// 16 bits for each of them: view depth of the front-most of nine points two pixels apart, whether
// that moves with the pixel, and whether the pixel is at a silhouette (eq. 4). Of the depth 6 bits
// of exponent and 8 of mantissa, 2^-31 to 2^33: within 0.2 %, where it is compared by 2 %.
const uint kToldExponent = (127u - 31u) << 23;
const uint kToldShift = 15u;
uint toldBits(float view_depth, bool together, bool at_silhouette) {
  uint bits = clamp(floatBitsToUint(view_depth), kToldExponent, kToldExponent + (64u << 23) - 1u);
  uint depth = (bits - kToldExponent) >> kToldShift;
  return depth << 2 | uint(together) << 1 | uint(at_silhouette);
}
float toldDepth(uint bits) {
  return uintBitsToFloat(((bits >> 2 & 0x3fffu) << kToldShift) + kToldExponent +
                         (1u << (kToldShift - 1u)));
}
bool toldTogether(uint bits) {
  return (bits & 2u) != 0u;
}
bool toldSilhouette(uint bits) {
  return (bits & 1u) != 0u;
}
#endif

#ifdef __cplusplus
static_assert(sizeof(CpstConstants) == sizeof(FrameConstants) + 64);
}  // namespace cpst
}  // namespace reprise
#endif

#endif
