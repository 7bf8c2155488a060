// SPDX-License-Identifier: MIT
#include "lab/metrics/sequence_meter.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <mutex>
#include <stdexcept>

#include "lab/metrics/display_space.h"
#include "lab/metrics/flip.h"
#include "lab/metrics/mean_figures.h"
#include "lab/metrics/psnr.h"
#include "lab/metrics/sharpness.h"
#include "lab/metrics/ssim.h"
#include "lab/metrics/warped_flicker.h"
#include "lab/metrics/workers.h"

namespace reprise::lab {
namespace {

// Time that the threads spent on each metric; what threads wait for each other is not in it.
class MetricTimes {
 public:
  template <typename Work>
  void measure(Metric metric, const Work& work) {
    measureBy(CLOCK_THREAD_CPUTIME_ID, metric, work);
  }
  // Of work that uses threads of its own while nothing else is measured.
  template <typename Work>
  void measureAlone(Metric metric, const Work& work) {
    measureBy(CLOCK_PROCESS_CPUTIME_ID, metric, work);
  }

  std::vector<std::pair<std::string, double>> named(const MetricSet& metrics) const {
    std::vector<std::pair<std::string, double>> times;
    for (size_t i = 0; i < kMetricCount; ++i) {
      if (metrics.has(static_cast<Metric>(i))) times.emplace_back(kMetricNames[i], seconds_[i]);
    }
    return times;
  }

 private:
  template <typename Work>
  void measureBy(clockid_t clock, Metric metric, const Work& work) {
    const double begin = time_s(clock);
    work();
    const double end = time_s(clock);
    const std::lock_guard lock(mutex_);
    seconds_[static_cast<size_t>(metric)] += end - begin;
  }

  static double time_s(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1.0e-9 * static_cast<double>(now.tv_nsec);
  }

  std::mutex mutex_;
  std::array<double, kMetricCount> seconds_{};
};

struct Meter {
  const SequenceTruth& truth;
  const std::vector<FloatImage>& images;
  const MeterOptions& options;
  MetricTimes times;

  template <typename Work>
  void where(Metric metric, const Work& work) {
    if (options.metrics.has(metric)) times.measure(metric, work);
  }

