// SPDX-License-Identifier: MIT
//
// The resolution chart panning at a constant velocity, filtered by a technique, and the blur that
// is left in it: what Figures 3 and 6 of Yang et al. 2009 look at.
#pragma once

#include <string>
#include <vector>

#include "lab/paper/blur_fit.h"
#include "lab/paper/paper_lab.h"

namespace reprise::lab::amortized {

class ChartPan {
 public:
  // Content moves by (vx, vy) px a frame.
  ChartPan(Device& device, double vx, double vy);

  // The last of kFrames frames, red channel, linear.
  FloatImage run(const std::string& technique);
  // Against the same chart at the same place.
  const BlurFit& fit() const { return fit_; }

  // Long enough that 0.9^n of the start is below 1 %.
  static constexpr uint32_t kFrames = 48;
  static constexpr uint32_t kSide_px = 192;
  // From the border, where content enters by up to a px a frame.
  static constexpr uint32_t kMargin_px = 52;
  static constexpr uint32_t kFineScale = 8;

 private:
  Device& device_;
  std::unique_ptr<SceneSource> source_;
  BlurFit fit_;
};

}  // namespace reprise::lab::amortized
