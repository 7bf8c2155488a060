// SPDX-License-Identifier: MIT
//
// Figure 13: a rotating gobo amortized with everything else, or shaded at native rate and added
// after the resolve.
#include <fmt/format.h>

#include "lab/paper/amortized/experiments.h"
#include "lab/paper/amortized/subjects.h"
#include "lab/paper/crop.h"

namespace reprise::lab::amortized {
namespace {

constexpr uint32_t kCrop_px = 96;
constexpr PaperView kAmortized{.defer_lights = false};
constexpr PaperView kDeferred{.defer_lights = true};

}  // namespace

void figure13(PaperLab& lab, Outcome& outcome) {
  if (!sceneIsHere(indoor().scene)) {
    outcome.lacks("scene " + indoor().scene);
    return;
  }
  const std::string& run = indoor().moving;
  const std::string ours = amortizedFor(lab, indoor());
  const double deferred_db = movingPsnr(lab, run, ours, kDeferred);
  const FloatImage deferred = lab.measure(run, ours, kDeferred).last;
  const double amortized_db = movingPsnr(lab, run, ours, kAmortized);
  const FloatImage amortized = lab.measure(run, ours, kAmortized).last;
  outcome.report("gobo amortized", std::nullopt, amortized_db, "dB");
  outcome.claim("gobo deferred", std::nullopt, deferred_db, "dB", "above amortized",
                deferred_db > amortized_db);
  PaperScene& scene = lab.scene(run, kAmortized);
  const FloatImage& reference = scene.reference(scene.frames() - 1);
  // Where the light is: the two differ nowhere else.
  const CropBox box = worstSquare(deferred, amortized, kCrop_px);
  outcome.gallery(fmt::format("{}, last frame", run), {{"gobo amortized", crop(amortized, box)},
                                                       {"gobo deferred", crop(deferred, box)},
                                                       {"reference", crop(reference, box)}});
}

}  // namespace reprise::lab::amortized
