// SPDX-License-Identifier: MIT
#include "core/effort.h"

#include <algorithm>

namespace reprise {

void EffortControl::step(uint32_t rung) {
  trying_ = rung < rung_;
  rung_ = rung;
  frames_ = 0;
  roomy_ = 0;
}

double EffortControl::median() const {
  std::array<double, kWindow> sorted = times_s_;
  std::nth_element(sorted.begin(), sorted.begin() + kWindow / 2, sorted.end());
  return sorted[kWindow / 2];
}

uint32_t EffortControl::next(double measured_s, double target_s) {
  if (target_s != target_s_) {
    target_s_ = target_s;
    patience_ = kFirstPatience;
    frames_ = 0;
    roomy_ = 0;
  }
  if (frames_ >= kSettling) times_s_[(frames_ - kSettling) % kWindow] = measured_s;
  ++frames_;
  if (frames_ < kSettling + kWindow) return rung_;
  const double time_s = median();
  if (time_s > target_s && rung_ + 1 < rungs_) {
    if (trying_) patience_ = std::min(2 * patience_, kLastPatience);
    step(rung_ + 1);
    return rung_;
  }
  if (frames_ > 2 * kFirstPatience) trying_ = false;
  roomy_ = time_s < kRoom * target_s ? roomy_ + 1 : 0;
  if (roomy_ >= patience_ && rung_ > 0) step(rung_ - 1);
  return rung_;
}

}  // namespace reprise
