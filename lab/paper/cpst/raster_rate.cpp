// SPDX-License-Identifier: MIT
//
// Coarse shading as hardware does it, by fragments of several pixels, beside the compute pass that
// stands for it everywhere else in the lab: the same plans, image by image and count by count.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

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

std::unique_ptr<SceneSource> sourceBy(ShadeBy shade_by, Device& device, const Subject& subject,
                                      VkExtent2D extent) {
  SceneSourceOptions options;
  options.extent = extent;
  options.frames = kFrames;
  options.switches.shade_by = shade_by;
  options.switches.lamps = subject.lamps;
  options.reference.cache = "none";
  return std::make_unique<SceneSource>(device, parseSceneRun(subject.run), options);
}

struct Shaded {
  FloatImage image;  // display values
  uint64_t evaluations;
};

Shaded shade(Device& device, SceneSource& source, const SamplePlan& plan, uint32_t index) {
  throwIfInterrupted();
  source.prepare(plan);
  source.takeEvaluations();
  FrameInputs inputs;
  device.submitAndWait(
      [&](VkCommandBuffer commands) { inputs = source.frame(commands, index, plan); });
  FloatImage image = displayImage(download(device, *inputs.color));
  return {std::move(image), source.takeEvaluations()};
}

// Frames of `technique`'s plans, shaded by both.
void compareBoth(PaperLab& lab, Device& device, const Subject& subject, const std::string& rate,
                 const std::string& technique, Outcome& outcome) {
  const VkExtent2D extent = lab.scale().extent;
  const auto compute = sourceBy(ShadeBy::kCompute, device, subject, extent);
  const auto raster = sourceBy(ShadeBy::kRaster, device, subject, extent);
  Resolver resolver(device, parseTechnique(technique), compute->info());
  Progress progress(fmt::format("{} by compute and raster, {}", subject.name, rate), kFrames,
                    lab.quiet());
  double squared_error = 0.0;
  double most = 0.0;
  double by_compute = 0.0;
  double by_raster = 0.0;
  for (uint32_t index = 0; index < kFrames; ++index) {
    SamplePlan plan = resolver.plan(index);
    plan.request = {};
    const Shaded a = shade(device, *compute, plan, index);
    const Shaded b = shade(device, *raster, plan, index);
    squared_error += meanSquaredError(a.image, b.image) / kFrames;
    for (size_t i = 0; i < a.image.texels.size(); ++i) {
      most = std::max(most, std::abs(static_cast<double>(a.image.texels[i]) - b.image.texels[i]));
    }
    by_compute += static_cast<double>(a.evaluations);
    by_raster += static_cast<double>(b.evaluations);
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
