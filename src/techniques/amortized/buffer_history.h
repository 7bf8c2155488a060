// SPDX-License-Identifier: MIT
//
// Which slot holds which subpixel buffer, written when, and what a frame may still read of it. It
// knows no Vulkan object. The number of buffers may change from frame to frame, within the slots
// that there are: what was written before is read until the new buffers have been written once.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "reprise/reprise.h"
// reprise.h first: shared headers are GLSL too and include no Vulkan header.
#include "techniques/amortized/buffer_layout.h"

namespace reprise::amortized {

class BufferHistory {
 public:
  // What is known of the frame that wrote a slot.
  struct Written {
    uint64_t record;
    uint32_t quadrant;  // where its samples lie, eq. quadrantOffset
    float pre_exposure;
    eq::vec2 jitter_px;
    std::optional<RepriseCamera> camera;
  };

  // `slots` in {1, 2, 4}: the most buffers that can be in use. All is forgotten.
  void setSlots(uint32_t slots);
  uint32_t slots() const { return slots_; }

  // Before each frame. History ends with a reset, another extent, or a record that this object did
  // not see.
  void forgetIfBroken(bool has_history, VkExtent2D extent, uint64_t record);
  // The frame's number of buffers. `slot_of_past_write(n)`: the slot that the update order, as it
  // now is, would have written n + 1 frames ago.
  template <typename SlotOfPastWrite>
  void use(uint32_t count, const SlotOfPastWrite& slot_of_past_write) {
    if (count == count_) return;
    count_ = count;
    starting_ = starting_ && write_count_ == 0;
    current_.fill(false);
    // The estimates hold as many samples as before; they count as though they had come in the new
    // order.
    for (uint32_t n = 0; n < write_count_; ++n) writes_[n] = slot_of_past_write(n);
  }

  // Empty where nothing is to be read.
  const std::optional<Written>& slot(uint32_t index) const { return written_[index]; }
  uint32_t ageOf(uint32_t slot, uint64_t record) const;
  // The copy of the image that holds the slot, and the one to be written next: a gather reads
  // neighbours of the slot that is written.
  uint32_t copyOf(uint32_t slot) const { return copy_of_[slot < slots_ ? slot : 0]; }
  uint32_t spareCopy() const { return spare_; }

  // Quadrants to be asked for where reprojection to the slot fails, as bits. A slot that the first
  // frames have not reached yet fails everywhere; one that a change of the number left empty does
  // not: the others stand for it.
  uint32_t quadrantsOf(uint32_t slot) const;
  // Of the last n frames, how many wrote `slot`: element n of 32.
  std::array<float, kPeriod> writesAmongLast(uint32_t slot) const;

  // After each frame. The spare copy now holds `slot`.
  void wrote(uint32_t slot, const Written& frame);

 private:
  uint32_t slots_ = kMaxBuffers;
  uint32_t count_ = kMaxBuffers;
  // After a reset, until all buffers are written or their number changes.
  bool starting_ = true;
  std::array<uint32_t, kMaxBuffers> copy_of_ = {0, 1, 2, 3};
  uint32_t spare_ = kMaxBuffers;
  std::array<std::optional<Written>, kMaxBuffers> written_;
  std::array<bool, kMaxBuffers> current_{};  // written since the number of buffers last changed
  std::array<uint32_t, kPeriod> writes_{};   // slots written, the latest first
  uint32_t write_count_ = 0;
  uint64_t next_record_ = ~uint64_t{0};
  VkExtent2D extent_{};
};

}  // namespace reprise::amortized
