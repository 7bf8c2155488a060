// SPDX-License-Identifier: MIT
//
// Column "PS invocations" of table 1 at its own size, whatever the run's: counts alone, of a few
// frames.
#include <fmt/format.h>

#include <cmath>
#include <numeric>

#include "lab/paper/cpst/experiments.h"
#include "lab/paper/cpst/subjects.h"

namespace reprise::lab::cpst {
namespace {

constexpr VkExtent2D kPublishedExtent{1920, 1080};
constexpr uint32_t kFrames = 2;
// What is asked of Sponza; published: 0.333.
constexpr double kMostOfSponza = 0.34;
constexpr double kMostOfCbr = 0.70;

double sumOf(const std::vector<uint64_t>& counts) {
  return static_cast<double>(std::accumulate(counts.begin(), counts.end(), uint64_t{0}));
}

double share(double evaluations) {
  return evaluations / (static_cast<double>(kPublishedExtent.width) * kPublishedExtent.height);
}

}  // namespace

void evaluations(PaperLab& lab, Outcome& outcome) {
  // A test's run is as small as it asks; every other one counts at the published size.
  const bool tiny = lab.scale().extent.width < 256;
  const VkExtent2D extent = tiny ? lab.scale().extent : kPublishedExtent;
  for (const Subject& subject : subjects()) {
    if (!subject.note.empty()) outcome.note(subject.note);
    BareScene scene(lab, subject.run, extent, kFrames, 0);
    const double ps = sumOf(scene.evaluations("none"));
    const double cbr = sumOf(scene.evaluations(kCbr)) / ps;
    const double ours = sumOf(scene.evaluations(kCpst)) / ps;
    outcome.claim(subject.name + ", CBR", share(subject.cbr.evaluations), cbr, "of PS", "half",
                  std::abs(cbr - 0.5) < 0.01);
    const bool asked = &subject == &sponza();
    if (asked) {
      outcome.claim(subject.name + ", CPS-T", share(subject.cpst.evaluations), ours, "of PS",
                    fmt::format("at most {}", kMostOfSponza), ours <= kMostOfSponza);
      outcome.claim(subject.name + ", CPS-T over CBR",
                    subject.cpst.evaluations / subject.cbr.evaluations, ours / cbr, "times",
                    fmt::format("at most {}", kMostOfCbr), ours / cbr <= kMostOfCbr);
    } else {
      outcome.report(subject.name + ", CPS-T", share(subject.cpst.evaluations), ours, "of PS");
      outcome.report(subject.name + ", CPS-T over CBR",
                     subject.cpst.evaluations / subject.cbr.evaluations, ours / cbr, "times");
    }
  }
  outcome.note(
      fmt::format("Counted at {} x {}: the share depends on the size of triangles in "
                  "pixels. Pixels of the sky, which cost nothing, are not counted.",
                  extent.width, extent.height));
}

}  // namespace reprise::lab::cpst
