// SPDX-License-Identifier: MIT
//
// Coarse shading as hardware does it, by fragments of several pixels, beside the compute pass that
// stands for it everywhere else in the lab: the same plans, image by image and count by count.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lab/metrics/display_space.h"
#include "lab/metrics/psnr.h"
#include "lab/paper/cpst/experiments.h"
#include "lab/paper/cpst/subjects.h"
#include "lab/run/interrupt.h"
#include "lab/run/progress.h"

namespace reprise::lab::cpst {
namespace {

constexpr uint32_t kFrames = 4;  // in which the coarse grid takes all of its places
// A display of 8 bits shows no difference below this, of its white.
constexpr double kInvisible = 0.5 / 255.0;

struct Shaded {
  FloatImage image;  // display values
  uint64_t evaluations;
};

Shaded shaded(Device& device, SceneSource& source) {
  FloatImage image = displayImage(download(device, source.renderer().color()));
  return {std::move(image), source.takeEvaluations()};
}

// Frames of `technique`'s plans, shaded by both, off one visibility.
void compareBoth(PaperLab& lab, Device& device, const Subject& subject, const std::string& rate,
                 const std::string& technique, Outcome& outcome) {
  SceneSourceOptions options;
  options.extent = lab.scale().extent;
  options.frames = kFrames;
  options.switches.shade_by = ShadeBy::kRaster;
  options.switches.lamps = subject.lamps;
  options.reference.cache = "none";
  SceneSource source(device, parseSceneRun(subject.run), options);
  Resolver resolver(device, parseTechnique(technique), source.info());
  Progress progress(fmt::format("{} by compute and raster, {}", subject.name, rate), kFrames,
                    lab.quiet());
  double squared_error = 0.0;
  double most = 0.0;
  double by_compute = 0.0;
  double by_raster = 0.0;
  for (uint32_t index = 0; index < kFrames; ++index) {
    SamplePlan plan = resolver.plan(index);
    plan.request = {};
    throwIfInterrupted();
    source.prepare(plan);
    source.prepareCompute(plan);
    source.takeEvaluations();
    device.submitAndWait([&](VkCommandBuffer commands) { source.frame(commands, index, plan); });
    const Shaded raster = shaded(device, source);
    device.submitAndWait([&](VkCommandBuffer commands) { source.shadeByCompute(commands, plan); });
    const Shaded compute = shaded(device, source);
    squared_error += meanSquaredError(compute.image, raster.image) / kFrames;
    for (size_t i = 0; i < compute.image.texels.size(); ++i) {
      most = std::max(
          most, std::abs(static_cast<double>(compute.image.texels[i]) - raster.image.texels[i]));
    }
    by_compute += static_cast<double>(compute.evaluations);
    by_raster += static_cast<double>(raster.evaluations);
    progress.step();
  }
  const std::string row = fmt::format("{}, {}", subject.name, rate);
  outcome.report(row + ", raster against compute", {}, psnrDb(squared_error), "dB");
  outcome.claim(row + ", largest difference", {}, most, "of white", "below half a step of 8 bits",
                most < kInvisible);
  const double ratio = by_raster / by_compute;
  outcome.claim(row + ", evaluations of raster over compute", {}, ratio, "times", "within 0.1 %",
                std::abs(ratio - 1.0) < 0.001);
}

}  // namespace

void rasterRate(PaperLab& lab, Outcome& outcome) {
  const auto device = lab.openDevice();
  const bool coarse = device->hasFragmentSize(2);
  for (const Subject& subject : subjects()) {
    if (!subject.note.empty()) outcome.note(subject.note);
    compareBoth(lab, *device, subject, "full rate", kPs, outcome);
    if (coarse) compareBoth(lab, *device, subject, "2 x 2", kCpst, outcome);
  }
  if (!coarse) {
    outcome.note(
        fmt::format("2 x 2 is not compared: device '{}' has no "
                    "VK_KHR_fragment_shading_rate with 2 x 2 pixels a fragment.",
                    device->name()));
  }
  outcome.note(fmt::format("{} x {}, {} frames, display values.", lab.scale().extent.width,
                           lab.scale().extent.height, kFrames));
  lab.keepValidation(*device);
}

}  // namespace reprise::lab::cpst
