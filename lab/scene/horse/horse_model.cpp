// SPDX-License-Identifier: MIT
#include "lab/scene/horse/horse_model.h"

#include <glm/gtc/matrix_transform.hpp>

#include "lab/scene/mesh/lathe.h"
#include "lab/scene/mesh/loft.h"

namespace reprise::lab {
namespace {

const glm::mat4& bodyBone(const HorsePose& pose, uint32_t) {
  return pose.body;
}
const glm::mat4& neckBone(const HorsePose& pose, uint32_t) {
  return pose.neck;
}
const glm::mat4& headBone(const HorsePose& pose, uint32_t) {
  return pose.head;
}
const glm::mat4& tailBone(const HorsePose& pose, uint32_t bone) {
  return pose.tail[bone];
}
const glm::mat4& legBone(const HorsePose& pose, uint32_t index) {
  return pose.legs[index / kLegBones][index % kLegBones];
}

Mesh moved(Mesh mesh, glm::vec3 by) {
  return transformed(std::move(mesh), glm::translate(glm::mat4(1.0f), by));
}

// A section across a path in the middle plane: x, y, half height, half width.
Section at(float x, float y, float half_height, float half_width) {
  return {{x, y, 0.0f}, half_height, half_width};
}

Mesh barrel() {
  const Section sections[] = {
      at(-0.555f, 1.000f, 0.110f, 0.095f), at(-0.500f, 0.990f, 0.165f, 0.150f),
      at(-0.380f, 0.980f, 0.205f, 0.185f), at(-0.200f, 0.975f, 0.190f, 0.170f),
      at(-0.020f, 0.955f, 0.192f, 0.180f), at(0.150f, 0.935f, 0.218f, 0.192f),
      at(0.290f, 0.940f, 0.235f, 0.180f),  at(0.410f, 0.960f, 0.205f, 0.150f),
      at(0.490f, 0.975f, 0.140f, 0.110f)};
  return loft(sections, {.around = 48, .rows_a_span = 6, .cap_rows = 8, .cap_length = 0.55f});
}

Mesh neck() {
  const Section sections[] = {
      at(0.280f, 0.965f, 0.190f, 0.105f), at(0.420f, 1.090f, 0.195f, 0.110f),
      at(0.550f, 1.225f, 0.155f, 0.088f), at(0.665f, 1.365f, 0.122f, 0.070f),
      at(0.760f, 1.480f, 0.095f, 0.058f), at(0.815f, 1.535f, 0.070f, 0.050f)};
  return loft(sections, {.around = 36, .rows_a_span = 7, .cap_rows = 5});
}

Mesh skull() {
  // From the poll down the face to the lips.
  const Section sections[] = {
      at(0.765f, 1.545f, 0.068f, 0.052f), at(0.835f, 1.505f, 0.098f, 0.068f),
      at(0.905f, 1.440f, 0.104f, 0.070f), at(0.985f, 1.355f, 0.077f, 0.054f),
      at(1.055f, 1.280f, 0.058f, 0.043f), at(1.105f, 1.225f, 0.061f, 0.048f),
      at(1.135f, 1.190f, 0.052f, 0.043f)};
  return loft(sections, {.around = 36, .rows_a_span = 6, .cap_rows = 6, .cap_length = 0.55f});
}

Mesh ear(float side) {
  const Section sections[] = {{{0.790f, 1.575f, side * 0.036f}, 0.022f, 0.020f},
                              {{0.785f, 1.625f, side * 0.042f}, 0.030f, 0.020f},
                              {{0.792f, 1.672f, side * 0.045f}, 0.018f, 0.013f},
                              {{0.805f, 1.712f, side * 0.044f}, 0.004f, 0.004f}};
  return loft(sections, {.around = 16, .rows_a_span = 4, .cap_rows = 3});
}

// Lips: a slit that a saw would leave, as a darker bar let in across the muzzle.
Mesh mouth() {
  const Section sections[] = {at(1.085f, 1.196f, 0.006f, 0.0435f),
                              at(1.110f, 1.189f, 0.006f, 0.0460f),
                              at(1.135f, 1.178f, 0.005f, 0.0330f)};
  return loft(sections, {.around = 24, .rows_a_span = 5, .cap_rows = 3});
}

Mesh eye(float side) {
  Mesh mesh = ellipsoidMesh({0.020f, 0.017f, 0.012f}, 28);
  return moved(transformed(mesh, glm::rotate(glm::mat4(1.0f), -0.8f, {0.0f, 0.0f, 1.0f})),
               {0.893f, 1.480f, side * 0.063f});
}

Mesh nostril(float side) {
  Mesh mesh = ellipsoidMesh({0.016f, 0.010f, 0.008f}, 20);
  return moved(transformed(mesh, glm::rotate(glm::mat4(1.0f), 0.6f, {0.0f, 0.0f, 1.0f})),
               {1.132f, 1.223f, side * 0.041f});
}

// A flat lock of hair from `root`, swept by `way`, that thins to a tip.
Mesh lock(glm::vec3 root, glm::vec3 way, float width, float thickness) {
  const auto point = [&](float t) {
    return root + t * way - glm::vec3(0.0f, 0.35f * t * t, 0.0f) * glm::length(way);
  };
  const Section sections[] = {{point(-0.10f), 0.55f * width, thickness},
                              {point(0.25f), width, 1.1f * thickness},
                              {point(0.65f), 0.75f * width, 0.8f * thickness},
                              {point(1.0f), 0.10f * width, 0.25f * thickness}};
  return loft(sections, {.around = 14, .rows_a_span = 4, .cap_rows = 3});
}

// Carved locks along the crest, blown back: they overlap like shingles.
Mesh mane() {
  Mesh mesh;
  constexpr int kLocks = 11;
  for (int i = 0; i < kLocks; ++i) {
    const float t = static_cast<float>(i) / (kLocks - 1);
    // The crest: upper edge of the neck's sections.
    const glm::vec3 crest =
        glm::mix(glm::vec3(0.345f, 1.205f, 0.0f), glm::vec3(0.735f, 1.575f, 0.0f), t) +
        glm::vec3(-0.025f, 0.030f, 0.0f) * (4.0f * t * (1.0f - t));
    const float side = i % 2 == 0 ? 1.0f : -1.0f;
    append(mesh, lock(crest, {-0.155f - 0.02f * t, 0.060f, 0.022f * side}, 0.050f, 0.024f));
  }
  return mesh;
}

Mesh forelock() {
  Mesh mesh = lock({0.790f, 1.600f, 0.0f}, {0.085f, 0.000f, 0.012f}, 0.024f, 0.026f);
  append(mesh, lock({0.775f, 1.605f, 0.0f}, {-0.11f, 0.060f, 0.0f}, 0.045f, 0.026f));
  return mesh;
}

Mesh tailPiece(uint32_t bone) {
  constexpr float kThick[kTailBones + 1] = {0.036f, 0.066f, 0.078f, 0.060f, 0.012f};
  const float top = kThick[bone];
  const float bottom = kThick[bone + 1];
  const bool last = bone + 1 == kTailBones;
  const Section sections[] = {
      at(0.0f, 0.02f, top, 0.62f * top),
      at(0.0f, -0.5f * kTailBone, 0.53f * (top + bottom), 0.34f * (top + bottom)),
      at(0.0f, last ? -1.35f * kTailBone : -kTailBone, bottom, 0.62f * bottom)};
  return loft(sections, {.around = 24, .rows_a_span = 6, .cap_rows = 4, .cap_length = 0.6f});
}

Mesh saddle() {
  // Wider than the back it lies on, and higher: a shell's outside.
  const Section sections[] = {
      at(-0.165f, 1.035f, 0.150f, 0.165f), at(-0.100f, 1.025f, 0.172f, 0.182f),
      at(0.000f, 1.000f, 0.168f, 0.194f), at(0.100f, 0.990f, 0.185f, 0.204f),
      at(0.180f, 1.010f, 0.190f, 0.188f)};
  Mesh mesh = loft(sections, {.around = 48, .rows_a_span = 5, .cap_rows = 4, .cap_length = 0.15f});
  return mesh;
}

// A strap around the barrel, or the muzzle.
Mesh strap(float x, float y, float half_height, float half_width, float breadth, float lean) {
  const glm::vec2 step = 0.5f * breadth * glm::vec2(std::cos(lean), std::sin(lean));
  const Section sections[] = {at(x - step.x, y - step.y, half_height, half_width),
                              at(x + step.x, y + step.y, half_height, half_width)};
  return loft(sections, {.around = 48, .rows_a_span = 3, .cap_rows = 3, .cap_length = 0.03f});
}

// A bone that hangs down: sections (y, half depth along x, half width).
struct Across {
  float y, deep, wide, x = 0.0f;
};
Mesh hanging(std::initializer_list<Across> across) {
  std::vector<Section> sections;
  for (const Across& a : across) sections.push_back(at(a.x, a.y, a.deep, a.wide));
  return loft(sections, {.around = 24, .rows_a_span = 5, .cap_rows = 4, .cap_length = 0.8f});
}

Mesh ball(float radius, float y = 0.0f) {
  return moved(sphereMesh(radius, 24), {0.0f, y, 0.0f});
}

Mesh hoof() {
  // Turned, cut flat below, tipped forwards as hooves are.
  const glm::vec2 profile[] = {{0.0f, 0.0f},     {0.058f, 0.0f},   {0.061f, 0.006f},
                               {0.050f, 0.062f}, {0.044f, 0.070f}, {0.0f, 0.072f}};
  Mesh mesh = lathe(profile, 32, 0.5f);
  glm::mat4 shear(1.0f);
  shear[1].x = -0.42f;  // shear keeps volume: normals are made anew
  mesh = transformed(mesh, shear);
  makeSmooth(mesh, 0.5f);
  return moved(mesh, {0.058f, -kFetlockHeight, 0.0f});
}

Mesh pastern() {
  return hanging({{0.0f, 0.036f, 0.034f},
                  {-0.045f, 0.031f, 0.030f, 0.015f},
                  {-0.09f, 0.040f, 0.039f, 0.034f}});
}

void appendLegs(std::vector<HorsePart>& parts) {
  for (uint32_t leg = 0; leg < kHorseLegs; ++leg) {
    const HorseLegLengths l = isHind(leg) ? kHindLengths : kForeLengths;
    Mesh upper;
    Mesh shank;
    Mesh cannon;
    if (isHind(leg)) {
      upper = hanging({{0.06f, 0.130f, 0.060f, -0.02f},
                       {-0.06f, 0.175f, 0.078f, -0.015f},
                       {-0.18f, 0.150f, 0.076f, -0.01f},
                       {-l.thigh, 0.098f, 0.060f}});
      shank = hanging({{0.02f, 0.098f, 0.060f},
                       {-0.10f, 0.088f, 0.056f, -0.008f},
                       {-0.22f, 0.058f, 0.043f},
                       {-l.shank, 0.046f, 0.039f}});
      append(shank, ball(0.047f, -l.shank));
      cannon =
          hanging({{0.0f, 0.046f, 0.038f}, {-0.12f, 0.034f, 0.030f}, {-l.cannon, 0.034f, 0.031f}});
    } else {
      upper = hanging({{0.0f, 0.085f, 0.045f},
                       {-0.10f, 0.130f, 0.066f},
                       {-0.20f, 0.120f, 0.068f},
                       {-l.thigh, 0.078f, 0.056f}});
      shank = hanging({{0.02f, 0.080f, 0.057f},
                       {-0.12f, 0.070f, 0.052f},
                       {-0.28f, 0.047f, 0.040f},
                       {-l.shank, 0.043f, 0.038f}});
      append(shank, ball(0.046f, -l.shank));
      cannon =
          hanging({{0.0f, 0.041f, 0.037f}, {-0.13f, 0.032f, 0.029f}, {-l.cannon, 0.033f, 0.030f}});
    }
    append(cannon, ball(0.038f, -l.cannon));
    const uint32_t first = leg * kLegBones;
    const HorseWood wood = HorseWood::kLightUpright;
    parts.push_back({std::move(upper), wood, legBone, first + kThigh});
    parts.push_back({std::move(shank), wood, legBone, first + kShank});
    parts.push_back({std::move(cannon), wood, legBone, first + kCannon});
    parts.push_back({pastern(), wood, legBone, first + kHoof});
    parts.push_back({hoof(), HorseWood::kHoof, legBone, first + kHoof});
  }
}

}  // namespace

std::vector<HorsePart> horseParts() {
  std::vector<HorsePart> parts;
  parts.push_back({barrel(), HorseWood::kLight, bodyBone});
  parts.push_back({neck(), HorseWood::kLight, neckBone});
  Mesh head = skull();
  for (const float side : {-1.0f, 1.0f}) append(head, ear(side));
  parts.push_back({std::move(head), HorseWood::kLight, headBone});
  parts.push_back({mane(), HorseWood::kDark, neckBone});
  Mesh dark = forelock();
  append(dark, mouth());
  for (const float side : {-1.0f, 1.0f}) append(dark, nostril(side));
  parts.push_back({std::move(dark), HorseWood::kDark, headBone});
  Mesh eyes = eye(-1.0f);
  append(eyes, eye(1.0f));
  parts.push_back({std::move(eyes), HorseWood::kEye, headBone});
  for (uint32_t bone = 0; bone < kTailBones; ++bone) {
    parts.push_back({tailPiece(bone), HorseWood::kDark, tailBone, bone});
  }
  Mesh girth = saddle();
  append(girth, strap(0.055f, 0.948f, 0.208f, 0.192f, 0.05f, 0.0f));
  parts.push_back({std::move(girth), HorseWood::kLeather, bodyBone});
  Mesh bridle = strap(1.020f, 1.318f, 0.072f, 0.053f, 0.022f, -0.82f);
  append(bridle, strap(0.822f, 1.513f, 0.100f, 0.071f, 0.020f, -0.45f));
  parts.push_back({std::move(bridle), HorseWood::kLeather, headBone});
  appendLegs(parts);
  return parts;
}

}  // namespace reprise::lab
