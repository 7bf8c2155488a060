// SPDX-License-Identifier: MIT
#include "equations/coarse_jitter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <mutex>

#include "equations/void_and_cluster.h"

namespace reprise::eq {
namespace {

constexpr uint32_t kGrid = 64;          // cells a side of two pixels
constexpr uint32_t kPixel = kGrid / 2;  // cells a pixel
constexpr uint32_t kCells = kGrid * kGrid;
// As in blue_noise.cpp: a point's energy reaches over the mean distance of the points, and is an
// integer, so that every compiler finds the same clusters and voids.
constexpr float kWidthPerDistance = 0.474f;
constexpr float kOne = 1024.0f;
// Any number: sets of different length shall not begin alike.
constexpr uint32_t kSeed = 7919;
// For the order in time: how far a frame's weight falls with each frame between, of 1024, and for
// how many points a point's energy reaches. Of fades from 512 to 922 and 3, 4 or 8 points those
// with the most even shading around any place within 2, 4 and 8 frames.
constexpr int64_t kFade = 640;
constexpr size_t kSeenAtOnce = 3;

// Energy of a point at an offset on a torus of `period` cells with `count` points.
class Energy {
 public:
  Energy(uint32_t period, size_t count) : period_(period) {
    const float sigma =
        kWidthPerDistance * static_cast<float>(period) / std::sqrt(static_cast<float>(count));
    for (uint32_t d = 0; d < period; ++d) {
      const auto distance = static_cast<float>(std::min(d, period - d));
      falloff_[d] = std::llround(kOne * std::exp(-0.5f * distance * distance / (sigma * sigma)));
    }
  }
  int64_t operator()(uint32_t a, uint32_t b) const {
    return falloff_[(a % kGrid + kGrid - b % kGrid) % period_] *
           falloff_[(a / kGrid + kGrid - b / kGrid) % period_];
  }

 private:
  uint32_t period_;
  std::array<int64_t, kGrid> falloff_{};
};

// Both masks in one: shading samples on the torus of two pixels, and the four visibility samples of
// each. One of these is aligned with the shading sample, as the paper advises; they lie a pixel
// apart, so that on the torus of one pixel they are one point.
class Masks {
 public:
  explicit Masks(size_t count) : shading_(kGrid, count), visibility_(kPixel, count) {}
  int64_t operator()(uint32_t a, uint32_t b) const { return shading_(a, b) + visibility_(a, b); }

 private:
  Energy shading_;
  Energy visibility_;
};

// The order, ours: places in the cycle are exchanged while that lowers the energy between points,
// weighted by how close in time they are. What the last frames saw is then spread at any time.
void orderInTime(std::vector<uint32_t>& points) {
  const size_t count = points.size();
  // Of shading alone: in a few frames visibility is near enough everywhere.
  const Energy energy(kGrid, std::min(count, kSeenAtOnce));
  std::vector<int64_t> fade(count, 0);
  int64_t weight = 1024;
  for (size_t age = 1; age <= count / 2; ++age) {
    weight = weight * kFade / 1024;
    fade[age] = weight;
    fade[count - age] = weight;
  }
  const auto costOf = [&](size_t place, uint32_t point, size_t other) {
    int64_t sum = 0;
    for (size_t i = 0; i < count; ++i) {
      if (i == place || i == other) continue;
      sum += fade[i > place ? i - place : place - i] * energy(point, points[i]);
    }
    return sum;
  };
  for (bool better = true; better;) {
    better = false;
    for (size_t a = 0; a < count; ++a) {
      for (size_t b = a + 1; b < count; ++b) {
        const int64_t now = costOf(a, points[a], b) + costOf(b, points[b], a);
        const int64_t then = costOf(a, points[b], b) + costOf(b, points[a], a);
        if (then >= now) continue;
        std::swap(points[a], points[b]);
        better = true;
      }
    }
  }
}

}  // namespace

const std::vector<vec2>& coarseBlueNoise(uint32_t length) {
  static std::mutex mutex;
  static std::map<uint32_t, std::vector<vec2>> made;
  const std::lock_guard lock(mutex);
  std::vector<vec2>& sequence = made[length];
  if (sequence.empty()) {
    const uint32_t count = std::clamp(length, 1u, kMaxCoarseJitter);
    std::vector<uint32_t> points = spreadPoints(count, kCells, kSeed * count, Masks(count));
    orderInTime(points);
    for (const uint32_t cell : points) {
      sequence.emplace_back((static_cast<float>(cell % kGrid) + 0.5f) / kPixel,
                            (static_cast<float>(cell / kGrid) + 0.5f) / kPixel);
    }
  }
  return sequence;
}

CoarseOffset splitOffset(vec2 shading_px) {
  const auto along = [](float position, int32_t& origin_px, float& jitter_px) {
    // Coarse centres are whole numbers: odd ones with the origin at 0.
    const float center = std::floor(position + 0.5f);
    jitter_px = center - position;
    origin_px = (static_cast<int32_t>(center) + 1) % 2;
  };
  CoarseOffset offset{};
  along(shading_px.x, offset.origin_px[0], offset.jitter_px.x);
  along(shading_px.y, offset.origin_px[1], offset.jitter_px.y);
  return offset;
}

}  // namespace reprise::eq
