// SPDX-License-Identifier: MIT
//
// Figure 14: quality moving and still, and cost, of everything compared.
#include <fmt/format.h>

#include "lab/paper/amortized/experiments.h"
#include "lab/paper/amortized/subjects.h"

namespace reprise::lab::amortized {
namespace {

// What is asked for beyond "above": the paper's margins were 6.4 to 7.8 dB over reprojection in
// motion, 14.5 dB over 4x4 on the still horse, and 5 to 10 times the speed of 4x4.
constexpr double kOverReprojection_db = 4.0;
constexpr double kStillOverSs4_db = 8.0;
constexpr double kTimesFaster = 5.0;

std::string decibels(std::optional<double> published, double measured) {
  return published ? fmt::format("{:.2f} / {:.2f}", *published, measured)
                   : fmt::format("- / {:.2f}", measured);
}

struct TableLine {
  std::string name;
  std::string technique;
  double moving_db, published_moving_db;
  double still_db;
  std::optional<double> published_still_db;
  double published_fps;  // 0: not printed here
};

void tableOf(PaperLab& lab, const Subject& subject, Outcome& outcome) {
  const PublishedFigures& p = *subject.published;
  const PaperView view = subject.view();
  const std::string reprojection = bestReprojection(lab, subject.moving, view);
  const std::string ours = amortizedFor(lab, subject);
  std::vector<TableLine> lines = {
      {"no AA", "none", 0, p.none_db, 0, std::nullopt, p.none_fps},
      {"2x2", "ss:n=2", 0, p.ss2_db, 0, std::nullopt, 0},
      {"3x3", "ss:n=3", 0, p.ss3_db, 0, std::nullopt, 0},
      {"4x4", "ss:n=4", 0, p.ss4_db, 0, std::nullopt, p.ss4_fps},
      {"jittered reprojection", reprojection, 0, p.reprojection_moving_db, 0,
       p.reprojection_still_db, p.reprojection_fps},
      {"amortized", ours, 0, p.amortized_moving_db, 0, p.amortized_still_db, p.amortized_fps}};
  for (TableLine& line : lines)
    line.moving_db = movingPsnr(lab, subject.moving, line.technique, view);
  std::vector<std::string> techniques;
  for (const TableLine& line : lines) techniques.push_back(line.technique);
  // While the moving scene is open.
  const std::vector<FrameTimes> times = lab.timesTogether(subject.moving, techniques, view);
  for (TableLine& line : lines) line.still_db = stillPsnr(lab, subject.still, line.technique);
  const TableLine& ss4 = lines[3];
  const TableLine& reproj = lines[4];
  const TableLine& amortized = lines[5];
  const std::string& name = subject.scene;

  const FrameTimes& ss4_times = times[3];
  const FrameTimes& our_times = times[5];
  std::vector<std::vector<std::string>> cells;
  for (size_t i = 0; i < lines.size(); ++i) {
    const TableLine& line = lines[i];
    const Measured& moving = lab.measure(subject.moving, line.technique, view);
    const std::string published_ratio =
        line.published_fps > 0.0 ? fmt::format("{:.1f}", line.published_fps / p.ss4_fps) : "-";
    cells.push_back(
        {line.name, line.technique, decibels(line.published_moving_db, line.moving_db),
         decibels(line.published_still_db, line.still_db),
         fmt::format("{} / {:.1f}", published_ratio, ss4_times.frameMs() / times[i].frameMs()),
         fmt::format("{:.2f}", moving.evaluations_per_pixel),
         fmt::format("{:.2f}", times[i].render_ms), fmt::format("{:.2f}", times[i].resolve_ms)});
  }
  outcome.table(name + ": published / measured",
                {"technique", "as", "moving, dB", "still, dB", "times faster than 4x4",
                 "shadings/px", "render ms", "resolve ms"},
                cells);

  for (size_t i = 0; i < 4; ++i) {
    outcome.report(name + " " + lines[i].name, lines[i].published_moving_db, lines[i].moving_db,
                   "dB");
  }
  outcome.report(name + " jittered reprojection moving", reproj.published_moving_db,
                 reproj.moving_db, "dB");
  outcome.report(name + " jittered reprojection still", reproj.published_still_db, reproj.still_db,
                 "dB");
  outcome.claim(name + " moving", amortized.published_moving_db, amortized.moving_db, "dB",
                "above 4x4", amortized.moving_db > ss4.moving_db);
  const double margin_db = amortized.moving_db - reproj.moving_db;
  outcome.claim(name + " moving, over jittered reprojection",
                p.amortized_moving_db - p.reprojection_moving_db, margin_db, "dB",
                fmt::format("at least {} dB", kOverReprojection_db),
                margin_db >= kOverReprojection_db);
  outcome.claim(name + " still", amortized.published_still_db, amortized.still_db, "dB",
                "above 4x4", amortized.still_db > ss4.still_db);
  const double still_margin_db = amortized.still_db - ss4.still_db;
  // Asked of the horse, whose margin in the paper is 14.5 dB; the others' are 5.1 and 5.4.
  const double least_db = &subject == &horse() ? kStillOverSs4_db : 0.0;
  outcome.claim(name + " still, over 4x4", p.amortized_still_db - p.ss4_db, still_margin_db, "dB",
                fmt::format("at least {} dB", least_db), still_margin_db >= least_db);
  const Measured& of_ss4 = lab.measure(subject.moving, ss4.technique, view);
  const Measured& of_ours = lab.measure(subject.moving, ours, view);
  outcome.report(name + " time of 4x4 over amortized, whole frame", p.amortized_fps / p.ss4_fps,
                 ss4_times.frameMs() / our_times.frameMs(), "times");
  const double faster = ss4_times.shadedMs() / our_times.shadedMs();
  const double one_sample_ms = ss4_times.shade_ms / of_ss4.evaluations_per_pixel;
  const std::string ratio = name + " time of 4x4 over amortized, without geometry";
  outcome.claim(ratio, p.amortized_fps / p.ss4_fps, faster, "times",
                fmt::format("at least {}", kTimesFaster), faster >= kTimesFaster);
  if (one_sample_ms <= our_times.resolve_ms) {
    outcome.note(fmt::format(
        "{}: here the shader does not dominate: one evaluation a pixel takes {:.1f} ms, the "
        "resolve {:.1f} ms. Where it does, evaluations decide: {:.1f} times fewer.",
        name, one_sample_ms, our_times.resolve_ms,
        of_ss4.evaluations_per_pixel / of_ours.evaluations_per_pixel));
  }
  std::string chained = ours;
  chained.replace(chained.find("exact"), 5, "chained");
  outcome.report(name + " moving, motion chained from frame to frame", std::nullopt,
                 movingPsnr(lab, subject.moving, chained, view), "dB");
  outcome.report(name + " shading evaluations a pixel, amortized", std::nullopt,
                 of_ours.evaluations_per_pixel, "");
}

}  // namespace

void figure14(PaperLab& lab, Outcome& outcome) {
  for (const Subject* subject : {&horse(), &brick(), &indoor()}) {
    if (sceneIsHere(subject->scene)) {
      tableOf(lab, *subject, outcome);
    } else {
      outcome.lacks("scene " + subject->scene);
    }
  }
  outcome.note(
      "Moving: mean over the judged frames from the sixteenth on; still: over the last quarter of "
      "the frames, with nothing deferred. Jittered reprojection has the constant alpha of the best "
      "PSNR in "
      "motion, as the paper chose it; residual tolerances likewise. Times are medians of a frame; "
      "without geometry: shading and resolve alone.");
}

}  // namespace reprise::lab::amortized
