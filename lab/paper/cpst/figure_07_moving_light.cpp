// SPDX-License-Identifier: MIT
//
// Figure 7: shading that changes on surfaces that history is kept of. How far each method lags.
#include <fmt/format.h>

#include <map>

#include "lab/metrics/display_space.h"
#include "lab/paper/changed_shading.h"
#include "lab/paper/cpst/experiments.h"
#include "lab/paper/cpst/subjects.h"
#include "lab/paper/crop.h"
#include "lab/paper/masked_error.h"

namespace reprise::lab::cpst {
namespace {

constexpr uint32_t kCrop_px = 72;

// Pixels whose surface came into view.
PixelMask unseen(const FrameTruth& truth) {
  PixelMask mask(truth.ages.size());
  for (size_t i = 0; i < mask.size(); ++i) mask[i] = hasPreviousSurface(truth.ages[i]) ? 0 : 1;
  return mask;
}

void movingLight(PaperLab& lab, const std::string& name, const std::string& run, bool asked,
                 Outcome& outcome) {
  PaperView seen = view();
  seen.over_time = true;
  PaperScene& scene = lab.scene(run, seen);
  const uint32_t first = std::max(PaperLab::warmUp(scene.frames()), 1u);
  std::map<uint32_t, PixelMask> changed;
  for (uint32_t t = first; t < scene.frames(); ++t) {
    const FrameTruth& truth = scene.truth().frames[t];
    changed[t] =
        changedShading(scene.reference(t), scene.reference(t - 1), truth.motion_px, unseen(truth));
  }
  const std::vector<Contender> contenders = {
      {"PS", kPs},
      {"CBR", kCbr},
      {"CPS-T", kCpst},
      {"CPS-T as published", "cpst:preset=paper"},
      {"CPS-T, change not followed", "cpst:change=false"},
      {"CPS-T, samples mixed everywhere", "cpst:reconstruct=always"},
      {"CPS-T, LoD 0", "cpst:variance=fine"}};
  std::vector<std::string> techniques;
  std::vector<std::pair<std::string, FloatImage>> pictures;
  for (const Contender& contender : contenders) {
    techniques.push_back(contender.technique);
    pictures.emplace_back(contender.name, FloatImage{});
  }
  std::map<std::string, MaskedError> errors;
  lab.filterTogether(
      run, techniques,
      [&](size_t i, const FrameDone& done) {
        if (done.index < first) return;
        FloatImage display = displayImage(done.image);
        errors[contenders[i].name].add(changed[done.index], scene.reference(done.index), display);
        if (done.index + 1 == scene.frames()) pictures[i].second = std::move(display);
      },
      seen);
  std::vector<std::vector<std::string>> lines;
  for (const Contender& contender : contenders) {
    const MaskedError& error = errors[contender.name];
    lines.push_back({contender.name, fmt::format("{:.2f}", error.insideDb()),
                     fmt::format("{:.2f}", error.outsideDb())});
    outcome.report(fmt::format("{}, where shading changed, {}", name, contender.name), std::nullopt,
                   error.insideDb(), "dB");
  }
  const MaskedError& ours = errors["CPS-T"];
  outcome.report(name + ", pixels whose shading changed", std::nullopt, 100.0 * ours.shareInside(),
                 "%");
  if (ours.pixelsInside() == 0) {
    outcome.note(name + ": no shading changed that fast");
    return;
  }
  outcome.table(fmt::format("{} ({}), dB", name, run), {"", "where shading changed", "elsewhere"},
                lines);
  const double lag_db = errors["PS"].insideDb() - ours.insideDb();
  outcome.claim(name + ", where shading changed, PS over CPS-T", std::nullopt, lag_db, "dB",
                "CPS-T converges more slowly, the limit that the paper states", lag_db > 0.0);
  const double gain_db = ours.insideDb() - errors["CPS-T as published"].insideDb();
  if (asked) {
    outcome.claim(name + ", where shading changed, CPS-T over the published", std::nullopt, gain_db,
                  "dB", "faster", gain_db > 0.0);
  } else {
    outcome.report(name + ", where shading changed, CPS-T over the published", std::nullopt,
                   gain_db, "dB");
  }
  const FloatImage& reference = scene.reference(scene.frames() - 1);
  const CropBox box = worstSquare(reference, pictures[2].second, kCrop_px);
  pictures.emplace_back("reference", reference);
  for (auto& [label, image] : pictures) image = crop(image, box);
  outcome.gallery(name + ", last frame, where CPS-T is farthest off", pictures);
}

}  // namespace

void figure7(PaperLab& lab, Outcome& outcome) {
  movingLight(lab, "shadows of a wandering sun", "hangar/fly", true, outcome);
  movingLight(lab, "a turning gobo", "indoor/fly", false, outcome);
  outcome.note(
      "The published figure is a shadow's edge that moves down a wall. Shading changed where the "
      "reference differs by more than a tenth from the frame before, along the motion.");
}

}  // namespace reprise::lab::cpst
