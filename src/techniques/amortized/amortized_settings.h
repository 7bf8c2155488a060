// SPDX-License-Identifier: MIT
#pragma once

#include "core/settings.h"

namespace reprise::amortized {

enum Setting : uint32_t {
  kBufferCount,
  kSamples,
  kMotion,
  kOrder,
  kRequests,
  kBlur,
  kResidual,
  kFixedAlpha,
  kMaxSamples,
  kDepthTolerance,
  kSettingCount
};

enum SampleChoice : uint32_t { kSamplesShading, kSamplesFrame };
enum MotionChoice : uint32_t { kMotionChained, kMotionExact };
enum OrderChoice : uint32_t { kOrderIrregular, kOrderRoundRobin };
enum BufferChoice : uint32_t { kBuffersOne, kBuffersTwo, kBuffersFour };

extern const RepriseTechniqueInfo kInfo;

inline uint32_t bufferCount(const Settings& settings) {
  return 1u << settings.choice(kBufferCount);
}

}  // namespace reprise::amortized
