// SPDX-License-Identifier: MIT
#include "lab/metrics/sequence_truth.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace reprise::lab {
namespace {

float medianLength(const FloatImage& motion) {
  std::vector<float> lengths(motion.texelCount());
  for (size_t i = 0; i < lengths.size(); ++i) {
    lengths[i] = std::hypot(motion.texels[2 * i], motion.texels[2 * i + 1]);
  }
  if (lengths.empty()) return 0.0f;
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

}  // namespace

FrameTruth frameTruth(FloatImage reference, FrameGeometry geometry, AgeTracker& ages) {
  FrameTruth truth;
  truth.reference = std::move(reference);
  truth.ages = ages.next(geometry);
  truth.median_motion_px = medianLength(geometry.motion_px);
  truth.motion_px = std::move(geometry.motion_px);
  truth.reset = geometry.reset;
  return truth;
}

}  // namespace reprise::lab
