// SPDX-License-Identifier: MIT
#include <algorithm>
#include <vector>

#include "equations/blue_noise.h"
#include "equations/jitter.h"
#include "techniques/taa/taa_settings.h"

namespace reprise::taa {

// The choice setting's order is that of the sequence constants in equations/jitter.h, blue noise last.
void planJitter(const Settings& settings, uint64_t frame_index, RepriseSamplePlan& plan) {
  const uint32_t sequence = settings.choice(kJitter);
  const uint32_t length = eq::jitterPeriod(sequence, settings.choice(kJitterLength));
  const auto index = static_cast<uint32_t>(frame_index % length);
  eq::vec2 sample_px = eq::jitterOffset(sequence, index, length);
  if (settings.on(kJitterCentred)) {
    const eq::vec2 mean_px = eq::jitterMean(sequence, length);
    sample_px = eq::vec2(sample_px.x - mean_px.x, sample_px.y - mean_px.y);
  }
  plan.jitter_px[0] = -sample_px.x;
  plan.jitter_px[1] = -sample_px.y;
  plan.period = length;
  plan.mip_bias = settings.real(kMipBias);
}

}  // namespace reprise::taa
