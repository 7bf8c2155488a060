// SPDX-License-Identifier: MIT
#include "lab/paper/cpst/subjects.h"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>

#include "lab/run/interrupt.h"
#include "lab/run/progress.h"

namespace reprise::lab::cpst {
namespace {

struct Model {
  const char* file;     // below REPRISE_DATA
  const char* instead;  // the lab's own, where it is not there
};

Subject subjectOf(Subject subject, const Model& model, const std::string& standing) {
  const char* root = std::getenv("REPRISE_DATA");
  const std::filesystem::path file =
      std::filesystem::path(root == nullptr ? "" : root) / model.file;
  if (root != nullptr && std::filesystem::exists(file)) {
    subject.run = fmt::format("gltf:{}/path", file.string());
    subject.note = standing;
  } else {
    subject.run = model.instead;
    subject.note = fmt::format("{}: {} stands for it, since REPRISE_DATA leads to no {}.",
                               subject.name, model.instead, model.file);
  }
  return subject;
}

std::vector<Subject> listed() {
  return {subjectOf({.name = "Sponza",
                     .run = {},
                     .note = {},
                     .lamps = 128,
                     .ps = {0.12, 2.97, 0.86, 4.53, 2073601},
                     .cbr = {0.16, 2.31, 0.82, 3.86, 1036802},
                     .cpst = {0.25, 1.69, 0.82, 3.32, 690531}},
                    {"sponza/sponza.gltf", "lights/dolly"}, ""),
          subjectOf({.name = "Bistro",
                     .run = {},
                     .note = {},
                     .lamps = 0,
                     .ps = {1.16, 3.32, 0.88, 5.92, 2070550},
                     .cbr = {1.18, 3.36, 0.83, 5.93, 1035280},
                     .cpst = {1.26, 3.36, 0.84, 6.01, 861887}},
                    {"bistro/bistro.gltf", "hangar/fly"}, ""),
          subjectOf({.name = "San Miguel",
                     .run = {},
                     .note = {},
                     .lamps = 128,
                     .ps = {1.44, 9.81, 0.87, 12.74, 2072549},
                     .cbr = {1.45, 7.82, 0.81, 10.67, 1036814},
                     .cpst = {1.51, 7.26, 0.82, 10.21, 816752}},
                    {"vegetation/vegetation.gltf", "foliage/walk"},
                    "San Miguel: the vegetation model stands for it.")};
}

}  // namespace

const std::vector<Subject>& subjects() {
  static const std::vector<Subject> list = listed();
  return list;
}
const Subject& sponza() {
  return subjects()[0];
}
const Subject& bistro() {
  return subjects()[1];
}
const Subject& sanMiguel() {
  return subjects()[2];
}

const std::vector<Contender>& timed() {
  static const std::vector<Contender> list = {{"PS", kPs}, {"CBR", kCbr}, {"CPS-T", kCpst}};
  return list;
}

const std::vector<Contender>& judged() {
  static const std::vector<Contender> list = {
      {"PS", kPs}, {"CPS", kCps}, {"CBR", kCbr}, {"CPS-T", kCpst}};
  return list;
}

BareScene::BareScene(PaperLab& lab, const std::string& run, VkExtent2D extent, uint32_t frames,
                     std::optional<uint32_t> lamps, double frame_rate, float lamp_reach)
    : lab_(lab), name_(run), device_(lab.openDevice()), frames_(frames) {
  SceneSourceOptions options;
  options.extent = extent;
  options.frames = frames;
  options.frame_rate = frame_rate;
  options.switches.lamps = lamps;
  options.switches.lamp_reach = lamp_reach;
  options.reference.cache = "none";
  source_ = std::make_unique<SceneSource>(*device_, parseSceneRun(run), options);
}

BareScene::~BareScene() {
  lab_.keepValidation(*device_);
}

std::vector<SequenceRun> BareScene::timedRuns() {
  std::vector<std::unique_ptr<Resolver>> resolvers;
  for (const Contender& contender : timed()) {
    resolvers.push_back(
        std::make_unique<Resolver>(*device_, parseTechnique(contender.technique), source_->info()));
  }
  Progress progress(name_ + " by all in turn", frames_, lab_.quiet());
  return runTogether(*device_, *source_, resolvers, frames_, [&] { progress.step(); });
}

std::vector<uint64_t> BareScene::evaluations(const std::string& technique) {
  Resolver resolver(*device_, parseTechnique(technique), source_->info());
  Progress progress(fmt::format("evaluations of {} by {}", name_, technique), frames_,
                    lab_.quiet());
  std::vector<uint64_t> counts;
  source_->takeEvaluations();
  for (uint32_t index = 0; index < frames_; ++index) {
    throwIfInterrupted();
    const SamplePlan plan = resolver.plan(index);
    source_->prepare(plan);
    device_->submitAndWait(
        [&](VkCommandBuffer commands) { source_->frame(commands, index, plan); });
    counts.push_back(source_->takeEvaluations());
    progress.step();
  }
  return counts;
}

Cost costOf(const SequenceRun& run, size_t untimed) {
  Cost cost;
  cost.evaluations_per_pixel = run.evaluations_per_pixel;
  for (const auto& [name, ms] : run.render_times.medians(untimed)) {
    cost.total_ms += ms;
    if (name == "transform" || name == "visibility") cost.visibility_ms += ms;
    if (name == "shade" || name == "light tiles") cost.lighting_ms += ms;
  }
  for (const auto& [name, ms] : run.resolve_times.medians(untimed)) cost.resolve_ms += ms;
  cost.total_ms += cost.resolve_ms;
  return cost;
}

VkExtent2D timedExtent(const PaperLab& lab) {
  // Twice a side what is judged; the published one when whole.
  const VkExtent2D extent = lab.scale().extent;
  return lab.scale().whole ? extent : VkExtent2D{2 * extent.width, 2 * extent.height};
}

uint32_t timedFrames(const PaperLab& lab) {
  constexpr uint32_t kTimed = 8;
  return kUntimedFrames + (lab.scale().whole ? 2 * kTimed : kTimed);
}

PaperView view() {
  PaperView view;
  view.judged = Judged::kPixel;
  view.reference_filter = ReferenceFilter::kBox;
  view.by_class = true;
  return view;
}

}  // namespace reprise::lab::cpst
