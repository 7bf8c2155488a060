// SPDX-License-Identifier: MIT
//
// Shared by the host and the shaders of `taa`: choices, specialization constants, the uniform
// block.
#ifndef REPRISE_TECHNIQUES_TAA_SHARED_H
#define REPRISE_TECHNIQUES_TAA_SHARED_H

#include "core/frame_constants.h"

#ifdef __cplusplus
#define TAA_CHOICE constexpr uint32_t
namespace reprise {
namespace taa {
#else
#define TAA_CHOICE const uint
#endif

// Values of the choice settings, in the order of their names in taa_settings.cpp.
TAA_CHOICE kInputNone = 0u;
TAA_CHOICE kInputBox = 1u;
TAA_CHOICE kInputTent = 2u;
TAA_CHOICE kInputMitchell = 3u;
TAA_CHOICE kInputBlackmanHarris = 4u;
TAA_CHOICE kInputGaussian = 5u;

TAA_CHOICE kDilateNone = 0u;
TAA_CHOICE kDilateClosest = 1u;
TAA_CHOICE kDilateCross = 2u;
TAA_CHOICE kDilateLongest = 3u;

TAA_CHOICE kHistoryBilinear = 0u;
TAA_CHOICE kHistoryCatmullRom5 = 1u;
TAA_CHOICE kHistoryCatmullRom9 = 2u;
TAA_CHOICE kHistoryLanczos = 3u;

TAA_CHOICE kClipNone = 0u;
TAA_CHOICE kClipMinMax = 1u;
TAA_CHOICE kClipRounded = 2u;
TAA_CHOICE kClipVariance = 3u;
TAA_CHOICE kClipKdop = 4u;
TAA_CHOICE kClipCross = 5u;

TAA_CHOICE kTowardClamp = 0u;
TAA_CHOICE kTowardCentre = 1u;
TAA_CHOICE kTowardSample = 2u;

TAA_CHOICE kWeightingNone = 0u;
TAA_CHOICE kWeightingLuminance = 1u;
TAA_CHOICE kWeightingLog = 2u;

TAA_CHOICE kAntiFlickerNone = 0u;
TAA_CHOICE kAntiFlickerBounds = 1u;
TAA_CHOICE kAntiFlickerContrast = 2u;

TAA_CHOICE kDepthTestNone = 0u;
TAA_CHOICE kDepthTestPixel = 1u;
TAA_CHOICE kDepthTestTaps = 2u;

struct TaaConstants {
  FrameConstants frame;
  // Weights of the nine samples at (x - 1, y - 1), row by row, sum 1; filter_weight_8 ends them.
  vec4 filter_weights_0_3;
  vec4 filter_weights_4_7;
  float filter_weight_8;
  float alpha;                // lowest weight of the current sample in motion
  float gamma;                // half-size of the variance box in standard deviations
  float gamma_still;          // the same where nothing moves
  float depth_tolerance;      // relative
  float motion_tolerance_px;  // 0: no motion test
  float speed_alpha;          // weight of the current sample at speed_px and above
  float speed_px;
  float clip_forget;        // share of the sample count that a fully clipped history loses
  float still_frames;       // largest sample count at rest; 0: no still mode
  float spatial_frames;     // spatial antialiasing until this many samples are in
  float history_sharpness;  // c of the cubic history filter
  float anti_flicker;       // strength
  float sharpen;            // [0, 1]
  float average_frames;     // frames of the average without feedback
  float padding;
};

#ifdef __cplusplus
static_assert(sizeof(TaaConstants) == sizeof(FrameConstants) + 96);
}  // namespace taa
}  // namespace reprise
#endif

#endif
