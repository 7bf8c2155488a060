// SPDX-License-Identifier: MIT
//
// What frame `frame_index` samples: which buffer, and where in the pixel.
#pragma once

#include "reprise/reprise.h"
// reprise.h first: shared headers are GLSL too and include no Vulkan header.
#include "core/technique.h"
#include "techniques/amortized/amortized_settings.h"
#include "techniques/amortized/buffer_layout.h"

namespace reprise::amortized {

uint32_t bufferOf(const Settings& settings, uint64_t frame_index);

void planSampling(const PlanRequest& request, RepriseSamplePlan& plan);

// The plan's buffer; for frames that were sampled otherwise, the one whose quadrant the frame's
// own jitter lies in.
uint32_t bufferWrittenBy(const FrameState& state);

}  // namespace reprise::amortized
