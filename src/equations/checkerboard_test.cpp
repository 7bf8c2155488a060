// SPDX-License-Identifier: MIT
#include "equations/checkerboard.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace reprise::eq {
namespace {

TEST(Checkerboard, HalvesShareThePixels) {
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 3; ++x) {
      EXPECT_EQ(isShaded(x, y, 1), (x + y) % 2 == 0);
      EXPECT_NE(isShaded(x, y, 1), isShaded(x, y, 2));
      EXPECT_TRUE(isShaded(x, y, 0));
    }
  }
}

TEST(Checkerboard, NoSpeedLocksToAHalf) {
  // A point that moves by `speed` px a frame along a row is at pixel speed * frame.
  for (int speed = 0; speed < 4; ++speed) {
    int shaded = 0;
    int longest = 0;
    int waits = 0;
    for (uint frame = 0; frame < 16; ++frame) {
      const bool seen =
          isShaded(speed * static_cast<int>(frame), 0, static_cast<int>(pairedHalf(frame)));
      shaded += seen ? 1 : 0;
      waits = seen ? 0 : waits + 1;
      longest = std::max(longest, waits);
    }
    EXPECT_EQ(shaded, 8) << speed;
    EXPECT_LE(longest, 2) << speed;
  }
}

TEST(Checkerboard, GapsAreFilledAlongEdges) {
  EXPECT_EQ(differentialWeight(0.5f), 2.0f);
  EXPECT_NEAR(differentialWeight(0.0f), 1000.0f, 0.1f);
}

}  // namespace
}  // namespace reprise::eq
