// SPDX-License-Identifier: MIT
#include "lab/scene/indoor/creature.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "lab/scene/mesh/lathe.h"
#include "lab/scene/mesh/loft.h"
#include "lab/scene/two_bone.h"

namespace reprise::lab {
namespace {

constexpr float kTau = 6.28318531f;
constexpr uint32_t kLegs = 6;
constexpr uint32_t kTailPieces = 7;
constexpr float kFemur = 0.30f;
constexpr float kTibia = 0.42f;
constexpr float kTailPiece = 0.105f;
constexpr float kBodyHeight = 0.27f;
constexpr double kStep_s = 0.42;  // both tripods once
constexpr double kStandShare = 0.55;
constexpr double kTurn = -0.9;  // radians a second about the circle

// Pieces in order: body, head, two mandibles, tail, then femur and tibia of each leg.
constexpr uint32_t kHead = 1;
constexpr uint32_t kMandibles = 2;
constexpr uint32_t kTail = 4;
constexpr uint32_t kLegPieces = kTail + kTailPieces;

glm::mat4 movedBy(glm::vec3 by) {
  return glm::translate(glm::mat4(1.0f), by);
}
glm::mat4 turnedBy(float angle, glm::vec3 axis) {
  return glm::rotate(glm::mat4(1.0f), angle, axis);
}

float sideOf(uint32_t leg) {
  return leg % 2 == 0 ? 1.0f : -1.0f;
}
float along(uint32_t leg) {
  return 0.17f - 0.17f * static_cast<float>(leg / 2);
}
glm::vec3 hip(uint32_t leg) {
  return {along(leg), -0.01f, 0.135f * sideOf(leg)};
}
// Front legs reach forwards, hind legs back.
glm::vec3 standing(uint32_t leg) {
  return {2.3f * along(leg) + 0.01f, -kBodyHeight,
          (0.47f - 0.05f * std::abs(along(leg))) * sideOf(leg)};
}

Mesh shell() {
  const Section sections[] = {
      {{-0.28f, 0.02f, 0.0f}, 0.075f, 0.085f}, {{-0.18f, 0.04f, 0.0f}, 0.125f, 0.155f},
      {{-0.04f, 0.05f, 0.0f}, 0.140f, 0.180f}, {{0.06f, 0.03f, 0.0f}, 0.090f, 0.140f},
      {{0.13f, 0.03f, 0.0f}, 0.115f, 0.150f},  {{0.24f, 0.02f, 0.0f}, 0.085f, 0.105f}};
  Mesh mesh = loft(sections, {.around = 56, .rows_a_span = 9, .cap_rows = 8, .cap_length = 0.7f});
  // Rivets along both sides of the back.
  for (int i = 0; i < 7; ++i) {
    const float x = -0.22f + 0.045f * static_cast<float>(i);
    for (const float side : {-1.0f, 1.0f}) {
      append(mesh,
             transformed(sphereMesh(0.012f, 12),
                         movedBy({x, 0.155f - 1.4f * (x + 0.05f) * (x + 0.05f), 0.062f * side})));
    }
  }
  append(mesh,
         transformed(torusMesh(0.122f, 0.012f, 56, 12),
                     movedBy({0.075f, 0.03f, 0.0f}) * turnedBy(0.25f * kTau, {0.0f, 0.0f, 1.0f})));
  return mesh;
}

Mesh headMesh() {
  const Section sections[] = {{{0.0f, 0.0f, 0.0f}, 0.060f, 0.075f},
                              {{0.07f, -0.005f, 0.0f}, 0.075f, 0.095f},
                              {{0.15f, -0.03f, 0.0f}, 0.040f, 0.060f}};
  Mesh mesh = loft(sections, {.around = 36, .rows_a_span = 8, .cap_rows = 6});
  for (const float side : {-1.0f, 1.0f}) {
    append(mesh, transformed(sphereMesh(0.028f, 24), movedBy({0.10f, 0.045f, 0.062f * side})));
    const Section feeler[] = {{{0.12f, 0.05f, 0.03f * side}, 0.009f, 0.009f},
                              {{0.22f, 0.15f, 0.08f * side}, 0.006f, 0.006f},
                              {{0.36f, 0.16f, 0.15f * side}, 0.004f, 0.004f}};
    append(mesh, loft(feeler, {.around = 10, .rows_a_span = 8, .cap_rows = 3}));
  }
  return mesh;
}

Mesh mandible(float side) {
  const Section sections[] = {{{0.0f, 0.0f, 0.0f}, 0.022f, 0.022f},
                              {{0.08f, -0.01f, 0.045f * side}, 0.018f, 0.018f},
                              {{0.16f, -0.02f, 0.010f * side}, 0.006f, 0.006f}};
  return loft(sections,
              {.side = {0.0f, 1.0f, 0.0f}, .around = 20, .rows_a_span = 8, .cap_rows = 4});
}

// Hangs along -y, as bones of legs do.
Mesh femur() {
  const Section sections[] = {{{0.0f, 0.0f, 0.0f}, 0.030f, 0.026f},
                              {{0.0f, -0.12f, 0.0f}, 0.044f, 0.032f},
                              {{0.0f, -kFemur, 0.0f}, 0.024f, 0.022f}};
  Mesh mesh = loft(sections, {.around = 24, .rows_a_span = 9, .cap_rows = 5});
  append(mesh, transformed(sphereMesh(0.031f, 20), movedBy({0.0f, -kFemur, 0.0f})));
  return mesh;
}

Mesh tibia() {
  const Section sections[] = {{{0.0f, 0.0f, 0.0f}, 0.022f, 0.020f},
                              {{0.012f, -0.14f, 0.0f}, 0.024f, 0.019f},
                              {{0.006f, -0.30f, 0.0f}, 0.013f, 0.012f},
                              {{0.0f, -kTibia + 0.004f, 0.0f}, 0.004f, 0.004f}};
  Mesh mesh = loft(sections, {.around = 20, .rows_a_span = 8, .cap_rows = 4});
  for (int i = 0; i < 4; ++i) {  // spines
    const float y = -0.08f - 0.06f * static_cast<float>(i);
    const Section spine[] = {{{0.018f, y, 0.0f}, 0.007f, 0.007f},
                             {{0.058f, y - 0.02f, 0.0f}, 0.001f, 0.001f}};
    append(mesh, loft(spine, {.around = 8, .rows_a_span = 3, .cap_rows = 2}));
  }
  return mesh;
}

Mesh tailPiece(uint32_t piece) {
  const float thick = 0.050f - 0.0045f * static_cast<float>(piece);
  if (piece + 1 == kTailPieces) {  // the sting
    const Section sections[] = {{{0.0f, 0.0f, 0.0f}, 0.026f, 0.026f},
                                {{0.0f, -0.05f, 0.0f}, 0.034f, 0.032f},
                                {{-0.035f, -0.12f, 0.0f}, 0.012f, 0.011f},
                                {{-0.085f, -0.16f, 0.0f}, 0.002f, 0.002f}};
    return loft(sections, {.around = 24, .rows_a_span = 7, .cap_rows = 4});
  }
  const Section sections[] = {{{0.0f, 0.0f, 0.0f}, 0.75f * thick, 0.80f * thick},
                              {{0.0f, -0.5f * kTailPiece, 0.0f}, 1.1f * thick, 1.15f * thick},
                              {{0.0f, -kTailPiece, 0.0f}, 0.70f * thick, 0.75f * thick}};
  return loft(sections, {.around = 28, .rows_a_span = 7, .cap_rows = 5});
}

}  // namespace

Creature::Creature(glm::vec3 center_world, float walk_radius, float scale)
    : center_world_(center_world), walk_radius_(walk_radius), scale_(scale) {
  pieces_ = {shell(), headMesh(), mandible(1.0f), mandible(-1.0f)};
  for (uint32_t i = 0; i < kTailPieces; ++i) pieces_.push_back(tailPiece(i));
  for (uint32_t leg = 0; leg < kLegs; ++leg) {
    pieces_.push_back(femur());
    pieces_.push_back(tibia());
  }
}

glm::mat4 Creature::course(double time_s) const {
  const auto angle = static_cast<float>(std::remainder(kTurn * time_s, 2.0 * 3.14159265358979));
  const glm::vec3 at =
      center_world_ + walk_radius_ * glm::vec3(std::cos(angle), 0.0f, std::sin(angle));
  // Forwards (x) along the circle: kTurn is negative, towards falling angles.
  return movedBy(at) * turnedBy(-angle + 0.25f * kTau, {0.0f, 1.0f, 0.0f}) *
         glm::scale(glm::mat4(1.0f), glm::vec3(scale_)) * movedBy({0.0f, kBodyHeight, 0.0f});
}

glm::mat4 Creature::body(double time_s) const {
  const auto t = static_cast<float>(std::fmod(time_s, 1000.0 * kStep_s) / kStep_s);
  return course(time_s) * movedBy({0.0f, 0.012f * std::sin(2.0f * kTau * t), 0.0f}) *
         turnedBy(0.035f * std::sin(kTau * t), {1.0f, 0.0f, 0.0f});
}

glm::vec3 Creature::foot(uint32_t leg, double time_s) const {
  // Two tripods in turn.
  const bool first = (leg == 0 || leg == 3 || leg == 4);
  const double steps = time_s / kStep_s + (first ? 0.0 : 0.5);
  const double step = std::floor(steps);
  const double phase = steps - step;
  const auto planted = [&](double number) {
    // Set down so that the body passes over it in the middle of the stance.
    const double middle_s = (number + 0.5 * kStandShare - (first ? 0.0 : 0.5)) * kStep_s;
    return glm::vec3(course(middle_s) * glm::vec4(standing(leg), 1.0f));
  };
  const glm::vec3 here = planted(step);
  if (phase < kStandShare) return here;
  const auto s = static_cast<float>((phase - kStandShare) / (1.0 - kStandShare));
  const glm::vec3 lift(0.0f, 0.11f * scale_ * std::sin(0.5f * kTau * s), 0.0f);
  return glm::mix(here, planted(step + 1.0), s * s * (3.0f - 2.0f * s)) + lift;
}

glm::mat4 Creature::transform(uint32_t piece, double time_s) const {
  const glm::mat4 frame = body(time_s);
  const auto t = static_cast<float>(std::fmod(time_s, 1000.0 * kStep_s) / kStep_s);
  if (piece == 0) return frame;
  const glm::mat4 head = frame * movedBy({0.27f, 0.03f, 0.0f}) *
                         turnedBy(0.22f * std::sin(0.21f * kTau * t), {0.0f, 1.0f, 0.0f}) *
                         turnedBy(0.10f * std::sin(0.5f * kTau * t), {0.0f, 0.0f, 1.0f});
  if (piece == kHead) return head;
  if (piece < kTail) {
    const float side = piece == kMandibles ? 1.0f : -1.0f;
    const float open = 0.20f + 0.25f * std::sin(0.75f * kTau * t);
    return head * movedBy({0.13f, -0.03f, 0.035f * side}) *
           turnedBy(-side * open, {0.0f, 1.0f, 0.0f});
  }
  if (piece < kLegPieces) {
    // Curls up and over the back; a wave runs along it.
    glm::mat4 tail = frame * movedBy({-0.27f, 0.05f, 0.0f}) * turnedBy(-1.35f, {0.0f, 0.0f, 1.0f});
    for (uint32_t i = 0;; ++i) {
      const float late = 0.12f * static_cast<float>(i);
      tail = tail *
             turnedBy(-0.48f + 0.07f * std::sin(kTau * (0.5f * t - late)), {0.0f, 0.0f, 1.0f}) *
             turnedBy(0.16f * std::sin(kTau * (0.25f * t - late)), {1.0f, 0.0f, 0.0f});
      if (i == piece - kTail) return tail;
      tail = tail * movedBy({0.0f, -kTailPiece, 0.0f});
    }
  }
  // A leg bends in the upright plane through its hip and its foot.
  const uint32_t leg = (piece - kLegPieces) / 2;
  const glm::vec3 root(frame * glm::vec4(hip(leg), 1.0f));
  const glm::vec3 end = foot(leg, time_s);
  const glm::vec3 level(end.x - root.x, 0.0f, end.z - root.z);
  const float out_m = glm::length(level);
  const glm::vec3 out = level / std::max(out_m, 1.0e-4f);
  const glm::vec3 up(0.0f, 1.0f, 0.0f);
  const TwoBone two = reach({0.0f, root.y}, {out_m, end.y}, scale_ * kFemur, scale_ * kTibia, 1.0f);
  const bool upper = (piece - kLegPieces) % 2 == 0;
  const glm::vec2 from = upper ? glm::vec2(0.0f, root.y) : two.joint;
  const glm::vec2 to = upper ? two.joint : two.end;
  glm::mat4 plane(1.0f);
  plane[0] = {out, 0.0f};
  plane[1] = {up, 0.0f};
  plane[2] = {glm::cross(out, up), 0.0f};
  plane[3] = {root.x + out.x * from.x, from.y, root.z + out.z * from.x, 1.0f};
  return plane * turnedBy(hangingAngle(from, to), {0.0f, 0.0f, 1.0f}) *
         glm::scale(glm::mat4(1.0f), glm::vec3(scale_));
}

}  // namespace reprise::lab
