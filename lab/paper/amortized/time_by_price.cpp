// SPDX-License-Identifier: MIT
//
// Figure 14 claims its speed for shaders that dominate a frame. Ours are as cheap as the scenes
// are; lamps scattered over a scene (scattered_lamps.h) make the same surfaces dearer to shade.
#include <fmt/format.h>

#include "lab/paper/amortized/experiments.h"
#include "lab/paper/amortized/subjects.h"
#include "lab/paper/cold_programs.h"
#include "lab/run/progress.h"

namespace reprise::lab::amortized {
namespace {

constexpr uint32_t kLamps[] = {0, 32, 128, 512};
// The second half is timed, with histories filled.
constexpr uint32_t kFrames = 16;
constexpr double kTimesFaster = 5.0;

struct Point {
  uint32_t lamps;
  double evaluation_ms;  // of every pixel once
  FrameTimes ss4, ours;

  double evaluations() const { return ours.shade_ms / evaluation_ms; }
  double faster() const { return ss4.shadedMs() / ours.shadedMs(); }
};

Point pointOf(PaperLab& lab, const Subject& subject, uint32_t lamps) {
  const auto device = lab.openDevice();
  SceneSourceOptions options;
  options.extent = lab.scale().extent;
  options.frames = kFrames;
  options.switches.shading_only = true;
  options.switches.lamps = lamps;
  options.reference.cache = "none";
  SceneSource source(*device, parseSceneRun(subject.moving), options);
  std::vector<std::unique_ptr<Resolver>> resolvers;
  for (const std::string& technique : {std::string("ss:n=4"), amortizedWith(0.0)}) {
    resolvers.push_back(
        std::make_unique<Resolver>(*device, parseTechnique(technique), source.info()));
  }
  Progress progress(fmt::format("{} under {} lamps", subject.moving, lamps), kFrames, lab.quiet());
  const std::vector<SequenceRun> runs =
      runTogether(*device, source, resolvers, kFrames, [&] { progress.step(); });
  lab.keepValidation(*device);
  Point point{lamps, 0.0, timesOf(runs[0], kFrames / 2), timesOf(runs[1], kFrames / 2)};
  point.evaluation_ms = point.ss4.shade_ms / runs[0].evaluations_per_pixel;
  return point;
}

}  // namespace

void timeByPrice(PaperLab& lab, Outcome& outcome) {
  std::vector<Series> series;
  double dearest_ms = 0.0;
  for (const Subject* subject : {&horse(), &brick()}) {
    if (!sceneIsHere(subject->scene)) {
      outcome.lacks("scene " + subject->scene);
      continue;
    }
    Series measured{subject->scene, {}, {}, false};
    std::vector<std::vector<std::string>> lines;
    for (const uint32_t lamps : kLamps) {
      const Point point = pointOf(lab, *subject, lamps);
      dearest_ms = std::max(dearest_ms, point.evaluation_ms);
      measured.x.push_back(point.evaluation_ms);
      measured.y.push_back(point.faster());
      // 16 p = 5 (e p + r): the price at which it would be five times with this resolve.
      const double five_at_ms =
          kTimesFaster * point.ours.resolve_ms / (16.0 - kTimesFaster * point.evaluations());
      lines.push_back(
          {fmt::format("{}", lamps), fmt::format("{:.2f}", point.evaluation_ms),
           fmt::format("{:.1f}", point.ss4.shadedMs()), fmt::format("{:.1f}", point.ours.shade_ms),
           fmt::format("{:.1f}", point.ours.resolve_ms), fmt::format("{:.2f}", point.evaluations()),
           fmt::format("{:.2f}", point.faster()), fmt::format("{:.1f}", five_at_ms)});
      const std::string row = fmt::format(
          "{} under {} lamps, time of 4x4 over amortized, without geometry", subject->scene, lamps);
      if (point.evaluation_ms > point.ours.resolve_ms) {
        outcome.claim(
            row, std::nullopt, point.faster(), "times",
            fmt::format("at least {}: an evaluation takes longer than request and resolve",
                        kTimesFaster),
            point.faster() >= kTimesFaster);
      } else {
        outcome.report(row, std::nullopt, point.faster(), "times");
      }
    }
    outcome.table(subject->scene + ", ms a frame",
                  {"lamps", "one evaluation of every pixel", "4x4", "amortized: shading",
                   "request and resolve", "as evaluations", "times faster",
                   "five times from an evaluation of"},
                  lines);
    series.push_back(measured);
  }
  series.push_back({"five times", {0.0, dearest_ms}, {kTimesFaster, kTimesFaster}, false});
  outcome.linePlot({"Time of 4x4 over amortized, without geometry",
                    "one evaluation of every pixel, ms", "times"},
                   series);
  noteColdPrograms(lab, outcome);
  outcome.note(
      "The scenes' own lights, and lamps scattered over them, culled by tiles. 4x4 and amortized "
      "in "
      "turn, frame by frame; medians of a frame. Lamps change neither requests nor resolve.");
}

}  // namespace reprise::lab::amortized
