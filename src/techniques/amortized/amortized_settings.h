// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <span>

#include "core/effort.h"
#include "core/settings.h"

namespace reprise::amortized {

enum Setting : uint32_t {
  kBufferCount,
  kEffort,
  kSamples,
  kMotion,
  kOrder,
  kRequests,
  kBudget,
  kQuality,
  kBlur,
  kResidual,
  kFixedAlpha,
  kMaxSamples,
  kShutter,
  kCoverage,
  kDepthTolerance,
  kSettingCount
};

enum SampleChoice : uint32_t { kSamplesShading, kSamplesFrame };
enum MotionChoice : uint32_t { kMotionChained, kMotionExact };
enum OrderChoice : uint32_t { kOrderIrregular, kOrderRoundRobin };
enum BufferChoice : uint32_t { kBuffersOne, kBuffersTwo, kBuffersFour };

extern const RepriseTechniqueInfo kInfo;

// How many buffers there is room for, and how many are in use.
inline uint32_t slotCount(const Settings& settings) {
  return 1u << settings.choice(kBufferCount);
}
inline uint32_t bufferCount(const Settings& settings) {
  return 1u << std::min(settings.choice(kBufferCount), settings.choice(kEffort));
}

// tau_b of the buffers in use.
double blurTolerance(const Settings& settings);

// What repriseHoldFrameTime chooses among, the dearest first.
extern const std::span<const EffortRung> kRungs;

}  // namespace reprise::amortized
