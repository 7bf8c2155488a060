// SPDX-License-Identifier: MIT
#include "techniques/amortized/buffer_history.h"

#include <algorithm>

namespace reprise::amortized {
namespace {

// Ages are read as floats, and what is this old is as good as forgotten.
constexpr uint64_t kGreatestAge = 1u << 20;

constexpr uint32_t kEveryQuadrant = 0b1111;

constexpr uint32_t quadrantBits(uint32_t quadrant) {
  return quadrant == eq::kQuadrantCentre ? kEveryQuadrant : 1u << quadrant;
}

}  // namespace

void BufferHistory::setSlots(uint32_t slots) {
  *this = BufferHistory();
  slots_ = count_ = slots;
  spare_ = slots;
}

void BufferHistory::forgetIfBroken(bool has_history, VkExtent2D extent, uint64_t record) {
  const bool same_extent = extent.width == extent_.width && extent.height == extent_.height;
  if (has_history && same_extent && next_record_ == record) return;
  for (std::optional<Written>& frame : written_) frame.reset();
  current_.fill(false);
  write_count_ = 0;
  starting_ = true;
  next_record_ = record;
  extent_ = extent;
}

uint32_t BufferHistory::ageOf(uint32_t slot, uint64_t record) const {
  return static_cast<uint32_t>(std::min(record - written_[slot]->record, kGreatestAge));
}

uint32_t BufferHistory::quadrantsOf(uint32_t slot) const {
  if (written_[slot].has_value()) return quadrantBits(written_[slot]->quadrant);
  if (!starting_) return 0;
  const BufferLayout layout = bufferLayout(count_);
  for (uint32_t buffer = 0; buffer < count_; ++buffer) {
    if (slotOfBuffer(slots_, count_, buffer) == slot) return quadrantBits(layout.quadrants[buffer]);
  }
  return 0;
}

std::array<float, kPeriod> BufferHistory::writesAmongLast(uint32_t slot) const {
  std::array<float, kPeriod> among{};
  float writes = 0.0f;
  for (uint32_t n = 0; n < kPeriod; ++n) {
    among[n] = writes;
    if (n < write_count_ && writes_[n] == slot) writes += 1.0f;
  }
  return among;
}

void BufferHistory::wrote(uint32_t slot, const Written& frame) {
  std::swap(copy_of_[slot], spare_);
  written_[slot] = frame;
  current_[slot] = true;
  std::copy_backward(writes_.begin(), writes_.end() - 1, writes_.end());
  writes_[0] = slot;
  write_count_ = std::min(write_count_ + 1, kPeriod);
  next_record_ = frame.record + 1;
  if (static_cast<uint32_t>(std::count(current_.begin(), current_.end(), true)) < count_) return;
  starting_ = false;
  for (uint32_t other = 0; other < slots_; ++other) {
    if (!current_[other]) written_[other].reset();
  }
}

}  // namespace reprise::amortized
