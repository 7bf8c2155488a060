// SPDX-License-Identifier: MIT
#include "techniques/amortized/blur_moments.h"

#include <cmath>

#include "equations/amortized.h"

namespace reprise::amortized {
namespace {

std::array<uint32_t, kPeriod> orderOf(uint32_t count) {
  std::array<uint32_t, kPeriod> order{};
  for (uint32_t n = 0; n < kPeriod; ++n) order[n] = bufferOfFrame(count, n);
  return order;
}

// Frames since buffer `buffer` was last written, seen from frame `frame` of the repeating order.
uint32_t ageOf(const std::array<uint32_t, kPeriod>& order, uint32_t buffer, uint32_t frame) {
  for (uint32_t age = 1; age <= kPeriod; ++age) {
    if (order[(frame + kPeriod - age % kPeriod) % kPeriod] == buffer) return age;
  }
  return 0;
}

// Solves the system in place by elimination with pivoting; at most 4 unknowns.
void solve(double (&matrix)[kMaxBuffers][kMaxBuffers], double (&right)[kMaxBuffers], uint32_t n) {
  for (uint32_t column = 0; column < n; ++column) {
    uint32_t pivot = column;
    for (uint32_t row = column + 1; row < n; ++row) {
      if (std::abs(matrix[row][column]) > std::abs(matrix[pivot][column])) pivot = row;
    }
    for (uint32_t k = 0; k < n; ++k) std::swap(matrix[column][k], matrix[pivot][k]);
    std::swap(right[column], right[pivot]);
    for (uint32_t row = 0; row < n; ++row) {
      if (row == column) continue;
      const double factor = matrix[row][column] / matrix[column][column];
      for (uint32_t k = column; k < n; ++k) matrix[row][k] -= factor * matrix[column][k];
      right[row] -= factor * right[column];
    }
  }
  for (uint32_t row = 0; row < n; ++row) right[row] /= matrix[row][row];
}

}  // namespace

PanningGathers::PanningGathers(const BufferLayout& layout, double vx, double vy)
    : PanningGathers(layout, orderOf(layout.count), vx, vy) {}

PanningGathers::PanningGathers(const BufferLayout& layout,
                               const std::array<uint32_t, kPeriod>& order, double vx, double vy)
    : count_(layout.count) {
  for (uint32_t n = 0; n < kPeriod; ++n) {
    Gather& gather = gathers_[n];
    gather.written = order[n];
    const eq::vec2 target = eq::quadrantOffset(layout.quadrants[order[n]]);
    double sum = 0.0;
    for (uint32_t k = 0; k < count_; ++k) {
      const uint32_t age = ageOf(order, k, n);
      const eq::vec2 place = eq::quadrantOffset(layout.quadrants[k]);
      // (14), from a pixel at the origin.
      const double px = target.x - place.x + age * vx;
      const double py = target.y - place.y + age * vy;
      const double fx = px - std::floor(px);
      const double fy = py - std::floor(py);
      const eq::vec4 w =
          eq::tentWeights(static_cast<float>(fx), static_cast<float>(fy), layout.tent_radius_px);
      const double dx[2] = {-fx, 1.0 - fx};
      const double dy[2] = {-fy, 1.0 - fy};
      Contribution& from = gather.from[k];
      from = {};
      for (int texel = 0; texel < 4; ++texel) {
        const double x = dx[texel & 1];
        const double y = dy[texel >> 1];
        from.weight += w[texel];
        from.shift_x += w[texel] * x;
        from.shift_y += w[texel] * y;
        from.square += w[texel] * 0.5 * (x * x + y * y);
      }
      sum += from.weight;
    }
    // Float rounding of the tent leaves crumbs where the weight is exactly none.
    gather.empty = sum < 1.0e-5;
    for (Contribution& from : gather.from) {
      const double scale = gather.empty ? 0.0 : 1.0 / sum;
      from = {from.weight * scale, from.shift_x * scale, from.shift_y * scale, from.square * scale};
    }
  }
}

PanningGathers::Moments PanningGathers::moments(double alpha, double sample_variance) const {
  // One period as an affine map: moments(end) = map * moments(start) + offset.
  double map[kMaxBuffers][kMaxBuffers] = {};
  double offset_x[kMaxBuffers] = {};
  double offset_y[kMaxBuffers] = {};
  for (uint32_t k = 0; k < count_; ++k) map[k][k] = 1.0;
  for (const Gather& gather : gathers_) {
    double row[kMaxBuffers] = {};
    double x = 0.0;
    double y = 0.0;
    const double keep = gather.empty ? 0.0 : 1.0 - alpha;
    for (uint32_t k = 0; k < count_; ++k) {
      const Contribution& from = gather.from[k];
      for (uint32_t c = 0; c < count_; ++c) row[c] += keep * from.weight * map[k][c];
      x += keep * (from.weight * offset_x[k] + from.shift_x);
      y += keep * (from.weight * offset_y[k] + from.shift_y);
    }
    for (uint32_t c = 0; c < count_; ++c) map[gather.written][c] = row[c];
    offset_x[gather.written] = x;
    offset_y[gather.written] = y;
  }
  const auto fixedPoint = [&](const double(&offset)[kMaxBuffers], double(&result)[kMaxBuffers]) {
    double matrix[kMaxBuffers][kMaxBuffers] = {};
    for (uint32_t r = 0; r < count_; ++r) {
      for (uint32_t c = 0; c < count_; ++c) matrix[r][c] = (r == c ? 1.0 : 0.0) - map[r][c];
      result[r] = offset[r];
    }
    solve(matrix, result, count_);
  };
  double first_x[kMaxBuffers];
  double first_y[kMaxBuffers];
  fixedPoint(offset_x, first_x);
  fixedPoint(offset_y, first_y);

  // The second moments' map is the same; their offset depends on the first moments on the way.
  const auto runPeriod = [&](double(&second)[kMaxBuffers], Moments* mean) {
    double x_now[kMaxBuffers];
    double y_now[kMaxBuffers];
    for (uint32_t k = 0; k < count_; ++k) {
      x_now[k] = first_x[k];
      y_now[k] = first_y[k];
    }
    for (const Gather& gather : gathers_) {
      const double keep = gather.empty ? 0.0 : 1.0 - alpha;
      double x = 0.0;
      double y = 0.0;
      double square = (1.0 - keep) * sample_variance;
      for (uint32_t k = 0; k < count_; ++k) {
        const Contribution& from = gather.from[k];
        x += keep * (from.weight * x_now[k] + from.shift_x);
        y += keep * (from.weight * y_now[k] + from.shift_y);
        square += keep * (from.weight * second[k] + from.shift_x * x_now[k] +
                          from.shift_y * y_now[k] + from.square);
      }
      x_now[gather.written] = x;
      y_now[gather.written] = y;
      second[gather.written] = square;
      if (mean == nullptr) continue;
      const double share = 1.0 / (kPeriod * count_);
      for (uint32_t k = 0; k < count_; ++k) {
        mean->first_x += share * x_now[k];
        mean->first_y += share * y_now[k];
        mean->second += share * second[k];
      }
    }
  };
  double offset_square[kMaxBuffers] = {};
  runPeriod(offset_square, nullptr);
  double second[kMaxBuffers];
  fixedPoint(offset_square, second);
  Moments mean{};
  runPeriod(second, &mean);
  return mean;
}

}  // namespace reprise::amortized
