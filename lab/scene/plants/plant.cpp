// SPDX-License-Identifier: MIT
#include "lab/scene/plants/plant.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace reprise::lab {
namespace {

constexpr float kTau = 6.28318531f;

// In a wind of 1: how far a point leans by its height, swings by its way from the trunk.
constexpr float kLean = 0.0035f;      // m a m^2 of height
constexpr float kSwing = 0.018f;      // m a m^1.5 of way along limb and twig
constexpr float kFlutter = 0.55f;     // rad, of a leaf
constexpr float kLowestLimb = 0.18f;  // of the trunk's height
constexpr float kGrassTurn = 0.22f;

// How a point of a plant is pushed, before it turns about anything.
struct Push {
  float lean_m = 0.0f;
  float swing_m = 0.0f;
  float phase = 0.0f;
};

GpuSway stiffBut(const Push& push) {
  return {glm::vec4(0.0f), glm::vec4(0.0f), glm::vec4(push.lean_m, push.swing_m, push.phase, 0.0f)};
}

// A place along a branch.
struct Node {
  glm::vec3 position{0.0f};
  float radius_m = 0.0f;
  Push push;
};

glm::vec3 anyAcross(glm::vec3 along) {
  const glm::vec3 helper =
      std::abs(along.y) < 0.9f ? glm::vec3(0.0f, 1.0f, 0.0f) : glm::vec3(1.0f, 0.0f, 0.0f);
  return glm::normalize(glm::cross(along, helper));
}

// A tube through nodes; uv: turns around times the bark's repeats, metres along.
void appendTube(SwayingMesh& wood, std::span<const Node> nodes, uint32_t sides) {
  const auto base = static_cast<uint32_t>(wood.mesh.vertices.size());
  glm::vec3 side = anyAcross(glm::normalize(nodes[1].position - nodes[0].position));
  float along_m = 0.0f;
  for (size_t i = 0; i < nodes.size(); ++i) {
    const size_t next = std::min(i + 1, nodes.size() - 1);
    const size_t previous = i == 0 ? 0 : i - 1;
    const glm::vec3 along = glm::normalize(nodes[next].position - nodes[previous].position);
    side = glm::normalize(side - along * glm::dot(side, along));
    const glm::vec3 other = glm::cross(along, side);
    if (i > 0) along_m += glm::distance(nodes[i].position, nodes[i - 1].position);
    for (uint32_t k = 0; k <= sides; ++k) {
      const float turn = static_cast<float>(k) / static_cast<float>(sides);
      const glm::vec3 normal = std::cos(kTau * turn) * side + std::sin(kTau * turn) * other;
      wood.mesh.vertices.push_back({glm::vec4(nodes[i].position + normal * nodes[i].radius_m, turn),
                                    glm::vec4(normal, along_m * 2.0f)});
      wood.sways.push_back(stiffBut(nodes[i].push));
    }
  }
  const uint32_t row = sides + 1;
  for (uint32_t i = 0; i + 1 < nodes.size(); ++i) {
    for (uint32_t k = 0; k < sides; ++k) {
      const uint32_t a = base + i * row + k;
      for (const uint32_t index : {a, a + 1, a + row + 1, a, a + row + 1, a + row}) {
        wood.mesh.indices.push_back(index);
      }
    }
  }
}

// Four corners that share one sway; uv from `uv_low` to `uv_high`, v along the stem.
void appendCard(SwayingMesh& to, glm::vec3 foot, glm::vec3 along, glm::vec3 across,
                glm::vec3 normal, glm::vec2 uv_low, glm::vec2 uv_high, const GpuSway& sway) {
  const auto base = static_cast<uint32_t>(to.mesh.vertices.size());
  for (const float v : {0.0f, 1.0f}) {
    for (const float u : {0.0f, 1.0f}) {
      const glm::vec2 uv = glm::mix(uv_low, uv_high, glm::vec2(u, v));
      to.mesh.vertices.push_back(
          {glm::vec4(foot + along * v + across * (u - 0.5f), uv.x), glm::vec4(normal, uv.y)});
      to.sways.push_back(sway);
    }
  }
  for (const uint32_t corner : {0u, 1u, 3u, 0u, 3u, 2u}) to.mesh.indices.push_back(base + corner);
}

class Grower {
 public:
  Grower(glm::vec3 foot, const TreeShape& shape, Dice& dice)
      : foot_(foot), shape_(shape), dice_(dice) {}

  Tree grow() {
    const std::vector<Node> trunk = growTrunk();
    appendTube(tree_.wood, trunk, 9);
    for (uint32_t i = 0; i < shape_.limbs; ++i) {
      const float share = kLowestLimb + (0.97f - kLowestLimb) *
                                            (static_cast<float>(i) + dice_.unit()) /
                                            static_cast<float>(shape_.limbs);
      growLimb(at(trunk, share), share, static_cast<float>(i) * 2.39996f);  // golden angle
    }
    return std::move(tree_);
  }

