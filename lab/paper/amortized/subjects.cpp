// SPDX-License-Identifier: MIT
#include "lab/paper/amortized/subjects.h"

#include <fmt/format.h>

#include <cmath>

namespace reprise::lab::amortized {

const Subject& horse() {
  static const Subject subject = {
      "horse",
      "horse/gallop",
      "horse/still",
      false,
      false,
      PublishedFigures{15.68, 22.22, 24.62, 25.50, 22.72, 26.30, 30.54, 40.04, 140, 11, 88, 64}};
  return subject;
}

const Subject& brick() {
  static const Subject subject = {
      "brick",
      "brick/pan",
      "brick/still",
      false,
      false,
      PublishedFigures{21.82, 26.54, 28.71, 29.72, 25.52, 28.70, 31.96, 35.11, 166, 9.8, 113, 84}};
  return subject;
}

const Subject& indoor() {
  static const Subject subject = {
      "indoor",
      "indoor/fly",
      "indoor/still",
      true,
      true,
      PublishedFigures{24.79, 30.33, 32.38, 33.26, 27.27, 31.24, 33.93, 38.37, 112, 10, 92, 52}};
  return subject;
}

const Subject& teapot() {
  static const Subject subject = {"teapot", "teapot/orbit", "teapot/still",
                                  true,     false,          std::nullopt};
  return subject;
}

const std::vector<double>& residualTolerances() {
  static const std::vector<double> tolerances = {0.0001, 0.0005, 0.002, 0.01, 0.03, 0.1, 0.0};
  return tolerances;
}

std::string amortizedWith(double residual) {
  return residual > 0.0 ? fmt::format("amortized:motion=exact,residual={}", residual)
                        : "amortized:motion=exact";
}

std::string amortizedFor(PaperLab& lab, const Subject& subject) {
  if (!subject.shading_changes) return amortizedWith(0.0);
  std::string best;
  double best_db = 0.0;
  for (const double tolerance : residualTolerances()) {
    const std::string technique = amortizedWith(tolerance);
    const double db = movingPsnr(lab, subject.moving, technique, subject.view());
    if (best.empty() || db > best_db) {
      best = technique;
      best_db = db;
    }
  }
  return best;
}

std::string bestReprojection(PaperLab& lab, const std::string& run, const PaperView& view) {
  std::string best;
  double best_db = 0.0;
  for (const double alpha : {0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.6, 0.8}) {
    const std::string technique = fmt::format("reprojection:jitter=uniform,alpha={}", alpha);
    const double db = movingPsnr(lab, run, technique, view);
    // PSNR has one peak over alpha: past it the search is over.
    if (!best.empty() && db < best_db) break;
    best = technique;
    best_db = db;
  }
  return best;
}

PixelMask addedEvaluations(Device& device, const FrameInputs& inputs) {
  const FloatImage extra = download(device, *inputs.extra);
  PixelMask added(extra.texelCount());
  for (size_t i = 0; i < added.size(); ++i) {
    added[i] = static_cast<uint8_t>(std::lround(extra.texels[4 * i + 3]));
  }
  return added;
}

double movingPsnr(PaperLab& lab, const std::string& run, const std::string& technique,
                  const PaperView& view) {
  const Measured& measured = lab.measure(run, technique, view);
  return measured.meanPsnr(PaperLab::warmUp(lab.scale().frames));
}

double stillPsnr(PaperLab& lab, const std::string& run, const std::string& technique,
                 const PaperView& view) {
  const Measured& measured = lab.measure(run, technique, view);
  return measured.meanPsnr(lab.scale().still_frames * 3 / 4);
}

}  // namespace reprise::lab::amortized
