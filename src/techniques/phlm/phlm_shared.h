// SPDX-License-Identifier: MIT
//
// Shared by the host and the shaders of `phlm`: choices, specialization constants, the uniform
// block.
#ifndef REPRISE_TECHNIQUES_PHLM_SHARED_H
#define REPRISE_TECHNIQUES_PHLM_SHARED_H

#include "core/frame_constants.h"

#ifdef __cplusplus
#define PHLM_CHOICE constexpr uint32_t
namespace reprise {
namespace phlm {
#else
#define PHLM_CHOICE const uint
#endif

// Values of the choice settings, in the order of their names in phlm_settings.cpp.
PHLM_CHOICE kStoragePaper = 0u;
PHLM_CHOICE kStorageSymmetric = 1u;
PHLM_CHOICE kStorageHalf = 2u;
PHLM_CHOICE kStoragePacked = 3u;

PHLM_CHOICE kClipReset = 0u;
PHLM_CHOICE kClipShift = 1u;

PHLM_CHOICE kFilterBilinear = 0u;
PHLM_CHOICE kFilterCatmullRom = 1u;

PHLM_CHOICE kBoxSquare = 0u;
PHLM_CHOICE kBoxRounded = 1u;
PHLM_CHOICE kBoxVariance = 2u;

PHLM_CHOICE kBoxFeatureNever = 0u;
PHLM_CHOICE kBoxFeatureStill = 1u;
PHLM_CHOICE kBoxFeatureAlways = 2u;

PHLM_CHOICE kLowPassNone = 0u;
PHLM_CHOICE kLowPassTent = 1u;
PHLM_CHOICE kLowPassBox = 2u;

PHLM_CHOICE kWeightNew = 0u;
PHLM_CHOICE kWeightOld = 1u;

PHLM_CHOICE kUpdateAll = 0u;
PHLM_CHOICE kUpdateHalf = 1u;
PHLM_CHOICE kUpdateQuarter = 2u;

PHLM_CHOICE kForgetEvenly = 0u;
PHLM_CHOICE kForgetByContrast = 1u;

struct PhlmConstants {
  FrameConstants frame;
  // Weights of the nine samples at (x - 1, y - 1), row by row, sum 1; filter_weight_8.x ends them.
  vec4 filter_weights_0_3;
  vec4 filter_weights_4_7;
  vec4 filter_weight_8;
  float lambda;           // forgetting factor
  float level_variance;   // of a reset model's prediction, in units of one sample's
  float spread_variance;  // of a reset model's slopes
  float clip_variance;    // of a prediction that was brought into the box
  float variance_limit;   // no variance grows beyond
  float still_variance;   // 1 / largest number of samples at rest
  float box_gamma;        // half-size of the variance box in standard deviations
  float box_still;        // factor on the box's half-size where nothing moves
  float feature_a;
  float feature_b;
  float feature_floor;
  float depth_tolerance;  // relative; 0: no test
};

#ifdef __cplusplus
static_assert(sizeof(PhlmConstants) == sizeof(FrameConstants) + 96);
}  // namespace phlm
}  // namespace reprise
#endif

#endif
