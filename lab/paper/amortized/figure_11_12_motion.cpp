// SPDX-License-Identifier: MIT
//
// Figures 11 and 12: PSNR frame by frame, by kind of motion and scene.
#include <fmt/format.h>

#include "lab/paper/amortized/experiments.h"
#include "lab/paper/amortized/subjects.h"

namespace reprise::lab::amortized {
namespace {

void frameByFrame(PaperLab& lab, const std::string& run, const PaperView& view,
                  const std::string& ours, Outcome& outcome) {
  const std::string reprojection = bestReprojection(lab, run, view);
  std::vector<Series> series;
  for (const std::string& technique :
       {std::string("none"), std::string("ss:n=2"), std::string("ss:n=3"), std::string("ss:n=4"),
        reprojection, ours}) {
    const Measured& measured = lab.measure(run, technique, view);
    Series one{
        technique, {measured.frames.begin(), measured.frames.end()}, measured.psnr_db, false};
    series.push_back(std::move(one));
  }
  const double ours_db = movingPsnr(lab, run, ours, view);
  const double ss4_db = movingPsnr(lab, run, "ss:n=4", view);
  outcome.report(run + ", 4x4", std::nullopt, ss4_db, "dB");
  outcome.report(run + ", " + reprojection, std::nullopt, movingPsnr(lab, run, reprojection, view),
                 "dB");
  outcome.claim(run + ", amortized", std::nullopt, ours_db, "dB", "above 4x4", ours_db > ss4_db);
  outcome.linePlot({run, "frame", "PSNR, dB"}, series);
}

}  // namespace

void figure11(PaperLab& lab, Outcome& outcome) {
  for (const char* run : {"brick/pan", "brick/rotate", "brick/zoom"}) {
    frameByFrame(lab, run, {}, "amortized", outcome);
  }
}

void figure12(PaperLab& lab, Outcome& outcome) {
  for (const Subject* subject : {&horse(), &teapot(), &indoor()}) {
    if (sceneIsHere(subject->scene)) {
      frameByFrame(lab, subject->moving, subject->view(), amortizedFor(lab, *subject), outcome);
    } else {
      outcome.lacks("scene " + subject->scene);
    }
  }
}

}  // namespace reprise::lab::amortized
