// SPDX-License-Identifier: MIT
//
// Shared by the host and the shader of `checkerboard`.
#ifndef REPRISE_TECHNIQUES_CHECKERBOARD_SHARED_H
#define REPRISE_TECHNIQUES_CHECKERBOARD_SHARED_H

#include "core/frame_constants.h"

#ifdef __cplusplus
#define CHECKERBOARD_CHOICE constexpr uint32_t
namespace reprise {
namespace checkerboard {
#else
#define CHECKERBOARD_CHOICE const uint
#endif

// Values of the choice settings, in the order of their names in checkerboard.cpp.
CHECKERBOARD_CHOICE kSpatialMean = 0u;
CHECKERBOARD_CHOICE kSpatialDifferential = 1u;

struct CheckerboardConstants {
  FrameConstants frame;
  float half_shaded;       // RepriseFrame::checkerboard
  float sigma_px;          // of the sample filter
  float held_limit;        // largest summed weight of history that moves
  float held_limit_still;  // and that does not
  float gamma;             // half-size of the bound, in standard deviations
  float gamma_still;
  float depth_tolerance;
  float history_sharpness;
};

#ifdef __cplusplus
static_assert(sizeof(CheckerboardConstants) == sizeof(FrameConstants) + 32);
}  // namespace checkerboard
}  // namespace reprise
#endif

#endif
