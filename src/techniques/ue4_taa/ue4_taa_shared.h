// SPDX-License-Identifier: MIT
#ifndef REPRISE_TECHNIQUES_UE4_TAA_SHARED_H
#define REPRISE_TECHNIQUES_UE4_TAA_SHARED_H

#include "core/frame_constants.h"

#ifdef __cplusplus
#define UE4_TAA_CHOICE constexpr uint32_t
namespace reprise {
namespace ue4_taa {
#else
#define UE4_TAA_CHOICE const uint
#endif

// Values of the `anti_flicker` setting.
UE4_TAA_CHOICE kAntiFlickerNone = 0u;
UE4_TAA_CHOICE kAntiFlickerBounds = 1u;
UE4_TAA_CHOICE kAntiFlickerContrast = 2u;

struct Ue4TaaConstants {
  FrameConstants frame;
  // Weights of the nine samples at (x - 1, y - 1), row by row, sum 1; filter_weight_8 ends them.
  vec4 filter_weights_0_3;
  vec4 filter_weights_4_7;
  vec4 filter_weight_8;  // x
};

#ifdef __cplusplus
static_assert(sizeof(Ue4TaaConstants) == sizeof(FrameConstants) + 48);
}  // namespace ue4_taa
}  // namespace reprise
#endif

#endif
