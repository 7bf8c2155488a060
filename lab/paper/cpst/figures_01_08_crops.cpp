// SPDX-License-Identifier: MIT
//
// Figures 1 and 8: the same places in the last frame of every method, where CPS and where CBR is
// farthest from the reference.
#include <fmt/format.h>

#include "lab/paper/cpst/experiments.h"
#include "lab/paper/cpst/subjects.h"
#include "lab/paper/crop.h"

namespace reprise::lab::cpst {
namespace {

constexpr uint32_t kCrop_px = 56;

void cropsOf(PaperLab& lab, const Subject& subject, Outcome& outcome) {
  if (!subject.note.empty()) outcome.note(subject.note);
  const std::string& run = subject.run;
  PaperScene& scene = lab.scene(run, view());
  const FloatImage reference = scene.reference(scene.frames() - 1);
  for (const Contender& worst : {judged()[1], judged()[2]}) {
    const CropBox box =
        worstSquare(reference, lab.measure(run, worst.technique, view()).last, kCrop_px);
    std::vector<std::pair<std::string, FloatImage>> crops;
    for (const Contender& contender : judged()) {
      const Measured& measured = lab.measure(run, contender.technique, view());
      crops.emplace_back(fmt::format("{}: {:.2f} dB", contender.name, measured.psnr_db.back()),
                         crop(measured.last, box));
    }
    crops.emplace_back("reference", crop(reference, box));
    outcome.gallery(fmt::format("{}, last frame, where {} is worst; dB of the whole frame",
                                subject.name, worst.name),
                    crops);
  }
  outcome.gallery(subject.name + ", the frame", {{"PS", lab.measure(run, kPs, view()).last},
                                                 {"CPS", lab.measure(run, kCps, view()).last},
                                                 {"CPS-T", lab.measure(run, kCpst, view()).last},
                                                 {"CBR", lab.measure(run, kCbr, view()).last},
                                                 {"reference", reference}});
  outcome.report(subject.name + ", last frame, CPS-T", std::nullopt,
                 lab.measure(run, kCpst, view()).psnr_db.back(), "dB");
}

}  // namespace

void figure1(PaperLab& lab, Outcome& outcome) {
  cropsOf(lab, bistro(), outcome);
}

void figure8(PaperLab& lab, Outcome& outcome) {
  cropsOf(lab, sponza(), outcome);
  cropsOf(lab, sanMiguel(), outcome);
}

}  // namespace reprise::lab::cpst
