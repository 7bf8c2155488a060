// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace reprise::lab {

// Below this many frames since a reset there is no asymptote to speak of.
constexpr uint32_t kLeastConvergenceFrames = 16;
constexpr double kConvergedWithin_db = 1.0;

struct Convergence {
  double asymptote_db = 0.0;  // mean PSNR of the last quarter of the frames
  uint32_t frames =
      0;  // since the reset, the reset's own counted, until asymptote - 1 dB was reached
};

// PSNR of frame after frame, the first one right after a reset. nullopt for too few.
std::optional<Convergence> convergence(std::span<const double> psnr_db);

}  // namespace reprise::lab
