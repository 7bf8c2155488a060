// SPDX-License-Identifier: MIT
//
// Holds a frame time by stepping along a technique's rungs: sets of settings from the dearest to
// the cheapest, all switchable between two frames. A pure function of the times it was given.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "reprise/reprise.h"

namespace reprise {

using EffortRung = std::span<const RepriseSettingValue>;

class EffortControl {
 public:
  explicit EffortControl(uint32_t rungs) : rungs_(rungs) {}

  // After a frame that took `measured_s`: the rung of the next one, [0, rungs), 0 the dearest.
  uint32_t next(double measured_s, double target_s);

  // Times are judged by the median of so many frames at one rung: one hiccup is no reason.
  static constexpr uint32_t kWindow = 8;
  // Frames after a step whose times may still be those of the rung before.
  static constexpr uint32_t kSettling = 4;
  // Below this share of the target there is room to try the dearer rung, ...
  static constexpr double kRoom = 0.85;
  // ... after so many frames. A try that fails doubles the wait for the next, up to the last.
  static constexpr uint32_t kFirstPatience = 32;
  static constexpr uint32_t kLastPatience = 1024;

 private:
  void step(uint32_t rung);
  double median() const;

  uint32_t rungs_;
  uint32_t rung_ = 0;
  double target_s_ = 0.0;
  std::array<double, kWindow> times_s_{};
  uint32_t frames_ = 0;  // at this rung
  uint32_t roomy_ = 0;   // of them, in a row, with room
  uint32_t patience_ = kFirstPatience;
  bool trying_ = false;  // this rung was reached by a step up and has not proved itself
};

}  // namespace reprise