  FrameFigures frame(size_t i);
  void temporal(FrameFigures& figures, size_t i, const FloatImage& reference,
                const FloatImage& test);
  void flip(FrameFigures& figures, size_t i);
  std::optional<JitterResidue> residue(const std::vector<FrameFigures>& frames);
  void colorVideoVdp(std::vector<FrameFigures>& frames);
};

FrameFigures Meter::frame(size_t i) {
  FrameFigures figures;
  figures.frame = static_cast<uint32_t>(i);
  figures.counted = images.size() <= kWarmUpFrames || i >= kWarmUpFrames;
  figures.still = truth.frames[i].median_motion_px < kStillMotion_px;
  const FloatImage reference = displayImage(truth.frames[i].reference);
  const FloatImage test = displayImage(images[i]);
  figures.psnr = psnrDb(meanSquaredError(reference, test));
  const FloatImage reference_luma = lumaImage(reference);
  const FloatImage test_luma = lumaImage(test);
  where(Metric::kSsim, [&] { figures.ssim = ssim(reference_luma, test_luma); });
  where(Metric::kSharpness, [&] { figures.sharpness = sharpness(reference_luma, test_luma); });
  where(Metric::kDisocclusion, [&] {
    const Ages& ages = truth.frames[i].ages;
    figures.disocclusion = errorAtAges(reference, test, ages, 1, kRecoveryFrames);
    if (figures.disocclusion.pixels > 0) {
      figures.disoccluded = psnrDb(figures.disocclusion.squared_error /
                                   static_cast<double>(figures.disocclusion.pixels));
    }
    for (size_t k = 0; k < kReportedAges.size(); ++k) {
      figures.ages[k] = errorAtAges(reference, test, ages, kReportedAges[k], kReportedAges[k]);
    }
  });
  flip(figures, i);
  if (i > 0) temporal(figures, i, reference, test);
  return figures;
}

void Meter::temporal(FrameFigures& figures, size_t i, const FloatImage& reference,
                     const FloatImage& test) {
  const bool any =
      options.metrics.has(Metric::kTemporalPsnr) || options.metrics.has(Metric::kFlicker);
  if (!any) return;
  const FloatImage reference_before = displayImage(truth.frames[i - 1].reference);
  const FloatImage test_before = displayImage(images[i - 1]);
  where(Metric::kTemporalPsnr, [&] {
    figures.temporal_squared_error =
        temporalSquaredError(reference, reference_before, test, test_before);
    figures.tpsnr = psnrDb(figures.temporal_squared_error);
  });
  where(Metric::kFlicker, [&] {
    figures.flicker = warpedFlicker({lumaImage(reference), lumaImage(reference_before)},
                                    {lumaImage(test), lumaImage(test_before)},
                                    truth.frames[i].motion_px, truth.frames[i].ages);
  });
}

void Meter::flip(FrameFigures& figures, size_t i) {
  if (!options.metrics.has(Metric::kFlip) && !options.metrics.has(Metric::kFlip30)) return;
  const FloatImage reference = tonemappedImage(truth.frames[i].reference);
  const FloatImage test = tonemappedImage(images[i]);
  where(Metric::kFlip,
        [&] { figures.flip = meanOf(flipErrorMap(reference, test, kFlipPixelsPerDegree)); });
  FloatImage error;
  where(Metric::kFlip30, [&] {
    error = flipErrorMap(reference, test, kFlipNearPixelsPerDegree);
    figures.flip30 = meanOf(error);
  });
  if (error.channels != 0 && options.on_error_map) options.on_error_map(i, error);
}

// Of the last frames in a row that are counted and still; a reset ends the row.
std::optional<JitterResidue> Meter::residue(const std::vector<FrameFigures>& frames) {
  size_t end = frames.size();
  while (end > 0 && !(frames[end - 1].counted && frames[end - 1].still)) --end;
  size_t begin = end;
  while (begin > 0 && end - begin < kResidueFrames && frames[begin - 1].counted &&
         frames[begin - 1].still) {
    --begin;
    if (truth.frames[begin].reset) break;
  }
  if (end - begin < kLeastResidueFrames) return std::nullopt;
  std::vector<FloatImage> differences(end - begin);
  onWorkers(differences.size(), [&](size_t k) {
    FloatImage difference = lumaImage(displayImage(images[begin + k]));
    const FloatImage reference = lumaImage(displayImage(truth.frames[begin + k].reference));
    for (size_t i = 0; i < difference.texels.size(); ++i) {
      difference.texels[i] -= reference.texels[i];
    }
    differences[k] = std::move(difference);
  });
  std::vector<uint8_t> at_rest(differences[0].texelCount(), 1);
  // The first frame's motion led to it from outside of the row.
  for (size_t f = begin + 1; f < end; ++f) {
    const FloatImage& motion_px = truth.frames[f].motion_px;
    for (size_t i = 0; i < at_rest.size(); ++i) {
      const float* motion = &motion_px.texels[2 * i];
      if (!(std::hypot(motion[0], motion[1]) < kStillMotion_px)) at_rest[i] = 0;
    }
  }
  return jitterResidue(differences, at_rest, truth.frame_rate);
}

void Meter::colorVideoVdp(std::vector<FrameFigures>& frames) {
  const ColorVideoVdp* vdp = options.color_video_vdp;
  if (vdp == nullptr || images.empty()) return;
  if (std::min(images[0].width, images[0].height) < kLeastVdpSide_px) return;
  const std::vector<double> quality = vdp->videoQuality(
      images.size(), truth.frame_rate,
      [&](size_t n) { return tonemappedImage(truth.frames[n].reference); },
      [&](size_t n) { return tonemappedImage(images[n]); });
  for (size_t i = 0; i < frames.size(); ++i) {
    frames[i].cvvdp_quality = quality[i];
    frames[i].jod = jodFromQuality(quality[i]);
  }
}

std::optional<Convergence> convergenceOf(const SequenceTruth& truth,
                                         const std::vector<FrameFigures>& frames) {
  std::vector<double> psnr_db;
  for (const FrameFigures& frame : frames) {
    if (frame.frame > 0 && truth.frames[frame.frame].reset) break;
    psnr_db.push_back(frame.psnr);
  }
  return convergence(psnr_db);
}

void check(const SequenceTruth& truth, const std::vector<FloatImage>& images) {
  if (truth.frames.size() < images.size()) {
    throw std::invalid_argument("measureSequence: fewer references than images");
  }
  for (size_t i = 0; i < images.size(); ++i) {
    const FrameTruth& frame = truth.frames[i];
    if (frame.reference.width != images[i].width || frame.reference.height != images[i].height) {
      throw std::invalid_argument("measureSequence: a reference has another extent");
    }
    if (frame.ages.size() != images[i].texelCount() ||
        frame.motion_px.texelCount() != images[i].texelCount()) {
      throw std::invalid_argument("measureSequence: motion or ages have another extent");
    }
  }
}

}  // namespace

SequenceFigures measureSequence(const SequenceTruth& truth, const std::vector<FloatImage>& images,
                                const MeterOptions& options) {
  check(truth, images);
  Meter meter{truth, images, options, {}};
  SequenceFigures figures;
  figures.frames.resize(images.size());
  onWorkers(images.size(), [&](size_t i) { figures.frames[i] = meter.frame(i); });
  if (options.metrics.has(Metric::kColorVideoVdp)) {
    meter.times.measureAlone(Metric::kColorVideoVdp, [&] { meter.colorVideoVdp(figures.frames); });
  }
  figures.mean = meanFigures(figures.frames, [](const FrameFigures&) { return true; });
  figures.still = meanFigures(figures.frames, [](const FrameFigures& f) { return f.still; });
  figures.moving = meanFigures(figures.frames, [](const FrameFigures& f) { return !f.still; });
  figures.ages = ageFigures(figures.frames);
  meter.where(Metric::kConvergence,
              [&] { figures.convergence = convergenceOf(truth, figures.frames); });
  if (options.metrics.has(Metric::kResidue)) {
    meter.times.measureAlone(Metric::kResidue,
                             [&] { figures.residue = meter.residue(figures.frames); });
  }
  figures.cpu_s = meter.times.named(options.metrics);
  return figures;
}

}  // namespace reprise::lab
