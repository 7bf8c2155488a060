// SPDX-License-Identifier: MIT
#include "lab/scene/gltf/fitted_path.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <optional>
#include <vector>

namespace reprise::lab {
namespace {

constexpr int kCells = 64;  // along the longest side
constexpr float kEye_m = 1.6f;
// A place to be in is at least this high; lower things are looked at from outside.
constexpr float kRoom_m = 2.2f;
// Of rays from the middle of a line: as many must end at something, or the line leads through
// nothing much.
constexpr float kEnclosed = 0.5f;
// Of the longest side.
constexpr float kShortestLine = 0.12f;
// Half of what a camera that looks along the line sees (radians).
constexpr float kAhead = 0.7f;
constexpr float kPi = 3.14159265f;

// Which cells of a grid hold a piece of surface.
class Grid {
 public:
  explicit Grid(const Geometry& geometry) {
    low_ = glm::vec3(1.0e30f);
    high_ = glm::vec3(-1.0e30f);
    for (const GpuVertex& v : geometry.vertices) {
      low_ = glm::min(low_, glm::vec3(v.position_u));
      high_ = glm::max(high_, glm::vec3(v.position_u));
    }
    const glm::vec3 side = high_ - low_;
    cell_m_ = std::max(std::max({side.x, side.y, side.z}) / kCells, 1.0e-6f);
    size_ = glm::ivec3(glm::floor(side / cell_m_)) + 1;
    full_.assign(static_cast<size_t>(size_.x * size_.y * size_.z), 0);
    level_m2_.assign(static_cast<size_t>(size_.y), 0.0f);
    for (size_t i = 0; i + 2 < geometry.indices.size(); i += 3) {
      glm::vec3 corner[3];
      for (size_t k = 0; k < 3; ++k) {
        corner[k] = glm::vec3(geometry.vertices[geometry.indices[i + k]].position_u);
      }
      addTriangle(corner[0], corner[1], corner[2]);
    }
  }

  glm::vec3 low() const { return low_; }
  glm::vec3 high() const { return high_; }
  glm::ivec3 size() const { return size_; }
  float cell_m() const { return cell_m_; }
  bool within(glm::ivec3 c) const {
    return glm::all(glm::greaterThanEqual(c, glm::ivec3(0))) && glm::all(glm::lessThan(c, size_));
  }
  bool full(glm::ivec3 c) const { return within(c) && full_[at(c)] != 0; }
  glm::ivec3 cellOf(glm::vec3 p) const { return glm::ivec3(glm::floor((p - low_) / cell_m_)); }
  glm::vec3 center(glm::ivec3 c) const { return low_ + (glm::vec3(c) + 0.5f) * cell_m_; }

  // Height of most of what one can stand on, in the lower half.
  float floor_m() const {
    const auto half = level_m2_.begin() + (size_.y + 1) / 2;
    const auto level = std::max_element(level_m2_.begin(), half) - level_m2_.begin();
    return low_.y + (static_cast<float>(level) + 0.5f) * cell_m_;
  }

  // How far a ray goes until it meets a full cell; nothing where it leaves the grid before.
  std::optional<float> reach_m(glm::vec3 from, glm::vec3 direction) const {
    for (float along_m = 0.0f;; along_m += 0.5f * cell_m_) {
      const glm::ivec3 c = cellOf(from + direction * along_m);
      if (!within(c)) return std::nullopt;
      if (full_[at(c)] != 0) return along_m;
    }
  }

 private:
  size_t at(glm::ivec3 c) const {
    return static_cast<size_t>((c.z * size_.y + c.y) * size_.x + c.x);
  }

