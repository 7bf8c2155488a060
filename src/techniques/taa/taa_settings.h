// SPDX-License-Identifier: MIT
#pragma once

#include "core/settings.h"

namespace reprise::taa {

enum Setting : uint32_t {
  kJitter,
  kJitterLength,
  kJitterCentred,
  kMipBias,
  kInputFilter,
  kInputWidth,
  kDilation,
  kHistoryFilter,
  kHistorySharpness,
  kClip,
  kClipToward,
  kClipSpace,
  kGamma,
  kClipForget,
  kWeighting,
  kAlpha,
  kAntiFlicker,
  kAntiFlickerStrength,
  kSpeedAlpha,
  kSpeedPx,
  kDepthTest,
  kDepthTolerance,
  kMotionTolerance,
  kIdTest,
  kReactive,
  kRejectedBlur,
  kSpatialFrames,
  kOffscreen,
  kStillFrames,
  kGammaStill,
  kAverage,
  kSharpen,
  kDither,
  kSettingCount
};

extern const std::array<RepriseSettingInfo, kSettingCount> kSettings;
extern const ReprisePresetInfo kPresets[];
extern const uint32_t kPresetCount;

// The frame's jitter by the jitter settings, in px (jitter = -sample offset).
void planJitter(const Settings& settings, uint64_t frame_index, RepriseSamplePlan& plan);

}  // namespace reprise::taa
