// SPDX-License-Identifier: MIT
//
// Figure 1: close-ups of every technique beside the reference.
#include <fmt/format.h>

#include "lab/paper/amortized/experiments.h"
#include "lab/paper/amortized/subjects.h"
#include "lab/paper/crop.h"

namespace reprise::lab::amortized {
namespace {

constexpr uint32_t kCrop_px = 72;

}  // namespace

void figure1(PaperLab& lab, Outcome& outcome) {
  for (const Subject* subject : {&horse(), &brick(), &indoor()}) {
    if (!sceneIsHere(subject->scene)) {
      outcome.lacks("scene " + subject->scene);
      continue;
    }
    const std::string& run = subject->moving;
    const PaperView view = subject->view();
    const std::string ours = amortizedFor(lab, *subject);
    const std::string reprojection = bestReprojection(lab, run, view);
    PaperScene& scene = lab.scene(run, view);
    const FloatImage& reference = scene.reference(scene.frames() - 1);
    const CropBox box = worstSquare(reference, lab.measure(run, "none", view).last, kCrop_px);
    std::vector<std::pair<std::string, FloatImage>> crops;
    for (const auto& [label, technique] :
         std::vector<std::pair<std::string, std::string>>{{"no AA", "none"},
                                                          {"jittered reprojection", reprojection},
                                                          {"4x4", "ss:n=4"},
                                                          {"amortized", ours}}) {
      const Measured& measured = lab.measure(run, technique, view);
      crops.emplace_back(fmt::format("{}: {:.2f} dB", label, measured.psnr_db.back()),
                         crop(measured.last, box));
    }
    crops.emplace_back("reference", crop(reference, box));
    outcome.gallery(run + ", last frame, where no antialiasing is worst", crops);
    outcome.gallery(run + ", the frame",
                    {{"amortized", lab.measure(run, ours, view).last}, {"reference", reference}});
    outcome.report(run + " last frame, amortized", std::nullopt,
                   lab.measure(run, ours, view).psnr_db.back(), "dB");
  }
}

}  // namespace reprise::lab::amortized
