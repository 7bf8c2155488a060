// SPDX-License-Identifier: MIT
#include "lab/scene/horse/horse_pose.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "lab/scene/two_bone.h"

namespace reprise::lab {
namespace {

constexpr float kTau = 2.0f * std::numbers::pi_v<float>;

// Footfalls in shares of a stride: the hind pair, then the fore pair, then all four in the air.
constexpr double kFootfall[kHorseLegs] = {0.0, 0.11, 0.36, 0.49};

// How far a foot moves over the ground, against the body, while it stands.
constexpr auto kSweep = static_cast<float>(kHorseSpeed * kStride_s * kStanceShare);

glm::mat4 turnedAbout(glm::vec2 joint, float angle) {
  const glm::vec3 at(joint, 0.0f);
  return glm::translate(glm::mat4(1.0f), at) *
         glm::rotate(glm::mat4(1.0f), angle, glm::vec3(0.0f, 0.0f, 1.0f)) *
         glm::translate(glm::mat4(1.0f), -at);
}

// A bone that hangs from `joint` in the plane at `z`.
glm::mat4 hung(glm::vec2 joint, float z, float angle) {
  return glm::translate(glm::mat4(1.0f), glm::vec3(joint, z)) *
         glm::rotate(glm::mat4(1.0f), angle, glm::vec3(0.0f, 0.0f, 1.0f));
}

// A wave over the stride; its crest at `crest`.
float wave(float stride, float crest) {
  return std::cos(kTau * (stride - crest));
}

struct Foot {
  glm::vec2 fetlock;  // against the horse's place on the ground
  float hoof_angle;   // 0: stands flat; negative: its toe points back
};

// A foot's closed path about `neutral_x`: straight back with the ground, then round through the
// air.
Foot footAt(float phase, bool hind, float neutral_x) {
  constexpr auto kStand = static_cast<float>(kStanceShare);
  if (phase < kStand) {
    return {{neutral_x + kSweep * (0.5f - phase / kStand), kFetlockHeight}, 0.0f};
  }
  const float s = (phase - kStand) / (1.0f - kStand);
  // Cubic Hermite that leaves and meets the ground at the ground's own speed.
  const float slope = -kSweep * (1.0f - kStand) / kStand;
  const float x =
      kSweep * (-0.5f + s * s * (3.0f - 2.0f * s)) + slope * (2.0f * s * s * s - 3.0f * s * s + s);
  // Lifted late by fore feet (they fold under the chest), early by hind feet.
  const float bow = std::sin(std::numbers::pi_v<float> * std::pow(s, hind ? 0.85f : 0.95f));
  const float lift = (hind ? 0.27f : 0.31f) * std::pow(bow, 1.6f);
  const float flexed = (hind ? -1.15f : -1.5f) * bow * bow * (1.0f - 0.35f * s);
  return {{neutral_x + x, kFetlockHeight + lift}, flexed};
}

glm::vec2 apply(const glm::mat4& matrix, glm::vec2 p) {
  return glm::vec2(matrix * glm::vec4(p, 0.0f, 1.0f));
}

// Angle of a matrix that turns about z.
float angleOf(const glm::mat4& matrix) {
  return std::atan2(matrix[0].y, matrix[0].x);
}

}  // namespace

double horseTravel(double time_s) {
  const double run_s = kStridesARun * kStride_s;
  const double into_run = time_s - run_s * std::floor(time_s / run_s);
  return kHorseSpeed * (into_run - 0.5 * run_s);
}

double legPhase(uint32_t leg, double time_s) {
  const double stride = time_s / kStride_s - kFootfall[leg];
  return stride - std::floor(stride);
}

HorsePose horsePose(double time_s) {
  HorsePose pose;
  const double strides = time_s / kStride_s;
  const auto stride = static_cast<float>(strides - std::floor(strides));
  const glm::mat4 ground = glm::translate(
      glm::mat4(1.0f), glm::vec3(static_cast<float>(horseTravel(time_s)), 0.0f, 0.0f));

  // The forehand is high while the hind legs land, the croup while the fore legs push; the whole is
  // highest in the air, after the lead has left the ground.
  const float pitch = 0.075f * wave(stride, 0.03f);
  const float bob = 0.030f * wave(stride, 0.86f);
  const glm::mat4 body = glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, bob, 0.0f)) *
                         turnedAbout({-0.05f, 0.95f}, pitch);
  pose.body = ground * body;

  // Neck and head balance: they reach down and forwards as the forehand rises.
  const glm::mat4 neck = body * turnedAbout(kNeckJoint, -0.16f - 0.13f * wave(stride, 0.10f));
  const glm::mat4 head = neck * turnedAbout(kPoll, 0.10f + 0.12f * wave(stride, 0.22f));
  pose.neck = ground * neck;
  pose.head = ground * head;

  // The tail streams; each bone follows the one before a little later, and sways to the sides.
  glm::mat4 tail = body * glm::translate(glm::mat4(1.0f), glm::vec3(kTailRoot, 0.0f));
  for (uint32_t i = 0; i < kTailBones; ++i) {
    const float late = 0.09f * static_cast<float>(i);
    const float droop = i == 0 ? -1.25f : 0.20f;
    const float bend = droop + (0.10f + 0.05f * static_cast<float>(i)) * wave(stride, 0.45f + late);
    const float sway =
        0.13f * std::sin(kTau * (0.5f * static_cast<float>(std::fmod(strides, 2.0)) - late));
    tail = tail * glm::rotate(glm::mat4(1.0f), bend, glm::vec3(0.0f, 0.0f, 1.0f)) *
           glm::rotate(glm::mat4(1.0f), sway, glm::vec3(1.0f, 0.0f, 0.0f));
    pose.tail[i] = ground * tail;
    tail = tail * glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, -kTailBone, 0.0f));
  }

  for (uint32_t leg = 0; leg < kHorseLegs; ++leg) {
    const bool hind = isHind(leg);
    const HorseLegLengths lengths = hind ? kHindLengths : kForeLengths;
    const float z = sideOf(leg) * kLegSpread;
    const auto phase = static_cast<float>(legPhase(leg, time_s));
    std::array<glm::mat4, kLegBones>& bones = pose.legs[leg];
    const Foot foot = footAt(phase, hind, hind ? -0.44f : 0.34f);
    if (hind) {
      // A horse's hock bends as its stifle does: the cannon stays parallel to the thigh, so that
      // the three bones reach as two would, one of them thigh and cannon together.
      const glm::vec2 hip = apply(body, kHip);
      const TwoBone two =
          reach(hip, foot.fetlock, lengths.thigh + lengths.cannon, lengths.shank, 1.0f);
      const float thigh = hangingAngle(hip, two.joint);
      const float shank = hangingAngle(two.joint, two.end);
      const glm::vec2 down(std::sin(thigh), -std::cos(thigh));
      const glm::vec2 stifle = hip + lengths.thigh * down;
      const glm::vec2 hock = stifle + (two.end - two.joint);
      bones = {hung(hip, z, thigh), hung(stifle, z, shank), hung(hock, z, thigh),
               hung(hock + lengths.cannon * down, z, foot.hoof_angle)};
    } else {
      // The blade swings with the leg, which lengthens its reach; elbow and knee bend forwards.
      const glm::vec2 shoulder = apply(body, kShoulder);
      const float swing = angleOf(body) + 0.45f * hangingAngle(shoulder, foot.fetlock) - 0.04f;
      const glm::vec2 elbow =
          shoulder + lengths.thigh * glm::vec2(std::sin(swing), -std::cos(swing));
      const TwoBone two = reach(elbow, foot.fetlock, lengths.shank, lengths.cannon, 1.0f);
      bones = {hung(shoulder, z, swing), hung(elbow, z, hangingAngle(elbow, two.joint)),
               hung(two.joint, z, hangingAngle(two.joint, two.end)),
               hung(two.end, z, foot.hoof_angle)};
    }
    for (glm::mat4& bone : bones) bone = ground * bone;
  }
  return pose;
}

}  // namespace reprise::lab
