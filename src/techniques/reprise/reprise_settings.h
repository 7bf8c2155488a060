// SPDX-License-Identifier: MIT
#pragma once

#include "core/settings.h"

namespace reprise::reprise_technique {

enum Setting : uint32_t {
  kJitterLength,
  kSampleWidth,
  kHistory,
  kStillHistory,
  kSharpness,
  kDepthTolerance,
  kBound,
  kBoundFaint,
  kBoundChanged,
  kBoundStill,
  kHistoryUncovered,
  kBoundApart,
  kFlips,
  kFarFrames,
  kForgetClipped,
  kForgetChanged,
  kTone,
  kDoubtLight,
  kDoubtNow,
  kDoubtMean,
  kSettingCount
};

extern const std::array<RepriseSettingInfo, kSettingCount> kSettings;

}  // namespace reprise::reprise_technique
