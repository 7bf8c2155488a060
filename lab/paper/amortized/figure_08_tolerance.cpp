// SPDX-License-Identifier: MIT
//
// Figure 8: the blur tolerance. Too small aliases, too large blurs.
#include <fmt/format.h>

#include "lab/paper/amortized/experiments.h"
#include "lab/paper/amortized/subjects.h"
#include "lab/paper/crop.h"

namespace reprise::lab::amortized {
namespace {

// The smallest is hardly above the variance of the samples themselves, the largest is the table's.
constexpr double kTolerances_px2[] = {0.08, 0.15, 0.25, 0.5, 1.0, 2.0, 4.0};
constexpr double kPublishedSmall_db = 28.16;
constexpr double kPublishedGood_db = 30.54;
constexpr double kPublishedLarge_db = 23.65;
constexpr uint32_t kCrop_px = 64;

struct Sweep {
  std::vector<double> db;
  size_t best = 0;
};

Sweep sweep(PaperLab& lab, const std::string& run) {
  Sweep found;
  for (const double tolerance : kTolerances_px2) {
    found.db.push_back(movingPsnr(lab, run, fmt::format("amortized:blur={}", tolerance)));
    if (found.db.back() > found.db[found.best]) found.best = found.db.size() - 1;
  }
  return found;
}

void showCrops(PaperLab& lab, const std::string& run, const Sweep& found, Outcome& outcome) {
  const auto last = [&](size_t i) -> const FloatImage& {
    return lab.measure(run, fmt::format("amortized:blur={}", kTolerances_px2[i])).last;
  };
  PaperScene& scene = lab.scene(run);
  const FloatImage& reference = scene.reference(scene.frames() - 1);
  const CropBox box = worstSquare(reference, last(std::size(kTolerances_px2) - 1), kCrop_px);
  outcome.gallery(
      run + ": small, best and large tolerance, reference",
      {{fmt::format("tau_b {}", kTolerances_px2[0]), crop(last(0), box)},
       {fmt::format("tau_b {}", kTolerances_px2[found.best]), crop(last(found.best), box)},
       {fmt::format("tau_b {}", kTolerances_px2[std::size(kTolerances_px2) - 1]),
        crop(last(std::size(kTolerances_px2) - 1), box)},
       {"reference", crop(reference, box)}});
}

}  // namespace

void figure8(PaperLab& lab, Outcome& outcome) {
  std::vector<Series> series;
  const auto run = [&](const std::string& name, bool published) {
    const Sweep found = sweep(lab, name);
    const auto number = [&](double value) {
      return published ? std::optional<double>(value) : std::nullopt;
    };
    const double best_db = found.db[found.best];
    outcome.claim(name + " small tau_b", number(kPublishedSmall_db), found.db.front(), "dB",
                  "below the best", found.db.front() < best_db);
    outcome.report(fmt::format("{} best tau_b ({} px^2)", name, kTolerances_px2[found.best]),
                   number(kPublishedGood_db), best_db, "dB");
    outcome.claim(name + " large tau_b", number(kPublishedLarge_db), found.db.back(), "dB",
                  "below the best", found.db.back() < best_db);
    series.push_back(
        {name, {std::begin(kTolerances_px2), std::end(kTolerances_px2)}, found.db, false});
    showCrops(lab, name, found, outcome);
  };
  if (sceneIsHere("horse")) {
    run("horse/gallop", true);
  } else {
    outcome.lacks("scene horse");
  }
  for (const char* name : {"brick/pan", "brick/rotate", "brick/zoom"}) run(name, false);
  outcome.linePlot({"PSNR over the blur tolerance", "tau_b, px^2", "dB"}, series);
}

}  // namespace reprise::lab::amortized
