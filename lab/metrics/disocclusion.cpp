// SPDX-License-Identifier: MIT
#include "lab/metrics/disocclusion.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "equations/reprojection.h"

namespace reprise::lab {
namespace {

// Below this a texel of the four does not count as read: positions of points at rest are whole up
// to rounding.
constexpr float kLeastWeight = 1.0e-3f;

// How much view depth changes from a pixel to the next, along x and y together. The smaller of both
// sides of each: a silhouette is no slope.
float slope(const FloatImage& depth, uint32_t x, uint32_t y) {
  const float here = *depth.at(x, y);
  float x_step = std::numeric_limits<float>::max();
  float y_step = x_step;
  if (x > 0) x_step = std::min(x_step, std::abs(*depth.at(x - 1, y) - here));
  if (x + 1 < depth.width) x_step = std::min(x_step, std::abs(*depth.at(x + 1, y) - here));
  if (y > 0) y_step = std::min(y_step, std::abs(*depth.at(x, y - 1) - here));
  if (y + 1 < depth.height) y_step = std::min(y_step, std::abs(*depth.at(x, y + 1) - here));
  return (depth.width > 1 ? x_step : 0.0f) + (depth.height > 1 ? y_step : 0.0f);
}

}  // namespace

Ages AgeTracker::next(const FrameGeometry& geometry) {
  const FloatImage& depth = geometry.view_depth;
  Ages ages(depth.texelCount(), kAgeEntered);
  const eq::vec2 extent_px(static_cast<float>(depth.width), static_cast<float>(depth.height));
  const bool has_previous = !geometry.reset && view_depth_.sameShape(depth);
  for (uint32_t y = 0; has_previous && y < depth.height; ++y) {
    for (uint32_t x = 0; x < depth.width; ++x) {
      const float* motion_px = geometry.motion_px.at(x, y);
      const eq::vec2 previous_px(static_cast<float>(x) + 0.5f + motion_px[0],
                                 static_cast<float>(y) + 0.5f + motion_px[1]);
      // Written so that a motion that is no number counts as off the screen.
      if (!eq::isOnScreen(previous_px, extent_px)) continue;
      const float nearest_allowed = *geometry.previous_view_depth.at(x, y) - slope(depth, x, y);
      const float fx = previous_px.x - 0.5f - std::floor(previous_px.x - 0.5f);
      const float fy = previous_px.y - 0.5f - std::floor(previous_px.y - 0.5f);
      const int left = static_cast<int>(std::floor(previous_px.x - 0.5f));
      const int top = static_cast<int>(std::floor(previous_px.y - 0.5f));
      float best_weight = 0.0f;
      uint8_t previous_age = 0;
      for (int k = 0; k < 4; ++k) {
        const float weight = (k % 2 != 0 ? fx : 1.0f - fx) * (k / 2 != 0 ? fy : 1.0f - fy);
        if (weight < kLeastWeight || weight <= best_weight) continue;
        const int px = std::clamp(left + k % 2, 0, static_cast<int>(depth.width) - 1);
        const int py = std::clamp(top + k / 2, 0, static_cast<int>(depth.height) - 1);
        const auto tx = static_cast<uint32_t>(px);
        const auto ty = static_cast<uint32_t>(py);
        if (!eq::wasVisible(nearest_allowed, *view_depth_.at(tx, ty), kHiddenTolerance)) continue;
        best_weight = weight;
        previous_age = ages_[size_t{ty} * depth.width + tx];
      }
      uint8_t& age = ages[size_t{y} * depth.width + x];
      if (best_weight == 0.0f) {
        age = 1;
      } else if (previous_age == kAgeEntered || previous_age == kAgeNeverUncovered) {
        age = kAgeNeverUncovered;
      } else {
        age = std::min<uint8_t>(kAgeLongest, static_cast<uint8_t>(previous_age + 1));
      }
    }
  }
  ages_ = ages;
  view_depth_ = depth;
  return ages;
}

AgeError errorAtAges(const FloatImage& reference, const FloatImage& test, const Ages& ages,
                     uint8_t youngest, uint8_t oldest) {
  AgeError error;
  const uint32_t channels = reference.channels;
  for (size_t i = 0; i < ages.size(); ++i) {
    if (ages[i] < youngest || ages[i] > oldest) continue;
    ++error.pixels;
    for (uint32_t c = 0; c < channels; ++c) {
      const double d =
          double{test.texels[i * channels + c]} - double{reference.texels[i * channels + c]};
      error.squared_error += d * d / channels;
    }
  }
  return error;
}

}  // namespace reprise::lab
