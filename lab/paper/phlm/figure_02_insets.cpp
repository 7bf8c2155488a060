// SPDX-License-Identifier: MIT
//
// Figure 2: last frames, and insets of all methods at the same places: where something was
// uncovered lately and UE4-TAA ghosts, where PHLM does worse there, and where no antialiasing is
// farthest from the reference.
#include <fmt/format.h>

#include "lab/paper/crop.h"
#include "lab/paper/phlm/experiments.h"
#include "lab/paper/phlm/sequences.h"

namespace reprise::lab::phlm {
namespace {

constexpr uint32_t kInset_px = 56;

// By how much the squared error of `test` is above that of `other` in the last frame, where
// something in front has moved away in the last kRecoveryFrames frames; 0 elsewhere.
FloatImage ghostsBeyond(const PaperScene& scene, const FloatImage& test, const FloatImage& other) {
  const FloatImage& reference = scene.reference(scene.frames() - 1);
  const Ages& ages = scene.truth().frames.back().ages;
  FloatImage beyond = squaredError(reference, test);
  const FloatImage other_error = squaredError(reference, other);
  for (size_t i = 0; i < ages.size(); ++i) {
    const bool uncovered = ages[i] >= 1 && ages[i] <= kRecoveryFrames;
    beyond.texels[i] = uncovered ? beyond.texels[i] - other_error.texels[i] : 0.0f;
  }
  return beyond;
}

void insetsOf(PaperLab& lab, const Sequence& sequence, Outcome& outcome) {
  PaperScene& scene = lab.scene(sequence.run, view());
  const FloatImage& reference = scene.reference(scene.frames() - 1);
  const auto last = [&](const std::string& technique) -> const Measured& {
    return lab.measure(sequence.run, technique, view());
  };
  const FloatImage ue4_beyond_phlm = ghostsBeyond(scene, last("ue4-taa").last, last("phlm").last);
  const FloatImage phlm_beyond_ue4 = ghostsBeyond(scene, last("phlm").last, last("ue4-taa").last);
  const std::string uncovered = fmt::format("uncovered up to {} frames ago, ", kRecoveryFrames);
  for (const auto& [what, box] :
       {std::pair<std::string, CropBox>{uncovered + "UE4-TAA's error most above PHLM's",
                                        heaviestSquare(ue4_beyond_phlm, kInset_px)},
        {uncovered + "PHLM's error most above UE4-TAA's",
         heaviestSquare(phlm_beyond_ue4, kInset_px)},
        {"no antialiasing's error largest",
         worstSquare(reference, last("none").last, kInset_px)}}) {
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
