// SPDX-License-Identifier: MIT
#include "lab/paper/paper_lab.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "lab/capture/capture_error.h"
#include "lab/capture/exr_file.h"
#include "lab/capture/output_file.h"
#include "lab/metrics/display_space.h"
#include "lab/metrics/psnr.h"
#include "lab/metrics/sequence_truth.h"
#include "lab/render/reference_file.h"
#include "lab/report/page_parts.h"
#include "lab/run/interrupt.h"
#include "lab/run/progress.h"
#include "reprise/reprise.h"

namespace reprise::lab {
namespace {

constexpr double kFrameRate = 60.0;
// Frames until a moving history holds what its bounds let it: four buffers are each written every
// fourth frame, and the blur bound of amortized supersampling keeps about four writes.
constexpr uint32_t kSettled = 16;

constexpr std::array<std::pair<const char*, double OverTime::*>, 4> kOverTime = {{
    {"tpsnr_db", &OverTime::tpsnr_db},
    {"flicker", &OverTime::flicker},
    {"disoccluded_db", &OverTime::disoccluded_db},
    {"sharpness", &OverTime::sharpness},
}};

bool isStill(const std::string& run) {
  const size_t slash = run.rfind('/');
  return slash != std::string::npos && run.compare(slash + 1, 5, "still") == 0;
}

std::string nameOf(const PaperView& view) {
  std::string name = view.judged == Judged::kCentre ? "centre" : "pixel";
  if (view.defer_lights) name += ", lights deferred";
  if (view.shade_covered) name += ", shaded where covered";
  if (view.reference_filter == ReferenceFilter::kBox) name += ", box";
  if (view.over_time) name += ", over time";
  if (view.texture_filter == TextureFilter::kTrilinear) name += ", trilinear";
  if (view.texture_filter == TextureFilter::kNone) name += ", no mip levels";
  if (view.samples > 1) name += fmt::format(", {} samples a pixel", view.samples);
  return name;
}

double sumOfMedians(const PassTimes& times, size_t first) {
  double sum = 0.0;
  for (const auto& [name, ms] : times.medians(first)) sum += ms;
  return sum;
}

bool keepsHistory(const TechniqueChoice& choice) {
  return (choice.library->flags & REPRISE_TECHNIQUE_USES_HISTORY) != 0;
}

// A figure that was not measured is null.
OrderedJson overTimeJson(const OverTime& o) {
  OrderedJson json = {{"ages", o.ages}, {"age_psnr_db", o.age_psnr_db}};
  for (const auto& [name, member] : kOverTime) json[name] = o.*member;
  return json;
}

OverTime overTimeFrom(const OrderedJson& json) {
  OverTime o;
  o.ages = json.at("ages").get<std::vector<double>>();
  o.age_psnr_db = json.at("age_psnr_db").get<std::vector<double>>();
  for (const auto& [name, member] : kOverTime) {
    if (!json.at(name).is_null()) o.*member = json.at(name);
  }
  return o;
}

OverTime overTime(const SequenceFigures& figures) {
  OverTime o;
  if (figures.mean.has_value()) {
    o.tpsnr_db = figures.mean->tpsnr;
    o.flicker = figures.mean->flicker;
    o.disoccluded_db = figures.mean->disoccluded;
    o.sharpness = figures.mean->sharpness;
  }
  for (const AgeFigures& age : figures.ages) {
    o.ages.push_back(age.age);
    o.age_psnr_db.push_back(age.psnr);
  }
  return o;
}

// A measurement on disk: figures in JSON, the last image in EXR beside it.
OrderedJson measuredJson(const std::string& key, const Measured& measured) {
  return {{"key", key},
          {"frames", measured.frames},
          {"psnr_db", measured.psnr_db},
          {"evaluations_per_pixel", measured.evaluations_per_pixel},
          {"render_ms", measured.render_ms},
          {"shade_ms", measured.shade_ms},
          {"resolve_ms", measured.resolve_ms},
          {"over_time", overTimeJson(measured.over_time)}};
}

ExrImage exrOf(const FloatImage& rgb) {
  ExrImage exr{rgb.width, rgb.height, {}, nullptr};
  const std::span<const float> texels(rgb.texels);
  for (size_t c = 0; c < 3; ++c) {
    exr.channels.push_back(
        exrChannel(std::string(1, "BGR"[c]), ExrType::kFloat, texels.subspan(2 - c), 3));
  }
  return exr;
}

FloatImage rgbOf(const ExrImage& exr) {
  FloatImage rgb(exr.width, exr.height, 3);
  for (size_t c = 0; c < 3; ++c) {
    const ExrChannel* channel = exr.find(std::string(1, "RGB"[c]));
    if (channel == nullptr) throw CaptureError("measurement", "channel", "is missing");
    const std::vector<float> values = channel->floats();
    for (size_t i = 0; i < values.size(); ++i) rgb.texels[3 * i + c] = values[i];
  }
  return rgb;
}

// Whole, of this very key, or nothing: what is damaged is measured again.
std::optional<Measured> readMeasured(const std::filesystem::path& stem, const std::string& key) {
  try {
    const OrderedJson json = OrderedJson::parse(readWholeFile(stem.string() + ".json"));
    if (json.at("key") != key) return std::nullopt;
    Measured measured;
    measured.frames = json.at("frames").get<std::vector<uint32_t>>();
    measured.psnr_db = json.at("psnr_db").get<std::vector<double>>();
    measured.evaluations_per_pixel = json.at("evaluations_per_pixel");
    measured.render_ms = json.at("render_ms");
    measured.shade_ms = json.at("shade_ms");
    measured.resolve_ms = json.at("resolve_ms");
    measured.over_time = overTimeFrom(json.at("over_time"));
    measured.last = rgbOf(readExr(stem.string() + ".exr"));
    return measured;
  } catch (const CaptureError&) {
    return std::nullopt;
  } catch (const OrderedJson::exception&) {
    return std::nullopt;
  }
}

FrameTimes timesOf(const SequenceRun& run, size_t first_timed) {
  FrameTimes times;
  times.render_ms = sumOfMedians(run.render_times, first_timed);
  times.resolve_ms = sumOfMedians(run.resolve_times, first_timed);
  for (const auto& [name, ms] : run.render_times.medians(first_timed)) {
    const bool geometry = name == "transform" || name == "visibility" || name == "motion" ||
                          name == "shadows" || name == "motion back";
    if (!geometry) times.shade_ms += ms;
  }
  return times;
}

}  // namespace

bool sceneIsHere(const std::string& scene) {
  return std::any_of(sceneList().begin(), sceneList().end(),
                     [&](const SceneInfo& info) { return info.name == scene; });
}

double Measured::meanPsnr(uint32_t first) const {
  double sum = 0.0;
  size_t count = 0;
  for (size_t i = 0; i < frames.size(); ++i) {
    if (frames[i] < first && i + 1 < frames.size()) continue;
    sum += psnr_db[i];
    ++count;
  }
  return sum / static_cast<double>(std::max<size_t>(count, 1));
}

PaperScene::PaperScene(std::unique_ptr<Device> device, const std::string& run,
                       const PaperScale& scale, bool still, const PaperView& view,
                       const std::filesystem::path& cache, bool quiet)
    : device_(std::move(device)) {
  SceneSourceOptions options;
  options.extent = scale.extent;
  options.frames = still ? scale.still_frames : scale.frames;
  options.frame_rate = kFrameRate;
  options.switches.shading_only = view.judged == Judged::kCentre;
  options.switches.defer_lights = view.defer_lights;
  options.reference.samples = still ? scale.still_samples : scale.samples;
  options.switches.shade_covered = view.shade_covered;
  options.switches.texture_filter = view.texture_filter;
  options.switches.samples = view.samples;
  options.reference.filter = view.reference_filter;
  options.reference.coverage =
      view.judged == Judged::kCentre ? ReferenceCoverage::kCentre : ReferenceCoverage::kPixel;
  options.reference.cache = cache;
  source_ = std::make_unique<SceneSource>(*device_, parseSceneRun(run), options);
  frames_ = options.frames;
  // From the last one back, so that the longest history is judged.
  const uint32_t step = view.over_time ? 1 : std::max(scale.judge_every, 1u);
  for (uint32_t frame = (frames_ - 1) % step; frame < frames_; frame += step) {
    judged_frames_.push_back(frame);
  }
  AgeTracker ages;
  truth_.frame_rate = kFrameRate;
  Progress progress(fmt::format("reference of {} ({})", run, nameOf(view)), judged_frames_.size(),
                    quiet);
  for (const uint32_t frame : judged_frames_) {
    addReference(frame);
    if (view.over_time) {
      truth_.frames.push_back(frameTruth(linear_references_[reference_of_frame_.at(frame)],
                                         source_->geometry(frame), ages));
    }
    progress.step();
  }
}

void PaperScene::addReference(uint32_t frame) {
  throwIfInterrupted();
  if (reference_of_frame_.contains(frame)) return;
  // Frames that show the same share their reference, as all of a view at rest do.
  source_->renderer().setFrame(frame, 0.0f);
  const std::vector<uint8_t> content = source_->renderer().contentBytes();
  const auto [known, fresh] =
      reference_of_.try_emplace(hashBytes(content.data(), content.size()), references_.size());
  if (fresh) {
    linear_references_.push_back(*source_->reference(frame));
    references_.push_back(displayImage(linear_references_.back()));
    // Each half has twice the variance of the whole, and their difference four times.
    noise_.push_back(0.25 * std::pow(10.0, -0.1 * source_->references().halfAgainstHalfDb()));
  }
  reference_of_frame_[frame] = known->second;
}

double PaperScene::psnr(uint32_t frame, const FloatImage& linear) const {
  // An estimate may not fall below nothing.
  constexpr double kLeastShare = 0.02;
  const double error = meanSquaredError(reference(frame), displayImage(linear));
  const double noise = noise_[reference_of_frame_.at(frame)];
  return psnrDb(std::max(error - noise, kLeastShare * error));
}

PaperLab::PaperLab(PaperLabOptions options) : options_(std::move(options)) {}

uint32_t PaperLab::warmUp(uint32_t frames) {
  return frames > 2 * kSettled ? kSettled : frames / 2;
}

PaperScale PaperLab::scaleOf(const PaperView& view) const {
  PaperScale scale = options_.scale;
  if (scale.whole && view.published_extent.width > 0) scale.extent = view.published_extent;
  return scale;
}

std::string PaperLab::key(const std::string& run, const std::string& technique,
                          const PaperView& view) const {
  const PaperScale s = scaleOf(view);
  const bool still = isStill(run);
  return fmt::format("{} by {} at {}x{}, {} frames, every {}, {} samples, judged by {}, reprise {}",
                     run, technique, s.extent.width, s.extent.height,
                     still ? s.still_frames : s.frames, s.judge_every,
                     still ? s.still_samples : s.samples, nameOf(view), repriseGetVersion());
}

void PaperLab::keepValidation(const Device& device) {
  const std::vector<std::string>& said = device.validationMessages();
  validation_.insert(validation_.end(), said.begin(), said.end());
}

void PaperLab::close() {
  if (!scene_) return;
  keepValidation(scene_->device());
  scene_.reset();
}

std::vector<std::string> PaperLab::takeValidationMessages() {
  close();
  return std::move(validation_);
}

PaperScene& PaperLab::scene(const std::string& run, const PaperView& view) {
  const std::string wanted = key(run, "", view);
  if (!scene_ || open_key_ != wanted) {
    close();
    scene_ = std::make_unique<PaperScene>(openDevice(), run, scaleOf(view), isStill(run), view,
                                          options_.cache, options_.quiet);
    open_key_ = wanted;
  }
  return *scene_;
}

SequenceRun PaperLab::filter(const std::string& run, const std::string& technique,
                             const std::function<void(const FrameDone&)>& done,
                             const PaperView& view) {
  PaperScene& open = scene(run, view);
  Resolver resolver(open.device(), parseTechnique(technique), open.source().info());
  std::vector<uint32_t> frames = open.judgedFrames();
  if (keepsHistory(resolver.choice())) {
    frames.resize(open.frames());
    std::iota(frames.begin(), frames.end(), 0u);
  } else if (isStill(run)) {
    frames = {frames.back()};  // the same in every frame
  }
  Progress progress(fmt::format("{} by {}", run, technique), frames.size(), options_.quiet);
  return runFrames(open.device(), open.source(), resolver, frames, false,
                   [&](const FrameDone& frame) {
                     done(frame);
                     progress.step();
                   });
}

const Measured& PaperLab::measure(const std::string& run, const std::string& technique,
                                  const PaperView& view) {
  const std::string wanted = key(run, technique, view);
  if (const auto known = measured_.find(wanted); known != measured_.end()) return known->second;
  const std::filesystem::path runs = options_.directory / "runs";
  const std::filesystem::path stem =
      runs / fmt::format("{:016x}", hashBytes(wanted.data(), wanted.size()));
  if (options_.resume) {
    if (std::optional<Measured> kept = readMeasured(stem, wanted)) {
      return measured_[wanted] = std::move(*kept);
    }
  }
  PaperScene& open = scene(run, view);
  Measured measured;
  FloatImage last;
  std::vector<FloatImage> images;
  const SequenceRun sequence = filter(
      run, technique,
      [&](const FrameDone& done) {
        if (!open.isJudged(done.index)) return;
        measured.frames.push_back(done.index);
        measured.psnr_db.push_back(open.psnr(done.index, done.image));
        last = done.image;
        if (view.over_time) images.push_back(done.image);
      },
      view);
  measured.evaluations_per_pixel = sequence.evaluations_per_pixel;
  // Times settle at once: the first frame builds caches, no more.
  static_cast<FrameTimes&>(measured) = timesOf(sequence, 1);
  measured.last = displayImage(last);
  if (view.over_time) {
    MeterOptions options;
    options.metrics = MetricSet::parse("tpsnr,flicker,disocclusion,sharpness");
    measured.over_time = overTime(measureSequence(open.truth(), images, options));
  }
  makeOutputDirectory(runs);
  writeExr(stem.string() + ".exr", exrOf(measured.last));
  writeOutputFile(stem.string() + ".json", measuredJson(wanted, measured).dump(1) + "\n");
  return measured_[wanted] = std::move(measured);
}

std::vector<FrameTimes> PaperLab::timesTogether(const std::string& run,
                                                const std::vector<std::string>& techniques,
                                                const PaperView& view) {
  // The first half fills histories, whose requests cost more than those of a settled one.
  constexpr uint32_t kTimedFrames = 24;
  PaperScene& open = scene(run, view);
  std::vector<std::unique_ptr<Resolver>> resolvers;
  for (const std::string& technique : techniques) {
    resolvers.push_back(
        std::make_unique<Resolver>(open.device(), parseTechnique(technique), open.source().info()));
  }
  const uint32_t frames = std::min(open.frames(), kTimedFrames);
  Progress progress(run + " by all in turn", frames, options_.quiet);
  std::vector<FrameTimes> times;
  for (const SequenceRun& sequence :
       runTogether(open.device(), open.source(), resolvers, frames, [&] { progress.step(); })) {
    times.push_back(timesOf(sequence, frames / 2));
  }
  return times;
}

}  // namespace reprise::lab
