// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lab/scene/horse/horse_model.h"
#include "lab/scene/horse/horse_pose.h"

namespace reprise::lab {
namespace {

constexpr int kStepsAStride = 144;

double timeOfStep(int step) {
  return kStride_s * step / kStepsAStride;
}

glm::vec3 worldOf(const glm::mat4& bone, glm::vec3 point) {
  return glm::vec3(bone * glm::vec4(point, 1.0f));
}

// Heights of the lowest hoof vertex of each leg, over a stride.
template <typename Check>
void forEachHoof(const Check& check) {
  const std::vector<HorsePart> parts = horseParts();
  for (int step = 0; step < kStepsAStride; ++step) {
    const double time_s = timeOfStep(step);
    const HorsePose pose = horsePose(time_s);
    for (const HorsePart& part : parts) {
      if (part.wood != HorseWood::kHoof) continue;
      const glm::mat4& bone = part.bone(pose, part.index);
      float lowest = 1e9f;
      for (const GpuVertex& vertex : part.mesh.vertices) {
        lowest = std::min(lowest, worldOf(bone, glm::vec3(vertex.position_u)).y);
      }
      check(part.index / kLegBones, time_s, lowest);
    }
  }
}

TEST(HorseGait, HoovesStandOnTheFloorAndNeverSinkIn) {
  forEachHoof([](uint32_t leg, double time_s, float lowest_m) {
    EXPECT_GT(lowest_m, -0.003f) << leg << " at " << time_s;
    if (legPhase(leg, time_s) < kStanceShare) {
      EXPECT_LT(lowest_m, 0.003f) << leg << " at " << time_s;
    }
  });
}

TEST(HorseGait, HoovesThatStandDoNotSlide) {
  for (int step = 0; step + 1 < kStepsAStride; ++step) {
    const HorsePose now = horsePose(timeOfStep(step));
    const HorsePose next = horsePose(timeOfStep(step + 1));
    for (uint32_t leg = 0; leg < kHorseLegs; ++leg) {
      const double phase = legPhase(leg, timeOfStep(step));
      const double later = legPhase(leg, timeOfStep(step + 1));
      if (later >= kStanceShare || later < phase) continue;
      const glm::vec3 slide = worldOf(next.legs[leg][kHoof], glm::vec3(0.0f)) -
                              worldOf(now.legs[leg][kHoof], glm::vec3(0.0f));
      EXPECT_LT(glm::length(slide), 0.001f) << leg << " at step " << step;
    }
  }
}

TEST(HorseGait, GallopsWithAllFeetInTheAirOnceAStride) {
  int gathered = 0;
  int most = 0;
  for (int step = 0; step < kStepsAStride; ++step) {
    int standing = 0;
    for (uint32_t leg = 0; leg < kHorseLegs; ++leg) {
      standing += legPhase(leg, timeOfStep(step)) < kStanceShare ? 1 : 0;
    }
    gathered += standing == 0 ? 1 : 0;
    most = std::max(most, standing);
  }
  EXPECT_GT(gathered, kStepsAStride / 5);
  EXPECT_EQ(most, 2);
}

TEST(HorseGait, BonesHangTogether) {
  for (int step = 0; step < kStepsAStride; ++step) {
    const HorsePose pose = horsePose(timeOfStep(step));
    for (uint32_t leg = 0; leg < kHorseLegs; ++leg) {
      const HorseLegLengths l = isHind(leg) ? kHindLengths : kForeLengths;
      const float lengths[] = {l.thigh, l.shank, l.cannon};
      for (uint32_t bone = kThigh; bone < kHoof; ++bone) {
        const glm::vec3 end = worldOf(pose.legs[leg][bone], glm::vec3(0.0f, -lengths[bone], 0.0f));
        const glm::vec3 next = worldOf(pose.legs[leg][bone + 1], glm::vec3(0.0f));
        ASSERT_LT(glm::distance(end, next), 1e-3f) << leg << ' ' << bone << " step " << step;
      }
    }
  }
}

TEST(HorseGait, IsSmooth) {
  // No bone jumps: in 1/200 of a second nothing moves by more than 10 cm.
  for (int step = 0; step < kStepsAStride; ++step) {
    const HorsePose now = horsePose(timeOfStep(step));
    const HorsePose next = horsePose(timeOfStep(step + 1));
    for (uint32_t leg = 0; leg < kHorseLegs; ++leg) {
      for (uint32_t bone = 0; bone < kLegBones; ++bone) {
        const glm::vec3 tip(0.0f, -0.3f, 0.0f);
        EXPECT_LT(
            glm::distance(worldOf(now.legs[leg][bone], tip), worldOf(next.legs[leg][bone], tip)),
            0.1f)
            << leg << ' ' << bone << " step " << step;
      }
    }
  }
}

TEST(HorseModel, IsAsTallAsAHorseOfItsLength) {
  size_t triangles = 0;
  glm::vec3 low(1e9f);
  glm::vec3 high(-1e9f);
  const HorsePose pose = horsePose(0.0);
  for (const HorsePart& part : horseParts()) {
    triangles += part.mesh.triangleCount();
    for (const GpuVertex& vertex : part.mesh.vertices) {
      const glm::vec3 p = worldOf(part.bone(pose, part.index), glm::vec3(vertex.position_u));
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
  }
  EXPECT_GT(triangles, 20000u);
  EXPECT_LT(triangles, 60000u);
  EXPECT_NEAR(high.y - low.y, 1.70f, 0.15f);  // to the ears
  EXPECT_NEAR(high.x - low.x, 2.5f, 0.3f);    // nose to the streaming tail
  EXPECT_LT(high.z - low.z, 0.5f);
}

}  // namespace
}  // namespace reprise::lab
