// SPDX-License-Identifier: MIT
#include "lab/metrics/mean_figures.h"

#include <cmath>

#include "lab/metrics/psnr.h"

namespace reprise::lab {
namespace {

// Over the frames where `value` is a number; kNoFigure without one.
template <typename Value>
double meanOver(const std::vector<const FrameFigures*>& frames, const Value& value) {
  double sum = 0.0;
  uint32_t count = 0;
  for (const FrameFigures* frame : frames) {
    const double v = value(*frame);
    if (std::isnan(v)) continue;
    sum += v;
    ++count;
  }
  return count == 0 ? kNoFigure : sum / count;
}

double psnrOrNone(double mean_squared_error) {
  return std::isnan(mean_squared_error) ? kNoFigure : psnrDb(mean_squared_error);
}

double psnrOf(const AgeError& error) {
  return error.pixels == 0 ? kNoFigure
                           : psnrDb(error.squared_error / static_cast<double>(error.pixels));
}

void addTo(AgeError& sum, const AgeError& error) {
  sum.pixels += error.pixels;
  sum.squared_error += error.squared_error;
}

}  // namespace

std::optional<MeanFigures> meanFigures(const std::vector<FrameFigures>& frames,
                                       const std::function<bool(const FrameFigures&)>& takes) {
  std::vector<const FrameFigures*> taken;
  for (const FrameFigures& frame : frames) {
    if (frame.counted && takes(frame)) taken.push_back(&frame);
  }
  if (taken.empty()) return std::nullopt;
  MeanFigures mean;
  mean.frames = static_cast<uint32_t>(taken.size());
  for (const FigureInfo& figure : kFigures) {
    mean.*figure.mean = meanOver(taken, [&](const FrameFigures& f) { return f.*figure.frame; });
  }
  mean.psnr_of_mean = psnrOrNone(
      meanOver(taken, [](const FrameFigures& f) { return std::pow(10.0, -0.1 * f.psnr); }));
  mean.tpsnr =
      psnrOrNone(meanOver(taken, [](const FrameFigures& f) { return f.temporal_squared_error; }));
  std::vector<double> quality;
  for (const FrameFigures* frame : taken) {
    if (!std::isnan(frame->cvvdp_quality)) quality.push_back(frame->cvvdp_quality);
  }
  if (!quality.empty()) mean.jod = jodFromQuality(pooledQuality(quality));
  AgeError disocclusion;
  for (const FrameFigures* frame : taken) addTo(disocclusion, frame->disocclusion);
  mean.disoccluded = psnrOf(disocclusion);
  return mean;
}

std::vector<AgeFigures> ageFigures(const std::vector<FrameFigures>& frames) {
  std::vector<AgeFigures> figures;
  for (size_t i = 0; i < kReportedAges.size(); ++i) {
    AgeError sum;
    for (const FrameFigures& frame : frames) {
      if (frame.counted) addTo(sum, frame.ages[i]);
    }
    if (sum.pixels > 0) figures.push_back({kReportedAges[i], sum.pixels, psnrOf(sum)});
  }
  return figures;
}

}  // namespace reprise::lab
