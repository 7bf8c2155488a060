// SPDX-License-Identifier: MIT
//
// Figure 2: last frames, and insets of all methods at the same places: where UE4-TAA is farthest
// from the reference, which is where it ghosts, and where no antialiasing is.
#include <fmt/format.h>

#include "lab/paper/crop.h"
#include "lab/paper/phlm/experiments.h"
#include "lab/paper/phlm/sequences.h"

namespace reprise::lab::phlm {
namespace {

constexpr uint32_t kInset_px = 56;

void insetsOf(PaperLab& lab, const Sequence& sequence, Outcome& outcome) {
  PaperScene& scene = lab.scene(sequence.run, view());
  const FloatImage& reference = scene.reference(scene.frames() - 1);
  const auto last = [&](const std::string& technique) -> const Measured& {
    return lab.measure(sequence.run, technique, view());
  };
  for (const auto& [what, technique] :
       {std::pair<std::string, std::string>{"where UE4-TAA is worst", "ue4-taa"},
        {"where no antialiasing is worst", "none"}}) {
    const CropBox box = worstSquare(reference, last(technique).last, kInset_px);
    std::vector<std::pair<std::string, FloatImage>> insets;
    for (const Contender& contender : contenders()) {
      const Measured& measured = last(contender.technique);
      insets.emplace_back(fmt::format("{}: {:.2f} dB", contender.name, measured.psnr_db.back()),
                          crop(measured.last, box));
    }
    insets.emplace_back("reference", crop(reference, box));
    outcome.gallery(fmt::format("{}, last frame, {}; dB of the whole frame", sequence.run, what),
                    insets);
  }
  outcome.gallery(
      sequence.run + ", the frame",
      {{"UE4-TAA", last("ue4-taa").last}, {"PHLM", last("phlm").last}, {"reference", reference}});
  const OverTime& ours = last("phlm").over_time;
  const OverTime& ue4 = last("ue4-taa").over_time;
  outcome.linePlot({sequence.run + ": error after disocclusion", "frames in view", "PSNR, dB"},
                   {{"PHLM", ours.ages, ours.age_psnr_db, false},
                    {"UE4-TAA", ue4.ages, ue4.age_psnr_db, false}});
  for (size_t i = 0; i < std::min(ours.ages.size(), ue4.ages.size()); ++i) {
    outcome.report(
        fmt::format("{}, {:.0f} frames in view, PHLM over UE4-TAA", sequence.scene, ours.ages[i]),
        std::nullopt, ours.age_psnr_db[i] - ue4.age_psnr_db[i], "dB");
  }
}

}  // namespace

void figure2(PaperLab& lab, Outcome& outcome) {
  insetsOf(lab, openWorld(), outcome);
  insetsOf(lab, spaceLand(), outcome);
}

}  // namespace reprise::lab::phlm
