// SPDX-License-Identifier: MIT
#pragma once

#include "core/settings.h"

namespace reprise::phlm {

enum Setting : uint32_t {
  kStorageForm,
  kModelOrigin,
  kJitter,
  kJitterLength,
  kInput,
  kInputWidth,
  kUpdateShare,
  kPasses,
  kSpace,
  kLambda,
  kForgetting,
  kInitialVariance,
  kSlopeVariance,
  kVarianceLimit,
  kClipModel,
  kClipVariance,
  kBoxShape,
  kBoxSpace,
  kBoxGamma,
  kBoxStill,
  kBoxHolds,
  kModelFilter,
  kDilate,
  kDepthTolerance,
  kFeatureA,
  kFeatureB,
  kFeatureFloor,
  kFeatureWeighs,
  kFeatureLowPass,
  kStillFrames,
  kBilinear,
  kSettingCount
};

// Values of `jitter`.
constexpr uint32_t kJitterNone = 0;
constexpr uint32_t kJitterAlways = 1;
constexpr uint32_t kJitterStill = 2;

extern const std::array<RepriseSettingInfo, kSettingCount> kSettings;
extern const ReprisePresetInfo kPresets[];
extern const uint32_t kPresetCount;

}  // namespace reprise::phlm
