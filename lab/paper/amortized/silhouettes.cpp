// SPDX-License-Identifier: MIT
//
// Future work of the paper: silhouettes, by a jittered projection, judged by the whole pixel.
#include <fmt/format.h>

#include "lab/paper/amortized/experiments.h"
#include "lab/paper/amortized/subjects.h"
#include "lab/paper/crop.h"

namespace reprise::lab::amortized {
namespace {

constexpr uint32_t kCrop_px = 72;
constexpr PaperView kWholePixel{.judged = Judged::kPixel};

void wholePixel(PaperLab& lab, const Subject& subject, Outcome& outcome) {
  const std::vector<std::string> techniques = {"none", "ss:n=4", "taa", "amortized",
                                               "amortized:samples=frame"};
  std::vector<std::vector<std::string>> lines;
  std::vector<double> moving_db;
  for (const std::string& technique : techniques) {
    moving_db.push_back(movingPsnr(lab, subject.moving, technique, kWholePixel));
    lines.push_back({technique, fmt::format("{:.2f}", moving_db.back())});
    outcome.report(fmt::format("{} moving, {}", subject.scene, technique), std::nullopt,
                   moving_db.back(), "dB");
  }
  PaperScene& scene = lab.scene(subject.moving, kWholePixel);
  const FloatImage& reference = scene.reference(scene.frames() - 1);
  const CropBox box =
      worstSquare(reference, lab.measure(subject.moving, "amortized", kWholePixel).last, kCrop_px);
  std::vector<std::pair<std::string, FloatImage>> crops;
  for (const std::string& technique : techniques) {
    crops.emplace_back(technique,
                       crop(lab.measure(subject.moving, technique, kWholePixel).last, box));
  }
  crops.emplace_back("reference", crop(reference, box));
  outcome.gallery(subject.moving + ", where shading alone is worst", crops);
  for (size_t i = 0; i < techniques.size(); ++i) {
    const double still_db = stillPsnr(lab, subject.still, techniques[i], kWholePixel);
    lines[i].push_back(fmt::format("{:.2f}", still_db));
    outcome.report(fmt::format("{} still, {}", subject.scene, techniques[i]), std::nullopt,
                   still_db, "dB");
  }
  outcome.table(subject.scene + " against the whole pixel's reference",
                {"technique", "moving, dB", "still, dB"}, lines);
  outcome.claim(subject.scene + " moving, silhouettes over shading alone", std::nullopt,
                moving_db[4] - moving_db[3], "dB", "not below", moving_db[4] >= moving_db[3]);
  outcome.claim(subject.scene + " moving, silhouettes over taa", std::nullopt,
                moving_db[4] - moving_db[2], "dB", "above", moving_db[4] > moving_db[2]);
}

}  // namespace

void silhouettes(PaperLab& lab, Outcome& outcome) {
  for (const Subject* subject : {&horse(), &brick(), &indoor()}) {
    if (subject == &indoor() && !lab.scale().whole) {
      outcome.note("indoor: with --full");
    } else if (sceneIsHere(subject->scene)) {
      wholePixel(lab, *subject, outcome);
    } else {
      outcome.lacks("scene " + subject->scene);
    }
  }
}

}  // namespace reprise::lab::amortized
