// SPDX-License-Identifier: MIT
#include "equations/jitter_sequence.h"
#include "techniques/taa/taa_settings.h"

namespace reprise::taa {

// The names of the `jitter` setting stand in the order of the sequence constants.
void planJitter(const Settings& settings, uint64_t frame_index, RepriseSamplePlan& plan) {
  const uint32_t sequence = settings.choice(kJitter);
  const uint32_t length = settings.choice(kJitterLength);
  eq::vec2 sample_px = eq::sequenceOffset(sequence, frame_index, length);
  if (settings.on(kJitterCentred)) sample_px = sample_px - eq::sequenceMean(sequence, length);
  plan.jitter_px[0] = -sample_px.x;
  plan.jitter_px[1] = -sample_px.y;
  plan.period = eq::sequencePeriod(sequence, length);
  plan.mip_bias = settings.real(kMipBias);
}

}  // namespace reprise::taa