  void addTriangle(glm::vec3 a, glm::vec3 b, glm::vec3 c) {
    const glm::vec3 normal = glm::cross(b - a, c - a);
    const float twice_m2 = glm::length(normal);
    if (twice_m2 > 0.0f && std::abs(normal.y) > 0.8f * twice_m2) {
      const int level = cellOf((a + b + c) / 3.0f).y;
      level_m2_[static_cast<size_t>(std::clamp(level, 0, size_.y - 1))] += 0.5f * twice_m2;
    }
    // Points closer together than half a cell.
    const float longest = std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
    const int steps =
        std::clamp(static_cast<int>(std::ceil(2.0f * longest / cell_m_)), 1, 2 * kCells);
    for (int i = 0; i <= steps; ++i) {
      for (int k = 0; k + i <= steps; ++k) {
        const float u = static_cast<float>(i) / static_cast<float>(steps);
        const float v = static_cast<float>(k) / static_cast<float>(steps);
        const glm::ivec3 cell =
            glm::clamp(cellOf(a + u * (b - a) + v * (c - a)), glm::ivec3(0), size_ - 1);
        full_[at(cell)] = 1;
      }
    }
  }

  glm::vec3 low_;
  glm::vec3 high_;
  float cell_m_ = 1.0f;
  glm::ivec3 size_{1};
  std::vector<uint8_t> full_;
  std::vector<float> level_m2_;  // level surface, a layer each
};

// What rays from a point meet, level and a little upwards, within `half_angle` of `towards`.
struct Surroundings {
  float met = 0.0f;     // share that ends at something
  float room_m = 0.0f;  // harmonic mean of their ways: what is near counts
};

Surroundings look(const Grid& grid, glm::vec3 from, glm::vec2 towards, float half_angle) {
  constexpr int kTurns = 12;
  constexpr float kRises[] = {0.0f, 0.12f, 0.25f};
  int met = 0;
  float sum = 0.0f;
  for (int i = 0; i < kTurns; ++i) {
    const float turn = half_angle * (2.0f * (static_cast<float>(i) + 0.5f) / kTurns - 1.0f);
    const glm::vec2 level(towards.x * std::cos(turn) - towards.y * std::sin(turn),
                          towards.x * std::sin(turn) + towards.y * std::cos(turn));
    for (const float rise : kRises) {
      const std::optional<float> reach =
          grid.reach_m(from, glm::normalize(glm::vec3(level.x, rise, level.y)));
      if (!reach) continue;
      ++met;
      sum += 1.0f / std::max(*reach, 0.5f * grid.cell_m());
    }
  }
  const float all = kTurns * static_cast<float>(std::size(kRises));
  return {static_cast<float>(met) / all, met > 0 ? static_cast<float>(met) / sum : 0.0f};
}

struct Line {
  glm::vec3 from{0.0f};
  glm::vec3 to{0.0f};
  float score = 0.0f;
};

Line longestLine(const Grid& grid, float eye_m) {
  const glm::ivec3 size = grid.size();
  const int layer =
      std::clamp(static_cast<int>((eye_m - grid.low().y) / grid.cell_m()), 0, size.y - 1);
  // Free with its neighbours, and over ground.
  std::vector<uint8_t> open(static_cast<size_t>(size.x * size.z), 0);
  for (int z = 0; z < size.z; ++z) {
    for (int x = 0; x < size.x; ++x) {
      bool free = true;
      for (int dz = -1; dz <= 1; ++dz) {
        for (int dx = -1; dx <= 1; ++dx) free = free && !grid.full({x + dx, layer, z + dz});
      }
      bool ground = false;
      for (int y = layer - 1; y >= 0; --y) ground = ground || grid.full({x, y, z});
      open[static_cast<size_t>(z * size.x + x)] = free && ground ? 1 : 0;
    }
  }
  constexpr int kStep = 2;
  constexpr int kTurns = 16;  // of a half circle: lines have two ends
  const float longest = static_cast<float>(kCells);
  Line best;
  for (int z = 0; z < size.z; z += kStep) {
    for (int x = 0; x < size.x; x += kStep) {
      for (int i = 0; i < 2 * kTurns; ++i) {
        const float turn = kPi * static_cast<float>(i) / kTurns;
        const glm::vec2 step(std::cos(turn), std::sin(turn));
        const glm::vec2 start(static_cast<float>(x) + 0.5f, static_cast<float>(z) + 0.5f);
        float length = 0.0f;
        const auto isOpen = [&](glm::vec2 p) {
          const glm::ivec2 c(glm::floor(p));
          return c.x >= 0 && c.y >= 0 && c.x < size.x && c.y < size.z &&
                 open[static_cast<size_t>(c.y * size.x + c.x)] != 0;
        };
        if (!isOpen(start)) break;
        while (isOpen(start + step * (length + 1.0f))) length += 1.0f;
        if (length < kShortestLine * longest) continue;
        const glm::vec2 end = start + step * length;
        const auto world = [&](glm::vec2 p) {
          return glm::vec3(grid.low().x + p.x * grid.cell_m(), eye_m,
                           grid.low().z + p.y * grid.cell_m());
        };
        const Surroundings around = look(grid, 0.5f * (world(start) + world(end)), step, kPi);
        if (around.met < kEnclosed) continue;
        // In a wide place (gaps behind walls are long too), long, and towards something.
        const Surroundings ahead = look(grid, world(start), step, kAhead);
        const float score = std::sqrt(length) * around.room_m * around.met * ahead.met * ahead.met;
        if (score > best.score) best = {world(start), world(end), score};
      }
    }
  }
  return best;
}

}  // namespace

FittedPath::FittedPath(const Geometry& geometry) {
  const Grid grid(geometry);
  center_world_ = 0.5f * (grid.low() + grid.high());
  radius_m_ = std::max(0.5f * glm::distance(grid.low(), grid.high()), 1.0e-3f);
  near_plane_ = std::min(0.002f * radius_m_, 0.1f);
  if (grid.high().y - grid.low().y < kRoom_m) return;
  const Line line = longestLine(grid, grid.floor_m() + kEye_m);
  inside_ = line.score > 0.0f;
  from_world_ = line.from;
  to_world_ = line.to;
}

CameraPose FittedPath::at(double time_s) const {
  const auto t = static_cast<float>(time_s);
  CameraPose pose;
  pose.near_plane = near_plane_;
  if (!inside_) {
    constexpr float kFov = 0.7f;
    const float turn = 0.6f + 0.35f * t + 0.05f * std::sin(2.1f * t);
    const float away_m = 0.95f * radius_m_ / std::sin(0.5f * kFov);
    pose.vertical_fov = kFov;
    pose.target_world = center_world_;
    pose.eye_world =
        center_world_ + away_m * glm::vec3(0.92f * std::sin(turn), 0.39f, 0.92f * std::cos(turn));
    return pose;
  }
  // Walks between a tenth and nine tenths of the line at 1.5 m/s at most, longer lines than 120 m
  // faster; half that speed at the start.
  const float length_m = glm::distance(from_world_, to_world_);
  const float speed = std::max(1.5f, length_m / 80.0f);
  const float swing_m = 0.4f * length_m;
  const float phase = speed / swing_m * t - kPi / 3.0f;
  const glm::vec3 along = (to_world_ - from_world_) / length_m;
  const glm::vec3 side(-along.z, 0.0f, along.x);
  pose.eye_world = 0.5f * (from_world_ + to_world_) + along * (swing_m * std::sin(phase));
  pose.eye_world.y += 0.02f * std::sin(6.28f * t);
  const float yaw = 0.20f * std::sin(1.3f * t + 0.4f);
  const float pitch = 0.06f + 0.05f * std::sin(0.9f * t);
  pose.vertical_fov = 0.95f;
  pose.target_world =
      pose.eye_world + along * std::cos(yaw) + side * std::sin(yaw) + glm::vec3(0.0f, pitch, 0.0f);
  return pose;
}

}  // namespace reprise::lab
