// SPDX-License-Identifier: MIT
//
// Table 1: where a frame's time goes, and how often it shades.
#include <fmt/format.h>

#include "lab/paper/cold_programs.h"
#include "lab/paper/cpst/experiments.h"
#include "lab/paper/cpst/subjects.h"

namespace reprise::lab::cpst {
namespace {

// What was asked of it: a resolve may take this much of that of `taa` with variance clipping.
constexpr double kMostOfTaa = 1.3;

}  // namespace

void table1(PaperLab& lab, Outcome& outcome) {
  const VkExtent2D extent = timedExtent(lab);
  for (const Subject& subject : subjects()) {
    if (!subject.note.empty()) outcome.note(subject.note);
    BareScene scene(lab, subject.run, extent, timedFrames(lab), subject.lamps);
    const std::vector<SequenceRun> runs = scene.timedRuns();
    const Cost ps = costOf(runs[0]);
    const Cost cbr = costOf(runs[1]);
    const Cost ours = costOf(runs[2]);
    std::vector<std::vector<std::string>> lines;
    struct Row {
      const char* name;
      const Cost& cost;
      const PublishedCost& published;
    };
    const double pixels = static_cast<double>(extent.width) * extent.height;
    for (const Row& row : {Row{"PS", ps, subject.ps}, Row{"CBR", cbr, subject.cbr},
                           Row{"CPS-T", ours, subject.cpst}}) {
      const auto pair = [](double published, double measured) {
        return fmt::format("{:.2f} / {:.1f}", published, measured);
      };
      lines.push_back({row.name, pair(row.published.visibility_ms, row.cost.visibility_ms),
                       pair(row.published.lighting_ms, row.cost.lighting_ms),
                       pair(row.published.resolve_ms, row.cost.resolve_ms),
                       pair(row.published.total_ms, row.cost.total_ms),
                       fmt::format("{:.0f} / {:.0f}", row.published.evaluations,
                                   row.cost.evaluations_per_pixel * pixels)});
      outcome.report(fmt::format("{}, {}, lighting over PS", subject.name, row.name),
                     row.published.lighting_ms / subject.ps.lighting_ms,
                     row.cost.lighting_ms / ps.lighting_ms, "times");
      outcome.report(fmt::format("{}, {}, frame over PS", subject.name, row.name),
                     row.published.total_ms / subject.ps.total_ms, row.cost.total_ms / ps.total_ms,
                     "times");
    }
    outcome.table(fmt::format("{} ({}, {} lamps), published / measured, ms", subject.name,
                              subject.run, subject.lamps),
                  {"", "visibility", "lighting", "resolve", "frame", "evaluations"}, lines);
    outcome.claim(subject.name + ", CPS-T, resolve over PS with TAA",
                  subject.cpst.resolve_ms / subject.ps.resolve_ms, ours.resolve_ms / ps.resolve_ms,
                  "times", fmt::format("at most {}", kMostOfTaa),
                  ours.resolve_ms <= kMostOfTaa * ps.resolve_ms);
  }
  noteColdPrograms(lab, outcome);
  outcome.note(fmt::format(
      "Published: 1920 x 1080 on a GTX 1080; here {} x {} on {}. Visibility: depth and triangle of "
      "every pixel at full rate, the same for all; lighting: shading and the lights of each tile.",
      extent.width, extent.height, lab.openDevice()->name()));
}

}  // namespace reprise::lab::cpst
