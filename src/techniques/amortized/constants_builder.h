// SPDX-License-Identifier: MIT
//
// Uniforms of a frame from its state and what lies in the buffers.
#pragma once

#include <optional>

#include "reprise/reprise.h"
// reprise.h first: shared headers are GLSL too and include no Vulkan header.
#include "core/technique.h"
#include "techniques/amortized/amortized_shared.h"
#include "techniques/amortized/blur_table.h"
#include "techniques/amortized/buffer_history.h"

namespace reprise::amortized {

// Whether the frame has a way to what lies in `slot`: chained always, else an image of the host's.
bool hasMotionTo(const BufferHistory& past, const FrameState& state, bool exact, uint32_t slot);

class ConstantsBuilder {
 public:
  AmortizedConstants of(const BufferHistory& past, const FrameState& state,
                        VkExtent2D history_extent, bool exact_motion, uint32_t target_slot);

 private:
  // The slice of the blur table changes with two settings only.
  uint32_t slice_buffers_ = 0;
  double slice_threshold_px2_ = 0.0;
  BlurSlice slice_{};
};

// `capacity`: entries that the list can hold.
RequestConstants requestConstants(const FrameState& state, VkExtent2D history_extent,
                                  uint32_t capacity);

}  // namespace reprise::amortized
