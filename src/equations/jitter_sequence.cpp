// SPDX-License-Identifier: MIT
#include "equations/jitter_sequence.h"

#include <algorithm>

#include "equations/blue_noise.h"

namespace reprise::eq {

uint32_t sequencePeriod(uint32_t sequence, uint32_t length) {
  if (sequence == kSequenceBlueNoise) return std::min(length, kMaxBlueNoise);
  return jitterPeriod(sequence, length);
}

vec2 sequenceOffset(uint32_t sequence, uint64_t index, uint32_t length) {
  const uint32_t period = sequencePeriod(sequence, length);
  const auto phase = static_cast<uint32_t>(index % period);
  if (sequence == kSequenceBlueNoise) return blueNoiseSequence()[phase];
  return closedFormOffset(sequence, phase, period);
}

vec2 sequenceMean(uint32_t sequence, uint32_t length) {
  const uint32_t period = sequencePeriod(sequence, length);
  vec2 sum;
  for (uint32_t i = 0; i < period; ++i) sum = sum + sequenceOffset(sequence, i, length);
  return sum / static_cast<float>(period);
}

}  // namespace reprise::eq
