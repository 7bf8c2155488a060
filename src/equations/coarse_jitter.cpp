// SPDX-License-Identifier: MIT
#include "equations/coarse_jitter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <map>
#include <mutex>
#include <numeric>

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
// For the order in time: how far a frame's weight falls with each frame between, of 1024; of 0.7
// and 0.8 the one with less error in windows of 9 and 19 frames, for lengths of 16, 32 and 64.
constexpr int64_t kFade = 717;
// Starts of the search for it.
constexpr uint32_t kStarts = 8;
// Frames after a cut whose means decide where the cycle begins.
constexpr size_t kFirstFrames = 16;
// Deviation of the shading filter that it is made for (px): the paper's.
constexpr double kShadingSigma_px = 0.7;
// Frequencies of images (cycles a pixel): steps along each axis up to one cycle.
constexpr int kFrequencies = 8;

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

// What two frames' samples add to the squared error of a mean that holds both, over images whose
// power falls with the square of frequency: of shading, as the four pixels of a coarse one weigh
// it, and of visibility. Integers, so that every compiler finds the same order.
class SharedError {
 public:
  explicit SharedError(const std::vector<vec2>& positions) : count_(positions.size()) {
    constexpr double kTurn = 6.283185307179586;
    struct Wave {
      double x, y, power;
    };
    std::vector<Wave> waves;
    double whole = 0.0;
    for (int y = -kFrequencies; y <= kFrequencies; ++y) {
      for (int x = 0; x <= kFrequencies; ++x) {
        // Half of the plane: the other is its mirror.
        if (x == 0 && y <= 0) continue;
        waves.push_back(
            {kTurn * x / kFrequencies, kTurn * y / kFrequencies, 1.0 / (x * x + y * y)});
        whole += waves.back().power;
      }
    }
    std::vector<double> error(count_ * count_, 0.0);
    for (const Wave& wave : waves) {
      for (int px = 0; px < 4; ++px)
        add(error, shadingTerm(positions, px, wave.x, wave.y), wave.power);
      add(error, visibilityTerm(positions, wave.x, wave.y), wave.power);
    }
    for (const double e : error) error_.push_back(std::llround(kUnit * e / whole));
  }
  int64_t operator()(uint32_t a, uint32_t b) const { return error_[a * count_ + b]; }

 private:
  using Terms = std::vector<std::complex<double>>;
  static constexpr double kUnit = 4096.0;

  static double toward(double position, double pixel) {
    return std::remainder(position - pixel, 2.0);
  }

  // Weighted deviations from the cycle's mean, of a mean weight of 1, a quarter for each pixel.
  static Terms shadingTerm(const std::vector<vec2>& positions, int px, double wave_x,
                           double wave_y) {
    std::vector<double> weights;
    Terms terms;
    double held = 0.0;
    std::complex<double> mean;
    for (const vec2& p : positions) {
      const double x = toward(static_cast<double>(p.x), 0.5 + px % 2);
      const double y = toward(static_cast<double>(p.y), 0.5 + px / 2);
      weights.push_back(std::exp(-0.5 * (x * x + y * y) / (kShadingSigma_px * kShadingSigma_px)));
      terms.push_back(std::polar(1.0, wave_x * x + wave_y * y));
      held += weights.back();
      mean += weights.back() * terms.back();
    }
    const double mean_weight = held / static_cast<double>(positions.size());
    for (size_t i = 0; i < terms.size(); ++i) {
      terms[i] = 0.5 * weights[i] / mean_weight * (terms[i] - mean / held);
    }
    return terms;
  }

  static Terms visibilityTerm(const std::vector<vec2>& positions, double wave_x, double wave_y) {
    Terms terms;
    std::complex<double> mean;
    for (const vec2& p : positions) {
      const CoarseOffset split = splitOffset(p);
      terms.push_back(std::polar(1.0, wave_x * static_cast<double>(split.jitter_px.x) +
                                          wave_y * static_cast<double>(split.jitter_px.y)));
      mean += terms.back();
    }
    for (auto& term : terms) term -= mean / static_cast<double>(positions.size());
    return terms;
  }

