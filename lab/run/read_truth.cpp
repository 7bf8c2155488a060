// SPDX-License-Identifier: MIT
#include "lab/run/read_truth.h"

#include <fmt/format.h>

#include <utility>

#include "lab/capture/capture_error.h"
#include "lab/run/interrupt.h"

namespace reprise::lab {

SequenceTruth readTruth(FrameSource& source, uint32_t frames, const std::function<void()>& done) {
  SequenceTruth truth;
  truth.frame_rate = source.info().frame_rate;
  AgeTracker ages;
  for (uint32_t index = 0; index < frames; ++index) {
    throwIfInterrupted();
    std::optional<FloatImage> reference = source.reference(index);
    if (!reference.has_value()) {
      throw CaptureError(source.info().name, fmt::format("frame {}", index + 1),
                         "has no reference to compare with (reference_NNNN.exr)");
    }
    truth.frames.push_back(frameTruth(std::move(*reference), source.geometry(index), ages));
    if (done) done();
  }
  return truth;
}

}  // namespace reprise::lab
