// SPDX-License-Identifier: MIT
//
// Figure 9: evaluations of each frame along a camera's path, as a share of PS.
#include <fmt/format.h>

#include <algorithm>

#include "lab/paper/cpst/experiments.h"
#include "lab/paper/cpst/subjects.h"

namespace reprise::lab::cpst {
namespace {

// Frames along the path, evenly; frame rate that spreads them over it.
constexpr uint32_t kFrames = 6;
constexpr double kPathLength_s = 12.0;

}  // namespace

void figure9(PaperLab& lab, Outcome& outcome) {
  const VkExtent2D extent = timedExtent(lab);
  const uint32_t frames = lab.scale().whole ? 20 * kFrames : std::min(kFrames, lab.scale().frames);
  for (const Subject& subject : subjects()) {
    if (!subject.note.empty()) outcome.note(subject.note);
    BareScene scene(lab, subject.run, extent, frames, 0, frames / kPathLength_s);
    std::vector<double> time_s;
    std::vector<Series> series;
    const std::vector<std::vector<uint64_t>> counts = {
        scene.evaluations("none"), scene.evaluations(kCbr), scene.evaluations(kCpst)};
    for (uint32_t i = 0; i < frames; ++i) time_s.push_back(i * kPathLength_s / frames);
    double most = 0.0;
    double least = 1.0;
    bool below = true;
    for (const size_t which : {1u, 2u}) {
      std::vector<double> share;
      for (uint32_t i = 0; i < frames; ++i)
        share.push_back(static_cast<double>(counts[which][i]) / static_cast<double>(counts[0][i]));
      if (which == 2) {
        most = *std::max_element(share.begin(), share.end());
        least = *std::min_element(share.begin(), share.end());
      }
      series.push_back({timed()[which].name, time_s, share, false});
    }
    for (uint32_t i = 0; i < frames; ++i) below = below && counts[2][i] < counts[1][i];
    outcome.linePlot({subject.name + " (" + subject.run + ")", "seconds along the path",
                      "evaluations, share of PS"},
                     series);
    outcome.report(subject.name + ", CPS-T, least", std::nullopt, least, "of PS");
    outcome.claim(subject.name + ", CPS-T, most", std::nullopt, most, "of PS",
                  "in every frame below CBR", below);
  }
  outcome.note(
      fmt::format("Counted at {} x {}; published at 1920 x 1080, where triangles have more "
                  "pixels.",
                  extent.width, extent.height));
}

}  // namespace reprise::lab::cpst
