// SPDX-License-Identifier: MIT
//
// Every technique on one sample a pixel and on four: more samples in, nearer to the truth out.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "lab/metrics/display_space.h"
#include "lab/metrics/psnr.h"
#include "lab/render/scene_source.h"
#include "lab/run/sequence_run.h"
#include "lab/run/technique_choice.h"
#include "tests/test_device.h"

namespace reprise::lab {
namespace {

constexpr VkExtent2D kExtent{80, 45};
constexpr uint32_t kFrames = 6;

SceneSourceOptions optionsOf(uint32_t samples) {
  SceneSourceOptions options;
  options.extent = kExtent;
  options.frames = kFrames;
  options.switches.samples = samples;
  options.reference.samples = 64;
  options.reference.cache = "none";
  return options;
}

double lastPsnr(Device& device, SceneSource& source, const std::string& technique,
                const FloatImage& reference) {
  Resolver resolver(device, parseTechnique(technique), source.info());
  const SequenceRun run = runSequence(device, source, resolver, kFrames, true, nullptr);
  for (const float value : run.images.back().texels) {
    EXPECT_TRUE(std::isfinite(value)) << technique;
  }
  return psnrDb(meanSquaredError(displayImage(reference), displayImage(run.images.back())));
}

TEST(SamplesAPixel, FourBringEveryTechniqueNearer) {
  Device& device = testDevice();
  SceneSource one(device, parseSceneRun("brick/pan"), optionsOf(1));
  SceneSource four(device, parseSceneRun("brick/pan"), optionsOf(4));
  const FloatImage reference = *one.reference(kFrames - 1);
  for (uint32_t i = 0; i < repriseGetTechniqueCount(); ++i) {
    const std::string technique = repriseGetTechnique(i)->name;
    Resolver resolver(device, parseTechnique(technique), one.info());
    const RepriseSamplePlan plan = resolver.plan(0).library;
    if (plan.coarse_size > 1 || plan.checkerboard != 0) {
      std::cout << technique << " skipped: with four samples every pixel is shaded, and it shades "
                << "fewer\n";
      continue;
    }
    EXPECT_GT(lastPsnr(device, four, technique, reference),
              lastPsnr(device, one, technique, reference) + 0.5)
        << technique;
  }
}

}  // namespace
}  // namespace reprise::lab