  void add(std::vector<double>& error, const Terms& terms, double power) const {
    for (size_t a = 0; a < count_; ++a) {
      for (size_t b = 0; b < count_; ++b) {
        error[a * count_ + b] += power * (terms[a] * std::conj(terms[b])).real();
      }
    }
  }

  size_t count_;
  std::vector<int64_t> error_;
};

// A sequence of points by their numbers, and its error.
struct Order {
  std::vector<uint32_t> points;
  int64_t error = 0;
};

// The order, ours, since the paper gives none: places in the cycle are exchanged while that lowers
// the error of what the last frames saw, both of shading and of visibility. Shading alone makes the
// visibility of frames in succession fall together, worse than at random.
Order orderFrom(std::vector<uint32_t> points, const SharedError& shared) {
  const size_t count = points.size();
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
      sum += fade[i > place ? i - place : place - i] * shared(point, points[i]);
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
  Order order;
  for (size_t a = 0; a < count; ++a) order.error += costOf(a, points[a], a);
  order.points = std::move(points);
  return order;
}

// Where in the cycle to begin: with the least error of plain means of the first frames.
size_t bestBeginning(const std::vector<uint32_t>& points, const SharedError& shared) {
  const size_t frames = std::min<size_t>(points.size(), kFirstFrames);
  size_t best = 0;
  int64_t least = 0;
  for (size_t begin = 0; begin < points.size(); ++begin) {
    int64_t sum = 0;
    int64_t error = 0;
    for (size_t n = 0; n < frames; ++n) {
      const uint32_t point = points[(begin + n) % points.size()];
      for (size_t i = 0; i < n; ++i) sum += 2 * shared(point, points[(begin + i) % points.size()]);
      sum += shared(point, point);
      error += sum / static_cast<int64_t>((n + 1) * (n + 1));
    }
    if (begin == 0 || error < least) {
      least = error;
      best = begin;
    }
  }
  return best;
}

std::vector<vec2> orderedInTime(const std::vector<vec2>& positions) {
  const SharedError shared(positions);
  Order best;
  for (uint32_t start = 0; start < kStarts; ++start) {
    std::vector<uint32_t> points(positions.size());
    std::iota(points.begin(), points.end(), 0u);
    for (uint32_t i = static_cast<uint32_t>(points.size()) - 1; start > 0 && i > 0; --i) {
      std::swap(points[i], points[hashPcg(i + kSeed * start) % (i + 1)]);
    }
    Order order = orderFrom(std::move(points), shared);
    if (best.points.empty() || order.error < best.error) best = std::move(order);
  }
  const auto begin = static_cast<std::ptrdiff_t>(bestBeginning(best.points, shared));
  std::rotate(best.points.begin(), best.points.begin() + begin, best.points.end());
  std::vector<vec2> ordered;
  for (const uint32_t point : best.points) ordered.push_back(positions[point]);
  return ordered;
}

}  // namespace

const std::vector<vec2>& coarseBlueNoise(uint32_t length) {
  static std::mutex mutex;
  static std::map<uint32_t, std::vector<vec2>> made;
  const std::lock_guard lock(mutex);
  std::vector<vec2>& sequence = made[length];
  if (sequence.empty()) {
    const uint32_t count = std::clamp(length, 1u, kMaxCoarseJitter);
    std::vector<vec2> positions;
    for (const uint32_t cell : spreadPoints(count, kCells, kSeed * count, Masks(count))) {
      positions.emplace_back((static_cast<float>(cell % kGrid) + 0.5f) / kPixel,
                             (static_cast<float>(cell / kGrid) + 0.5f) / kPixel);
    }
    sequence = orderedInTime(positions);
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
