// SPDX-License-Identifier: MIT
//
// Figure 10: the residual tolerance, on bump-mapped highlights under moving lights. Too small
// aliases, too large lags.
#include <fmt/format.h>

#include "lab/paper/amortized/experiments.h"
#include "lab/paper/amortized/subjects.h"
#include "lab/paper/crop.h"

namespace reprise::lab::amortized {
namespace {

constexpr uint32_t kCrop_px = 72;
constexpr float kGain = 4.0f;

void residualSweep(PaperLab& lab, const std::string& run, const PaperView& view, Outcome& outcome) {
  Series series{run, {}, {}, false};
  std::vector<double> db;
  size_t best = 0;
  for (const double tolerance : residualTolerances()) {
    db.push_back(movingPsnr(lab, run, amortizedWith(tolerance), view));
    if (tolerance > 0.0) {
      series.x.push_back(tolerance);
      series.y.push_back(db.back());
    }
    if (db.back() > db[best]) best = db.size() - 1;
    outcome.report(tolerance > 0.0 ? fmt::format("{} at tau_eps {}", run, tolerance)
                                   : run + " without the bound",
                   std::nullopt, db.back(), "dB");
  }
  outcome.claim(run + " at the best tau_eps", std::nullopt, db[best], "dB",
                "above the smallest and above none", db[best] > db.front() && db[best] > db.back());
  outcome.linePlot({.title = "PSNR over the residual tolerance",
                    .x = "tau_eps, luminance",
                    .y = "dB",
                    .log_x = true},
                   {series});

  PaperScene& scene = lab.scene(run, view);
  const FloatImage& reference = scene.reference(scene.frames() - 1);
  const size_t last = residualTolerances().size() - 1;
  const FloatImage& lagging =
      lab.measure(run, amortizedWith(residualTolerances()[last]), view).last;
  const CropBox box = worstSquare(reference, lagging, kCrop_px);
  std::vector<std::pair<std::string, FloatImage>> crops;
  std::vector<std::pair<std::string, FloatImage>> differences;
  for (const size_t i : {size_t{0}, best, last}) {
    const double tolerance = residualTolerances()[i];
    const std::string label =
        tolerance > 0.0 ? fmt::format("tau_eps {}", tolerance) : std::string("no bound");
    const FloatImage& image = lab.measure(run, amortizedWith(tolerance), view).last;
    crops.emplace_back(label, crop(image, box));
    differences.emplace_back(label, differenceImage(image, reference, kGain));
  }
  crops.emplace_back("reference", crop(reference, box));
  outcome.gallery(run + ": small, best, none, reference", crops);
  outcome.gallery(fmt::format("{}: |difference| x {}", run, kGain), differences);
}

}  // namespace

void figure10(PaperLab& lab, Outcome& outcome) {
  if (sceneIsHere(teapot().scene)) {
    // Only the lights move: what lags is shading alone.
    residualSweep(lab, "teapot/lights", {}, outcome);
    residualSweep(lab, teapot().moving, teapot().view(), outcome);
  } else {
    outcome.lacks("scene " + teapot().scene);
  }
  if (sceneIsHere(indoor().scene)) {
    residualSweep(lab, indoor().moving, indoor().view(), outcome);
  } else {
    outcome.lacks("scene " + indoor().scene);
  }
}

}  // namespace reprise::lab::amortized
