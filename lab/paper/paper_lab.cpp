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
// Each half of a reference has twice the variance of the whole, and their difference four times.
constexpr double kNoiseOfHalves = 0.25;
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
  if (view.by_class) name += ", by class";
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

OrderedJson byClassJson(const ByClass& b) {
  OrderedJson db = OrderedJson::array();
  for (const double of : b.db) db.push_back(of);  // what was not measured is null
  return {{"db", db}, {"share", b.share}};
}

ByClass byClassFrom(const OrderedJson& json) {
  ByClass b;
  for (size_t of = 0; of < kGeometryClasses; ++of) {
    if (!json.at("db").at(of).is_null()) b.db[of] = json.at("db").at(of);
    b.share[of] = json.at("share").at(of);
  }
  return b;
}

ByClass byClass(const ClassError& error) {
  ByClass b;
  for (size_t of = 0; of < kGeometryClasses; ++of) {
    b.db[of] = error.db(static_cast<GeometryClass>(of));
    b.share[of] = error.share(static_cast<GeometryClass>(of));
  }
  return b;
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
          {"over_time", overTimeJson(measured.over_time)},
          {"by_class", byClassJson(measured.by_class)}};
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
    measured.by_class = byClassFrom(json.at("by_class"));
    measured.last = rgbOf(readExr(stem.string() + ".exr"));
    return measured;
  } catch (const CaptureError&) {
    return std::nullopt;
  } catch (const OrderedJson::exception&) {
    return std::nullopt;
  }
}

}  // namespace

FrameTimes timesOf(const SequenceRun& run, size_t first_timed) {
  FrameTimes times;
  times.render_ms = sumOfMedians(run.render_times, first_timed);
  times.resolve_ms = sumOfMedians(run.resolve_times, first_timed);
  for (const auto& [name, ms] : run.render_times.medians(first_timed)) {
    const bool geometry = name == "transform" || name == "visibility" || name == "motion" ||
                          name == "shadows" || name == "motion back" || name == "light tiles";
    if (!geometry) times.shade_ms += ms;
  }
  return times;
}

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
  // By class it is the frames that count that are judged, together: no reference of another one.
  const uint32_t first = view.by_class && !view.over_time ? PaperLab::warmUp(frames_) : 0;
  for (uint32_t frame = (frames_ - 1) % step; frame < frames_; frame += step) {
    if (frame >= first || frame + 1 == frames_) judged_frames_.push_back(frame);
  }
  AgeTracker ages;
  truth_.frame_rate = kFrameRate;
  Progress progress(fmt::format("reference of {} ({})", run, nameOf(view)), judged_frames_.size(),
                    quiet);
  for (const uint32_t frame : judged_frames_) {
    addReference(frame);
    if (view.over_time || view.by_class) {
      const FrameGeometry geometry = source_->geometry(frame);
      if (view.by_class) classes_[frame] = geometryClasses(geometry.view_depth);
      if (view.over_time) {
        truth_.frames.push_back(
            frameTruth(linear_references_[reference_of_frame_.at(frame)], geometry, ages));
      }
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
    noise_.push_back(kNoiseOfHalves *
                     std::pow(10.0, -0.1 * source_->references().halfAgainstHalfDb()));
    pixel_noise_.push_back(source_->references().halfDifference());
  }
  reference_of_frame_[frame] = known->second;
}

double PaperScene::psnr(uint32_t frame, const FloatImage& linear) const {
  const double error = meanSquaredError(reference(frame), displayImage(linear));
  return psnrDb(withoutNoise(error, noise_[reference_of_frame_.at(frame)]));
}

void PaperScene::addByClass(uint32_t frame, const FloatImage& linear, ClassError& error) const {
  const std::vector<GeometryClass>& classes = classes_.at(frame);
  std::array<double, kGeometryClasses> noise =
      meanByClass(classes, pixel_noise_[reference_of_frame_.at(frame)]);
  for (double& of : noise) of *= kNoiseOfHalves;
  error.add(classes, reference(frame), displayImage(linear), noise);
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
  return std::move(filterTogether(
                       run, {technique}, [&](size_t, const FrameDone& frame) { done(frame); }, view)
                       .front());
}

