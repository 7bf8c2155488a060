// SPDX-License-Identifier: MIT
#include "lab/metrics/sequence_meter.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "lab/metrics/display_space.h"
#include "lab/metrics/flip.h"
#include "lab/metrics/psnr.h"
#include "lab/metrics/sharpness.h"
#include "lab/metrics/ssim.h"
#include "lab/metrics/workers.h"

namespace reprise::lab {
namespace {

template <typename Counts>
std::optional<MeanFigures> meanFigures(const std::vector<FrameFigures>& frames,
                                       const Counts& counts) {
  MeanFigures mean;
  double squared_error = 0.0;
  double temporal = 0.0;
  uint32_t temporal_frames = 0;
  for (const FrameFigures& frame : frames) {
    if (!frame.counted || !counts(frame)) continue;
    ++mean.frames;
    mean.psnr += frame.psnr;
    squared_error += std::pow(10.0, -0.1 * frame.psnr);
    mean.ssim += frame.ssim;
    mean.flip += frame.flip;
    mean.flip30 += frame.flip30;
    mean.sharpness += frame.sharpness;
    if (!std::isnan(frame.tpsnr)) {
      temporal += frame.temporal_squared_error;
      ++temporal_frames;
    }
  }
  if (mean.frames == 0) return std::nullopt;
  for (double* sum : {&mean.psnr, &mean.ssim, &mean.flip, &mean.flip30, &mean.sharpness}) {
    *sum /= mean.frames;
  }
  mean.psnr_of_mean = psnrDb(squared_error / mean.frames);
  mean.tpsnr = temporal_frames == 0 ? std::numeric_limits<double>::quiet_NaN()
                                    : psnrDb(temporal / temporal_frames);
  return mean;
}

}  // namespace

SequenceFigures measureSequence(const std::vector<FloatImage>& references,
                                const std::vector<FloatImage>& images,
                                const std::vector<float>& median_motion_px,
                                const ErrorMapHandler& on_error_map) {
  const size_t count = images.size();
  if (references.size() < count || median_motion_px.size() < count) {
    throw std::invalid_argument("measureSequence: fewer references than images");
  }
  for (size_t i = 0; i < count; ++i) {
    if (references[i].width != images[i].width || references[i].height != images[i].height) {
      throw std::invalid_argument("measureSequence: a reference has another extent");
    }
  }
  SequenceFigures figures;
  figures.frames.resize(count);
  onWorkers(count, [&](size_t i) {
    FrameFigures& frame = figures.frames[i];
    frame.frame = static_cast<uint32_t>(i);
    frame.counted = count <= kWarmUpFrames || i >= kWarmUpFrames;
    frame.still = median_motion_px[i] < kStillMotion_px;
    const FloatImage reference = displayImage(references[i]);
    const FloatImage test = displayImage(images[i]);
    frame.psnr = psnrDb(meanSquaredError(reference, test));
    const FloatImage reference_luma = lumaImage(reference);
    const FloatImage test_luma = lumaImage(test);
    frame.ssim = ssim(reference_luma, test_luma);
    frame.sharpness = sharpness(reference_luma, test_luma);
    const FloatImage reference_light = tonemappedImage(references[i]);
    const FloatImage test_light = tonemappedImage(images[i]);
    frame.flip = meanOf(flipErrorMap(reference_light, test_light, kFlipPixelsPerDegree));
    const FloatImage error = flipErrorMap(reference_light, test_light, kFlipNearPixelsPerDegree);
    frame.flip30 = meanOf(error);
    if (on_error_map) on_error_map(i, error);
    frame.tpsnr = std::numeric_limits<double>::quiet_NaN();
    if (i > 0) {
      frame.temporal_squared_error = temporalSquaredError(
          reference, displayImage(references[i - 1]), test, displayImage(images[i - 1]));
      frame.tpsnr = psnrDb(frame.temporal_squared_error);
    }
  });
  figures.mean = meanFigures(figures.frames, [](const FrameFigures&) { return true; });
  figures.still = meanFigures(figures.frames, [](const FrameFigures& f) { return f.still; });
  figures.moving = meanFigures(figures.frames, [](const FrameFigures& f) { return !f.still; });
  return figures;
}

}  // namespace reprise::lab
