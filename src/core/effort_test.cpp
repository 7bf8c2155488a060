// SPDX-License-Identifier: MIT
#include "core/effort.h"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace reprise {
namespace {

// Rungs of a host whose frame takes `cost_s` of the rung; returns the rung of every frame.
std::vector<uint32_t> run(uint32_t rungs, double target_s, uint32_t frames,
                          const std::function<double(uint32_t frame, uint32_t rung)>& cost_s) {
  EffortControl control(rungs);
  std::vector<uint32_t> chosen;
  uint32_t rung = 0;
  for (uint32_t frame = 0; frame < frames; ++frame) {
    rung = control.next(cost_s(frame, rung), target_s);
    chosen.push_back(rung);
  }
  return chosen;
}

uint32_t changes(const std::vector<uint32_t>& rungs) {
  uint32_t count = 0;
  for (size_t i = 1; i < rungs.size(); ++i) count += rungs[i] != rungs[i - 1] ? 1 : 0;
  return count;
}

constexpr double kCost_s[] = {0.020, 0.017, 0.014, 0.011, 0.008};

TEST(EffortControl, SettlesAtTheDearestRungThatHolds) {
  const auto cost = [](uint32_t, uint32_t rung) { return kCost_s[rung]; };
  EXPECT_EQ(run(5, 0.030, 200, cost).back(), 0u);
  EXPECT_EQ(run(5, 0.0145, 200, cost).back(), 2u);
  EXPECT_EQ(run(5, 0.0145, 200, cost)[60], 2u);
  EXPECT_EQ(run(5, 0.001, 200, cost).back(), 4u);  // the cheapest there is
}

TEST(EffortControl, OneHiccupChangesNothing) {
  const auto cost = [](uint32_t frame, uint32_t) { return frame % 10 == 7 ? 0.1 : 0.012; };
  EXPECT_EQ(changes(run(5, 0.016, 500, cost)), 0u);
}

TEST(EffortControl, ComesBackWhenTheLoadGoes) {
  const auto cost = [](uint32_t frame, uint32_t rung) {
    return kCost_s[rung] * (frame < 200 ? 1.0 : 0.5);
  };
  const std::vector<uint32_t> rungs = run(5, 0.0145, 800, cost);
  EXPECT_EQ(rungs[199], 2u);
  EXPECT_EQ(rungs.back(), 0u);
}

// A dearer rung that looks affordable and is not: tried ever more rarely.
TEST(EffortControl, AStepThatFailsIsTriedEverMoreRarely) {
  const auto cost = [](uint32_t, uint32_t rung) { return rung == 0 ? 0.020 : 0.010; };
  const std::vector<uint32_t> rungs = run(2, 0.015, 4000, cost);
  EXPECT_LE(changes(rungs), 16u);
  EXPECT_GE(changes(rungs), 3u);  // it does try
  uint32_t over = 0;
  for (const uint32_t rung : rungs) over += rung == 0 ? 1 : 0;
  EXPECT_LT(over, 4000u / 20);
}

TEST(EffortControl, OneRungIsKept) {
  EXPECT_EQ(changes(run(1, 0.01, 100, [](uint32_t, uint32_t) { return 1.0; })), 0u);
}

}  // namespace
}  // namespace reprise
