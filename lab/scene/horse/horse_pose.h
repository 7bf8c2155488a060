// SPDX-License-Identifier: MIT
//
// The toy horse's bones at a time: a transverse gallop along +x, as a pure function of seconds.
// Measures are metres of a horse 1.15 m high at the withers. Bones' own spaces: legs hang down from
// their upper joint along -y, body, neck, head and tail are as they stand in the horse at rest
// (x forwards, y up, z to its right).
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

namespace reprise::lab {

// Sides and ends of the horse in the order in which its feet fall: the lead is the left fore.
enum HorseLeg : uint32_t { kRightHind, kLeftHind, kRightFore, kLeftFore, kHorseLegs };

constexpr bool isHind(uint32_t leg) {
  return leg <= kLeftHind;
}
constexpr float sideOf(uint32_t leg) {
  return leg == kRightHind || leg == kRightFore ? 1.0f : -1.0f;
}

// Bones of a leg. A foreleg's first is the shoulder blade with the upper arm.
enum HorseLegBone : uint32_t { kThigh, kShank, kCannon, kHoof, kLegBones };

constexpr uint32_t kTailBones = 4;

struct HorsePose {
  glm::mat4 body{1.0f};
  glm::mat4 neck{1.0f};
  glm::mat4 head{1.0f};
  std::array<glm::mat4, kTailBones> tail{};
  std::array<std::array<glm::mat4, kLegBones>, kHorseLegs> legs{};
};

// Lengths between joints (m).
struct HorseLegLengths {
  float thigh, shank, cannon;
};
constexpr HorseLegLengths kHindLengths = {0.30f, 0.34f, 0.30f};
constexpr HorseLegLengths kForeLengths = {0.28f, 0.40f, 0.315f};
constexpr float kFetlockHeight = 0.15f;  // of a hoof that stands

// Where joints are in the horse at rest.
constexpr glm::vec2 kHip = {-0.40f, 1.00f};
constexpr glm::vec2 kShoulder = {0.29f, 1.11f};  // about which the blade turns
constexpr glm::vec2 kNeckJoint = {0.34f, 1.02f};
constexpr glm::vec2 kPoll = {0.80f, 1.52f};
constexpr glm::vec2 kTailRoot = {-0.585f, 1.08f};
constexpr float kLegSpread = 0.125f;  // from the middle plane
constexpr float kTailBone = 0.20f;

// Gait. 2.16 m a stride and 3 m/s: feet that stand do not slide.
constexpr double kStride_s = 0.72;
constexpr double kHorseSpeed = 3.0;    // m/s
constexpr double kStanceShare = 0.22;  // of a stride that each foot stands
// After so many strides the run begins again where it began, so that positions stay precise.
constexpr double kStridesARun = 27.0;

// Way of the horse along x (m), centred.
double horseTravel(double time_s);
// Position of a leg in its own stride, [0, 1): it stands in [0, kStanceShare).
double legPhase(uint32_t leg, double time_s);

HorsePose horsePose(double time_s);

}  // namespace reprise::lab