std::vector<SequenceRun> PaperLab::filterTogether(
    const std::string& run, const std::vector<std::string>& techniques,
    const std::function<void(size_t, const FrameDone&)>& done, const PaperView& view) {
  PaperScene& open = scene(run, view);
  std::vector<uint32_t> all(open.frames());
  std::iota(all.begin(), all.end(), 0u);
  std::vector<uint32_t> judged = open.judgedFrames();
  if (isStill(run)) judged = {judged.back()};  // the same in every frame
  std::vector<SequenceRun> runs(techniques.size());
  // Without history the judged frames are enough.
  for (const bool history : {true, false}) {
    std::vector<size_t> numbers;
    std::vector<std::unique_ptr<Resolver>> resolvers;
    for (size_t i = 0; i < techniques.size(); ++i) {
      const TechniqueChoice choice = parseTechnique(techniques[i]);
      if (keepsHistory(choice) != history) continue;
      numbers.push_back(i);
      resolvers.push_back(std::make_unique<Resolver>(open.device(), choice, open.source().info()));
    }
    if (numbers.empty()) continue;
    const std::vector<uint32_t>& frames = history ? all : judged;
    const std::string first = techniques[numbers.front()];
    Progress progress(numbers.size() == 1
                          ? fmt::format("{} by {}", run, first)
                          : fmt::format("{} by {} and {} more", run, first, numbers.size() - 1),
                      numbers.size() * frames.size(), options_.quiet);
    std::vector<SequenceRun> shared = runShared(open.device(), open.source(), resolvers, frames,
                                                [&](size_t i, const FrameDone& frame) {
                                                  done(numbers[i], frame);
                                                  progress.step();
                                                });
    for (size_t i = 0; i < numbers.size(); ++i) runs[numbers[i]] = std::move(shared[i]);
  }
  return runs;
}

std::filesystem::path PaperLab::stemOf(const std::string& key) const {
  return options_.directory / "runs" / fmt::format("{:016x}", hashBytes(key.data(), key.size()));
}

bool PaperLab::isMeasured(const std::string& key) {
  if (measured_.contains(key)) return true;
  if (!options_.resume) return false;
  std::optional<Measured> kept = readMeasured(stemOf(key), key);
  if (!kept.has_value()) return false;
  measured_[key] = std::move(*kept);
  return true;
}

const Measured& PaperLab::measure(const std::string& run, const std::string& technique,
                                  const PaperView& view) {
  measureTogether(run, {technique}, view);
  return measured_.at(key(run, technique, view));
}

void PaperLab::measureTogether(const std::string& run, const std::vector<std::string>& techniques,
                               const PaperView& view) {
  std::vector<std::string> missing;
  for (const std::string& technique : techniques) {
    const bool twice = std::find(missing.begin(), missing.end(), technique) != missing.end();
    if (!twice && !isMeasured(key(run, technique, view))) missing.push_back(technique);
  }
  // What only a sequence shows is measured on all its images, which must be held until then.
  constexpr uint64_t kMostHeld_bytes = uint64_t{1} << 30;
  size_t batch = std::max<size_t>(missing.size(), 1);
  if (view.over_time) {
    const PaperScale s = scaleOf(view);
    const uint64_t held = uint64_t{16} * s.extent.width * s.extent.height *
                          (isStill(run) ? s.still_frames : s.frames);
    batch = std::clamp<size_t>(kMostHeld_bytes / std::max<uint64_t>(held, 1), 1, batch);
  }
  const std::span<const std::string> left(missing);
  for (size_t first = 0; first < missing.size(); first += batch) {
    measureBatch(run, left.subspan(first, std::min(batch, missing.size() - first)), view);
  }
}

void PaperLab::measureBatch(const std::string& run, std::span<const std::string> techniques,
                            const PaperView& view) {
  PaperScene& open = scene(run, view);
  std::vector<Measured> all(techniques.size());
  std::vector<FloatImage> last(techniques.size());
  std::vector<std::vector<FloatImage>> images(techniques.size());
  std::vector<ClassError> by_class(techniques.size());
  const uint32_t first = warmUp(open.frames());
  const std::vector<SequenceRun> runs = filterTogether(
      run, {techniques.begin(), techniques.end()},
      [&](size_t i, const FrameDone& done) {
        if (!open.isJudged(done.index)) return;
        all[i].frames.push_back(done.index);
        all[i].psnr_db.push_back(open.psnr(done.index, done.image));
        last[i] = done.image;
        if (view.by_class && done.index >= first) {
          open.addByClass(done.index, done.image, by_class[i]);
        }
        if (view.over_time) images[i].push_back(done.image);
      },
      view);
  makeOutputDirectory(options_.directory / "runs");
  for (size_t i = 0; i < techniques.size(); ++i) {
    Measured& measured = all[i];
    measured.evaluations_per_pixel = runs[i].evaluations_per_pixel;
    // Times settle at once: the first frame builds caches, no more.
    static_cast<FrameTimes&>(measured) = timesOf(runs[i], 1);
    measured.last = displayImage(last[i]);
    if (view.by_class) measured.by_class = byClass(by_class[i]);
    if (view.over_time) {
      MeterOptions options;
      options.metrics = MetricSet::parse("tpsnr,flicker,disocclusion,sharpness");
      measured.over_time = overTime(measureSequence(open.truth(), images[i], options));
    }
    const std::string own = key(run, techniques[i], view);
    const std::filesystem::path stem = stemOf(own);
    writeExr(stem.string() + ".exr", exrOf(measured.last));
    writeOutputFile(stem.string() + ".json", measuredJson(own, measured).dump(1) + "\n");
    measured_[own] = std::move(measured);
  }
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
