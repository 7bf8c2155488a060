// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "core/settings.h"
#include "core/technique.h"

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

// For techniques that sample frames in another way and resolve them in this.
std::unique_ptr<Technique> createTaa();

}  // namespace reprise::taa
