// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "equation_samples.h"
#include "lab/vk/compute_program.h"
#include "lab/vk/image.h"

namespace reprise::lab {
namespace {

constexpr uint32_t kShader[] = {
#include "gpu_equals_cpu.comp.inc"
};
constexpr uint32_t kSeeds = 512;

// Vulkan bounds exp, log, pow and trigonometry to a few parts in 10^5 of their result or, for the
// last, 2^-11 absolute; drivers stay well inside.
constexpr float kRelative = 2.0e-4f;
constexpr float kAbsolute = 2.0e-5f;

TEST(Equations, GpuEqualsCpu) {
  Device device({.validation = Device::validationAvailable()});
  const ComputeProgram program(device, {.name = "equations",
                                        .spirv = kShader,
                                        .bindings = {VK_DESCRIPTOR_TYPE_STORAGE_IMAGE},
                                        .specialization = {}});
  const Image results(
      device, {.format = VK_FORMAT_R32G32B32A32_SFLOAT, .extent = {kSeeds, eq::kEquationCount}});
  device.submitAndWait([&](VkCommandBuffer commands) {
    program.dispatch(commands, results.extent(), {stored(results)});
  });
  const FloatImage gpu = download(device, results);
  for (uint32_t which = 0; which < eq::kEquationCount; ++which) {
    bool any = false;
    for (uint32_t seed = 0; seed < kSeeds; ++seed) {
      const eq::vec4 cpu = eq::equationSample(which, seed);
      for (int c = 0; c < 4; ++c) {
        const float there = gpu.at(seed, which)[c];
        any = any || cpu[c] != 0.0f;
        ASSERT_TRUE(std::isfinite(cpu[c])) << "equation " << which << ", seed " << seed;
        ASSERT_NEAR(there, cpu[c], kAbsolute + kRelative * std::abs(cpu[c]))
            << "equation " << which << ", seed " << seed << ", component " << c;
      }
    }
    EXPECT_TRUE(any) << "equation " << which << " is 0 everywhere";
  }
  EXPECT_TRUE(device.validationMessages().empty());
}

}  // namespace
}  // namespace reprise::lab
