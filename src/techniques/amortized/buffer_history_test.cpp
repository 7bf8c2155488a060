// SPDX-License-Identifier: MIT
#include "techniques/amortized/buffer_history.h"

#include <gtest/gtest.h>

#include <set>

namespace reprise::amortized {
namespace {

constexpr VkExtent2D kExtent{8, 8};

// Frames as the technique runs them, with `count` buffers in use.
class Frames {
 public:
  explicit Frames(uint32_t slots) { past.setSlots(slots); }

  void run(uint32_t frames, uint32_t count) {
    for (uint32_t i = 0; i < frames; ++i) {
      begin(count);
      const uint32_t buffer = bufferOfFrame(count, record);
      past.wrote(slotOfBuffer(past.slots(), count, buffer),
                 {record, bufferLayout(count).quadrants[buffer], 1.0f, {}});
      ++record;
    }
  }
  void begin(uint32_t count) {
    past.forgetIfBroken(record > 0, kExtent, record);
    past.use(count, [&](uint32_t n) {
      return slotOfBuffer(past.slots(), count, bufferOfFrame(count, record + kPeriod - 1 - n));
    });
  }
  uint32_t readable() const {
    uint32_t slots = 0;
    for (uint32_t k = 0; k < past.slots(); ++k) slots += past.slot(k).has_value() ? 1 : 0;
    return slots;
  }

  BufferHistory past;
  uint64_t record = 0;
};

TEST(BufferHistory, FillsItsSlotsAndKnowsTheirAges) {
  Frames frames(4);
  frames.run(4, 4);  // 0, 1, 2, 3
  EXPECT_EQ(frames.readable(), 4u);
  for (uint32_t k = 0; k < 4; ++k) {
    EXPECT_EQ(frames.past.ageOf(k, frames.record), 4 - k);
    EXPECT_EQ(frames.past.slot(k)->quadrant, k);
  }
}

TEST(BufferHistory, CopiesAreAPermutationAndTheSpareIsNotRead) {
  Frames frames(4);
  for (int i = 0; i < 40; ++i) {
    frames.run(1, i < 20 ? 4 : 2);
    std::set<uint32_t> copies{frames.past.spareCopy()};
    for (uint32_t k = 0; k < 4; ++k) copies.insert(frames.past.copyOf(k));
    EXPECT_EQ(copies.size(), 5u);
  }
}

TEST(BufferHistory, OnlyTheFirstFramesAskForWhatWasNeverWritten) {
  Frames frames(4);
  frames.begin(4);
  for (uint32_t k = 0; k < 4; ++k) EXPECT_EQ(frames.past.quadrantsOf(k), 1u << k);
  frames.run(8, 4);
  frames.run(8, 2);
  EXPECT_EQ(frames.readable(), 2u);
  frames.begin(4);
  EXPECT_EQ(frames.past.quadrantsOf(0), 1u);
  EXPECT_EQ(frames.past.quadrantsOf(1), 0u);
  EXPECT_EQ(frames.past.quadrantsOf(3), 8u);
}

TEST(BufferHistory, FewerBuffersReadTheOldOnesUntilTheyAreAllWritten) {
  Frames frames(4);
  frames.run(32, 4);
  frames.run(1, 2);
  EXPECT_EQ(frames.readable(), 4u);
  frames.run(2, 2);  // the word never repeats a letter three times
  EXPECT_EQ(frames.readable(), 2u);
  EXPECT_TRUE(frames.past.slot(0).has_value());
  EXPECT_TRUE(frames.past.slot(3).has_value());
  frames.run(1, 1);
  EXPECT_EQ(frames.readable(), 1u);
  EXPECT_EQ(frames.past.slot(0)->quadrant, eq::kQuadrantCentre);
  EXPECT_EQ(frames.past.quadrantsOf(0), 15u);
  frames.run(1, 4);
  EXPECT_GE(frames.readable(), 1u);
  frames.run(7, 4);
  EXPECT_EQ(frames.readable(), 4u);
}

TEST(BufferHistory, SamplesAreCountedInTheOrderThatIsInUse) {
  Frames frames(4);
  frames.run(32, 4);
  EXPECT_EQ(frames.past.writesAmongLast(2)[31], 8.0f - (bufferOfFrame(4, 0) == 2 ? 1.0f : 0.0f));
  frames.begin(1);
  EXPECT_EQ(frames.past.writesAmongLast(0)[31], 31.0f);
  frames.run(1, 1);
  frames.begin(2);
  const float first = frames.past.writesAmongLast(0)[31];
  EXPECT_EQ(first + frames.past.writesAmongLast(3)[31], 31.0f);
  EXPECT_NEAR(first, 15.5f, 0.5f);
}

TEST(BufferHistory, ABreakForgetsEverything) {
  Frames frames(4);
  frames.run(8, 4);
  frames.past.forgetIfBroken(true, kExtent, frames.record);
  EXPECT_EQ(frames.readable(), 4u);
  frames.past.forgetIfBroken(true, kExtent, frames.record + 1);  // a record that was not seen
  EXPECT_EQ(frames.readable(), 0u);
  EXPECT_EQ(frames.past.writesAmongLast(0)[31], 0.0f);
  EXPECT_EQ(frames.past.quadrantsOf(2), 4u);
}

}  // namespace
}  // namespace reprise::amortized
