// SPDX-License-Identifier: MIT
#ifndef REPRISE_TECHNIQUES_FXAA_SHARED_H
#define REPRISE_TECHNIQUES_FXAA_SHARED_H

#include "core/frame_constants.h"

#ifdef __cplusplus
#define FXAA_CHOICE constexpr uint32_t
namespace reprise {
namespace fxaa {
#else
#define FXAA_CHOICE const uint
#endif

// Values of the `blend` setting.
FXAA_CHOICE kBlendLinear = 0u;
FXAA_CHOICE kBlendDisplay = 1u;

// Preset 39 takes the most steps.
FXAA_CHOICE kMaxSteps = 12u;

struct FxaaConstants {
  FrameConstants frame;
  vec4 steps_0_3_px;  // lengths of the steps along an edge, from its middle outwards
  vec4 steps_4_7_px;
  vec4 steps_8_11_px;
  float step_count;
  float edge_threshold;      // relative
  float edge_threshold_min;  // of display luma
  float subpixel;
};

#ifdef __cplusplus
static_assert(sizeof(FxaaConstants) == sizeof(FrameConstants) + 64);
}  // namespace fxaa
}  // namespace reprise
#endif

#endif
