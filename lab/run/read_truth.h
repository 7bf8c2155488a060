// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "lab/frame_inputs.h"
#include "lab/metrics/sequence_truth.h"

namespace reprise::lab {

// References and geometry of frames [0, frames) of `source`; `done` is called after each frame,
// null is allowed. Throws CaptureError naming the frame that has no reference; submits work of its
// own.
SequenceTruth readTruth(FrameSource& source, uint32_t frames, const std::function<void()>& done);

}  // namespace reprise::lab