 private:
  static Node at(std::span<const Node> nodes, float share) {
    const float place = share * static_cast<float>(nodes.size() - 1);
    const auto i = std::min(static_cast<size_t>(place), nodes.size() - 2);
    const float f = place - static_cast<float>(i);
    const Node& a = nodes[i];
    const Node& b = nodes[i + 1];
    return {glm::mix(a.position, b.position, f),
            glm::mix(a.radius_m, b.radius_m, f),
            {glm::mix(a.push.lean_m, b.push.lean_m, f), glm::mix(a.push.swing_m, b.push.swing_m, f),
             b.push.phase}};
  }

  Push pushAt(glm::vec3 position, float way_m, float phase) const {
    const float height = std::max(position.y - foot_.y, 0.0f);
    return {kLean * height * height, kSwing * std::pow(way_m, 1.5f), phase};
  }

  std::vector<Node> growTrunk() {
    std::vector<Node> nodes;
    constexpr int kSpans = 9;
    const glm::vec3 bend(dice_.between(-0.5f, 0.5f), 0.0f, dice_.between(-0.5f, 0.5f));
    for (int i = 0; i <= kSpans; ++i) {
      const float s = static_cast<float>(i) / kSpans;
      const glm::vec3 p = foot_ + glm::vec3(0.0f, s * shape_.height_m - 0.05f, 0.0f) +
                          bend * s * s +
                          0.06f * glm::vec3(dice_.between(-1, 1), 0.0f, dice_.between(-1, 1)) * s;
      const float flare = 1.0f + 0.8f * std::exp(-s * 14.0f);
      nodes.push_back({p, shape_.trunk_radius_m * (1.0f - 0.88f * s) * flare, pushAt(p, 0.0f, 0)});
    }
    return nodes;
  }

  // A branch that starts at `start`, bends towards the light, and ends thin. `way_m`: from the
  // trunk to its start. It starts inside its parent and moves with it there.
  std::vector<Node> growBranch(const Node& start, glm::vec3 direction, float length_m,
                               float radius_m, float way_m, float phase, int spans) {
    std::vector<Node> nodes{{start.position, radius_m, start.push}};
    nodes[0].push.phase = phase;
    const float step = length_m / static_cast<float>(spans);
    for (int i = 1; i <= spans; ++i) {
      direction =
          glm::normalize(direction + 0.22f * dice_.direction() + glm::vec3(0.0f, 0.09f, 0.0f));
      const glm::vec3 p = nodes.back().position + direction * step;
      way_m += step;
      const float left = 1.0f - 0.8f * static_cast<float>(i) / static_cast<float>(spans);
      nodes.push_back({p, radius_m * left, pushAt(p, way_m, phase)});
    }
    return nodes;
  }

  void growLimb(const Node& start, float share, float heading) {
    const float phase = dice_.between(0.0f, kTau);
    const float length =
        shape_.height_m * (0.48f - 0.30f * (share - kLowestLimb)) * dice_.between(0.8f, 1.15f);
    const float rise = glm::mix(0.25f, 0.9f, share) + dice_.between(-0.1f, 0.1f);
    const glm::vec3 direction =
        glm::normalize(glm::vec3(std::cos(heading), rise, std::sin(heading)));
    const float radius = std::min(0.45f * start.radius_m, 0.012f * length + 0.008f);
    const std::vector<Node> limb = growBranch(start, direction, length, radius, 0.0f, phase, 6);
    appendTube(tree_.wood, limb, 4);
    for (uint32_t i = 0; i < shape_.twigs_a_limb; ++i) {
      const float along = 0.25f + 0.75f * (static_cast<float>(i) + dice_.unit()) /
                                      static_cast<float>(shape_.twigs_a_limb);
      const Node from = at(limb, std::min(along, 1.0f));
      const glm::vec3 away = glm::normalize(direction * 0.5f + dice_.direction() * 0.9f +
                                            glm::vec3(0.0f, 0.15f, 0.0f));
      growTwig(from, away, along * length, phase, length * dice_.between(0.22f, 0.38f));
    }
    growTwig(limb.back(), direction, length, phase, length * 0.3f);
  }

  void growTwig(const Node& start, glm::vec3 direction, float way_m, float phase, float length_m) {
    const float radius = std::min(0.7f * start.radius_m, 0.005f);
    const std::vector<Node> twig = growBranch(start, direction, length_m, radius, way_m, phase, 2);
    appendTube(tree_.wood, twig, 3);
    for (uint32_t i = 0; i < shape_.leaves_a_twig; ++i) {
      const float share = 0.12f + 0.88f * (static_cast<float>(i) + dice_.unit()) /
                                      static_cast<float>(shape_.leaves_a_twig);
      growLeaf(at(twig, std::min(share, 1.0f)), direction);
    }
  }

