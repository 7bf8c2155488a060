// SPDX-License-Identifier: MIT
#pragma once

#include "equations/jitter_sequence.h"
#include "reprise/reprise.h"

namespace reprise {

// Jitter of frame `frame_index` from the first `length` points of a sequence, their mean taken off,
// so that the converged image is not shifted. A length of 1 means no jitter.
inline void planCentredJitter(uint32_t sequence, uint64_t frame_index, uint32_t length,
                              RepriseSamplePlan& plan) {
  plan.period = length;
  if (length == 1) return;
  const eq::vec2 sample_px =
      eq::sequenceOffset(sequence, frame_index, length) - eq::sequenceMean(sequence, length);
  plan.jitter_px[0] = -sample_px.x;
  plan.jitter_px[1] = -sample_px.y;
}

}  // namespace reprise