  void growLeaf(const Node& stem, glm::vec3 twig) {
    const float length = shape_.leaf_m * dice_.between(0.7f, 1.25f);
    const glm::vec3 along =
        glm::normalize(0.4f * twig + dice_.direction() * 0.9f + glm::vec3(0.0f, -0.25f, 0.0f));
    glm::vec3 across = glm::cross(along, dice_.direction());
    if (glm::length(across) < 0.1f) across = anyAcross(along);
    across = glm::normalize(across);
    glm::vec3 normal = glm::cross(across, along);
    if (normal.y < 0.0f) normal = -normal;
    const auto picture = static_cast<uint32_t>(dice_.unit() * 4.0f);
    const glm::vec2 low(0.5f * static_cast<float>(picture & 1u),
                        0.5f * static_cast<float>(picture >> 1u));
    GpuSway sway = stiffBut(stem.push);
    sway.pivot_angle = glm::vec4(stem.position, kFlutter);
    sway.axis_phase = glm::vec4(glm::normalize(across + 0.6f * along), dice_.between(0.0f, kTau));
    appendCard(tree_.leaves, stem.position, along * length, across * (0.62f * length), normal, low,
               low + 0.5f, sway);
  }

  glm::vec3 foot_;
  TreeShape shape_;
  Dice& dice_;
  Tree tree_;
};

GpuSway grassSway(glm::vec3 foot, glm::vec3 wind_direction, Dice& dice) {
  const glm::vec3 axis =
      glm::normalize(glm::cross(glm::vec3(0.0f, 1.0f, 0.0f), wind_direction) +
                     0.3f * glm::vec3(dice.between(-1, 1), 0.0f, dice.between(-1, 1)));
  GpuSway sway{};
  sway.pivot_angle = glm::vec4(foot, kGrassTurn);
  // Gusts travel: neighbours along the wind follow each other.
  const float phase = dice.between(0.0f, 1.2f) - 1.3f * glm::dot(foot, wind_direction);
  sway.axis_phase = glm::vec4(axis, phase);
  return sway;
}

}  // namespace

uint32_t addInstance(Geometry& geometry, const SwayingMesh& plant, uint32_t material) {
  geometry.sways.resize(geometry.vertices.size(), GpuSway{});
  geometry.sways.insert(geometry.sways.end(), plant.sways.begin(), plant.sways.end());
  return addInstance(geometry, plant.mesh, material);
}

glm::vec3 Dice::direction() {
  const float y = between(-1.0f, 1.0f);
  const float turn = between(0.0f, kTau);
  const float r = std::sqrt(std::max(0.0f, 1.0f - y * y));
  return {r * std::cos(turn), y, r * std::sin(turn)};
}

Tree growTree(glm::vec3 foot_world, const TreeShape& shape, Dice& dice) {
  return Grower(foot_world, shape, dice).grow();
}

void appendTuft(SwayingMesh& grass, glm::vec3 foot_world, float height_m, float width_m,
                glm::vec3 wind_direction, Dice& dice) {
  const GpuSway sway = grassSway(foot_world, wind_direction, dice);
  const float heading = dice.between(0.0f, kTau);
  for (const float turn : {0.0f, 0.25f * kTau}) {
    const glm::vec3 across(std::cos(heading + turn), 0.0f, std::sin(heading + turn));
    // Lit as the ground is: cards seen edge on must not blink.
    const glm::vec3 normal = glm::normalize(
        glm::vec3(0.0f, 1.0f, 0.0f) + 0.35f * glm::cross(across, glm::vec3(0.0f, 1.0f, 0.0f)));
    appendCard(grass, foot_world, glm::vec3(0.0f, height_m, 0.0f), across * width_m, normal,
               {0.0f, 0.0f}, {1.0f, 1.0f}, sway);
  }
}

void appendBlade(SwayingMesh& grass, glm::vec3 foot_world, float height_m, float width_m,
                 glm::vec3 wind_direction, Dice& dice) {
  const GpuSway sway = grassSway(foot_world, wind_direction, dice);
  const float heading = dice.between(0.0f, kTau);
  const glm::vec3 across(std::cos(heading), 0.0f, std::sin(heading));
  const glm::vec3 lean = glm::cross(across, glm::vec3(0.0f, 1.0f, 0.0f)) * dice.between(0.1f, 0.5f);
  const auto base = static_cast<uint32_t>(grass.mesh.vertices.size());
  constexpr uint32_t kRows = 3;
  for (uint32_t row = 0; row <= kRows; ++row) {
    const float s = static_cast<float>(row) / kRows;
    const glm::vec3 p = foot_world + height_m * (glm::vec3(0.0f, s, 0.0f) + lean * s * s);
    const float half = 0.5f * width_m * (1.0f - 0.85f * s);
    const glm::vec3 normal = glm::normalize(glm::vec3(0.0f, 1.0f, 0.0f) + lean);
    for (const float u : {-1.0f, 1.0f}) {
      grass.mesh.vertices.push_back(
          {glm::vec4(p + across * (half * u), 0.5f + 0.25f * u), glm::vec4(normal, s)});
      grass.sways.push_back(sway);
    }
    if (row == kRows) break;
    const uint32_t a = base + 2 * row;
    for (const uint32_t index : {a, a + 1, a + 3, a, a + 3, a + 2}) {
      grass.mesh.indices.push_back(index);
    }
  }
}

}  // namespace reprise::lab
