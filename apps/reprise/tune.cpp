// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>

#include "lab/capture/output_file.h"
#include "lab/metrics/sequence_meter.h"
#include "lab/run/progress.h"
#include "lab/run/read_truth.h"
#include "lab/run/sequence_run.h"
#include "lab/tune/search.h"
#include "open_source.h"
#include "verbs.h"

namespace reprise::app {
namespace {

// FLIP and flicker are better when lower; their scores are their negatives.
struct ScoreInfo {
  const char* name;
  double lab::MeanFigures::*figure;
  double sign;
  std::optional<lab::Metric> metric;  // to be measured for it
};
constexpr ScoreInfo kScores[] = {
    {"psnr", &lab::MeanFigures::psnr, 1.0, std::nullopt},
    {"tpsnr", &lab::MeanFigures::tpsnr, 1.0, lab::Metric::kTemporalPsnr},
    {"ssim", &lab::MeanFigures::ssim, 1.0, lab::Metric::kSsim},
    {"flip", &lab::MeanFigures::flip, -1.0, lab::Metric::kFlip},
    {"flicker", &lab::MeanFigures::flicker, -1.0, lab::Metric::kFlicker},
    {"disoccluded", &lab::MeanFigures::disoccluded, 1.0, lab::Metric::kDisocclusion},
};

struct TuneFlags {
  std::vector<std::string> sources, held_out, over;
  std::string technique = "reprise";
  std::string score = "psnr";
  lab::SearchOptions search;
  std::filesystem::path directory;
  SceneFlags scene_flags;
  std::string layout = "auto";
};

struct Judge {
  std::unique_ptr<lab::FrameSource> source;
  lab::SequenceTruth truth;
};

std::vector<const ScoreInfo*> parseScores(const std::string& text) {
  std::vector<const ScoreInfo*> scores;
  for (size_t begin = 0; begin <= text.size();) {
    const size_t end = std::min(text.find(',', begin), text.size());
    const std::string name = text.substr(begin, end - begin);
    const auto known = std::find_if(std::begin(kScores), std::end(kScores),
                                    [&](const ScoreInfo& info) { return name == info.name; });
    if (known == std::end(kScores)) {
      throw lab::UsageError(
          "--score: '" + name +
          "' is none of psnr, tpsnr, ssim, flip, flicker, disoccluded, separated by commas");
    }
    scores.push_back(known);
    begin = end + 1;
  }
  return scores;
}

class Tuner {
 public:
  Tuner(const Globals& globals, const TuneFlags& flags)
      : globals_(globals),
        flags_(flags),
        base_(lab::parseTechnique(flags.technique)),
        scores_(parseScores(flags.score)),
        device_(openDevice(globals)) {
    const RepriseTechniqueInfo& info = *base_.library;
    if (base_.name != info.name) {
      throw lab::UsageError("'" + base_.name + "' has nothing to tune");
    }
    for (const std::string& text : flags.over) {
      settings_.push_back(lab::parseTunedSetting(info, text));
    }
    for (uint32_t i = 0; flags.over.empty() && i < info.setting_count; ++i) {
      settings_.push_back(lab::parseTunedSetting(info, info.settings[i].name));
    }
    if (settings_.empty()) throw lab::UsageError("'" + base_.name + "' has nothing to tune");
    for (const ScoreInfo* score : scores_) {
      if (score->metric.has_value()) metrics_.add(*score->metric);
    }
  }

  int run() {
    if (!flags_.directory.empty()) lab::makeOutputDirectory(flags_.directory);
    for (const std::string& text : flags_.sources) seen_.push_back(open(text));
    for (const std::string& text : flags_.held_out) held_out_.push_back(open(text));
    const lab::SearchResult result = search();
    write(result, true);
    globals_.print(summary(result));
    globals_.printJson(document_);
    return validationResult(*device_);
  }

 private:
  Judge open(const std::string& text) {
    const auto layout = static_cast<lab::CaptureLayout>(
        std::find(lab::kCaptureLayouts.begin(), lab::kCaptureLayouts.end(), flags_.layout) -
        lab::kCaptureLayouts.begin());
    Judge judge;
    judge.source = openSource(*device_, text, flags_.scene_flags, layout);
    const uint32_t frames = std::min(flags_.scene_flags.frames, judge.source->info().frame_count);
    // Fails before anything long begins where the technique cannot work on this source.
    lab::Resolver(*device_, base_, judge.source->info());
    lab::Progress progress("reference of " + judge.source->info().name, frames, globals_.quiet);
    judge.truth = lab::readTruth(*judge.source, frames, [&] { progress.step(); });
    return judge;
  }

  std::vector<double> start() {
    const lab::Resolver resolver(*device_, base_, seen_.front().source->info());
    std::vector<double> values;
    for (const lab::TunedSetting& setting : settings_) {
      for (const auto& [info, value] : resolver.settings()) {
        if (info == setting.info) values.push_back(value);
      }
      if (values.back() < setting.minimum || values.back() > setting.maximum) {
        throw lab::UsageError(fmt::format("the search begins at {}={}, outside its range",
                                          setting.info->name,
                                          lab::settingText(*setting.info, values.back())));
      }
    }
    return values;
  }

  lab::SearchResult search() {
    first_ = start();
    lab::Progress progress("settings tried", flags_.search.evaluations, globals_.quiet);
    return lab::searchSettings(
        settings_, first_,
        [&](const std::vector<double>& values) {
          const double score = scoreOf(seen_, choiceOf(values)).back();
          progress.step();
          return score;
        },
        flags_.search,
        [&](const lab::SearchStep& step) {
          spdlog::info("{:>4}: {:.4f} {}", step.evaluation, step.score,
                       choiceOf(step.values).label);
          document_["steps"].push_back({{"evaluation", step.evaluation},
                                        {"score", step.score},
                                        {"technique", choiceOf(step.values).label}});
          write({step, step, step.evaluation, false}, false);
        });
  }

  // As a user would write it; what stands at its first value is left out.
  lab::TechniqueChoice choiceOf(const std::vector<double>& values) const {
    auto settings = base_.settings;
    if (!base_.preset.empty()) settings.insert(settings.begin(), {"preset", base_.preset});
    for (size_t i = 0; i < values.size(); ++i) {
      if (values[i] == first_[i]) continue;
      const std::string name = settings_[i].info->name;
      std::erase_if(settings, [&](const auto& setting) { return setting.first == name; });
      settings.emplace_back(name, lab::settingText(*settings_[i].info, values[i]));
    }
    std::string text = base_.name;
    for (const auto& [name, value] : settings) {
      text += (text == base_.name ? ":" : ",") + name + "=" + value;
    }
    return lab::parseTechnique(text);
  }

  // A score a source, then their mean.
  std::vector<double> scoreOf(std::vector<Judge>& judges, const lab::TechniqueChoice& choice) {
    std::vector<double> scores;
    double sum = 0.0;
    for (Judge& judge : judges) {
      lab::Resolver resolver(*device_, choice, judge.source->info());
      const lab::SequenceRun run =
          lab::runSequence(*device_, *judge.source, resolver,
                           static_cast<uint32_t>(judge.truth.frames.size()), true, nullptr);
      const lab::SequenceFigures figures =
          lab::measureSequence(judge.truth, run.images, {.metrics = metrics_});
      double score = 0.0;
      for (const ScoreInfo* info : scores_) {
        score += info->sign * (*figures.mean).*(info->figure) / static_cast<double>(scores_.size());
      }
      if (!std::isfinite(score)) {
        throw lab::UsageError("--score " + flags_.score + " has no value on " +
                              judge.source->info().name);
      }
      scores.push_back(score);
      sum += score;
    }
    scores.push_back(sum / static_cast<double>(judges.size()));
    return scores;
  }

  void write(const lab::SearchResult& result, bool whole) {
    document_["version"] = 1;
    document_["command"] = globals_.command;
    document_["score"] = flags_.score;
    document_["technique"] = choiceOf(result.best.values).label;
    document_["evaluations"] = result.evaluations;
    document_["ended"] = result.ended;
    if (whole) rows_ = {rowsOf("searched", seen_, result), rowsOf("held out", held_out_, result)};
    document_["sources"] = nlohmann::ordered_json::array();
    for (const auto& rows : rows_) {
      for (const nlohmann::ordered_json& row : rows) document_["sources"].push_back(row);
    }
    if (flags_.directory.empty()) return;
    lab::writeOutputFile(flags_.directory / "tune.json", document_.dump(1) + "\n");
  }

  std::vector<nlohmann::ordered_json> rowsOf(const char* kind, std::vector<Judge>& judges,
                                             const lab::SearchResult& result) {
    std::vector<nlohmann::ordered_json> rows;
    if (judges.empty()) return rows;
    const std::vector<double> before = scoreOf(judges, base_);
    const std::vector<double> after = scoreOf(judges, choiceOf(result.best.values));
    for (size_t i = 0; i < before.size(); ++i) {
      const bool mean = i == judges.size();
      rows.push_back({{"source", mean ? std::string("mean") : judges[i].source->info().name},
                      {"kind", kind},
                      {"before", before[i]},
                      {"after", after[i]}});
    }
    return rows;
  }

  std::string summary(const lab::SearchResult& result) {
    std::string text = fmt::format("{:<10}{:<24}{:>10}{:>10}{:>10}\n", "", flags_.score, "before",
                                   "after", "gain");
    for (const nlohmann::ordered_json& row : document_["sources"]) {
      const double before = row["before"], after = row["after"];
      text +=
          fmt::format("{:<10}{:<24}{:>10.4f}{:>10.4f}{:>+10.4f}\n", row["kind"].get<std::string>(),
                      row["source"].get<std::string>(), before, after, after - before);
    }
    if (held_out_.empty())
      text += "no source is held out: what this gains elsewhere is not known\n";
    text += fmt::format("{} settings tried{}\n-t {}\n", result.evaluations,
                        result.ended ? "" : "; more would go on (--evaluations)",
                        choiceOf(result.best.values).label);
    return text;
  }

  const Globals& globals_;
  const TuneFlags& flags_;
  const lab::TechniqueChoice base_;
  const std::vector<const ScoreInfo*> scores_;
  const std::unique_ptr<lab::Device> device_;
  std::vector<lab::TunedSetting> settings_;
  lab::MetricSet metrics_;
  std::vector<Judge> seen_, held_out_;
  std::vector<double> first_;
  std::array<std::vector<nlohmann::ordered_json>, 2> rows_;
  nlohmann::ordered_json document_ = {{"steps", nlohmann::ordered_json::array()}};
};

}  // namespace

void addTune(CLI::App& app, const Globals& globals, Action& action) {
  CLI::App* verb = app.add_subcommand(
      "tune", "searches a technique's settings for the best score over scenes and captures");
  auto flags = std::make_shared<TuneFlags>();
  verb->add_option("SOURCE", flags->sources,
                   "scenes (brick/pan) or directories of captures with references")
      ->required();
  verb->add_option("-t,--technique", flags->technique,
                   "technique, with the settings that the search begins at")
      ->capture_default_str();
  verb->add_option("--over", flags->over,
                   "settings to search, separated by spaces: NAME or NAME=LOW:HIGH (default: all)");
  verb->add_option("--held-out", flags->held_out,
                   "sources that the search does not see; measured before and after");
  verb->add_option("--score", flags->score,
                   "what is to be best in the mean of all sources: psnr, tpsnr, ssim, flip, "
                   "flicker, disoccluded, or the mean of several, separated by commas")
      ->capture_default_str();
  verb->add_option("--evaluations", flags->search.evaluations, "settings tried at most")
      ->check(CLI::Range(1u, 100000u))
      ->capture_default_str();
  verb->add_option("--least-gain", flags->search.least_gain, "less is no improvement")
      ->check(CLI::Range(0.0, 100.0))
      ->capture_default_str();
  verb->add_option("-o,--output", flags->directory, "directory of tune.json");
  flags->scene_flags.addTo(*verb, true);
  verb->add_option("--layout", flags->layout, "channel names of captures without capture.json")
      ->check(CLI::IsMember(lab::kCaptureLayouts))
      ->capture_default_str();
  verb->footer(
      "Example: reprise tune brick/pan horse/gallop -t taa --over alpha gamma=0.5:3 --held-out "
      "brick/zoom --size 192x108 --frames 16 --samples 32\n"
      "A source is worked through once a try: render slow scenes as captures first "
      "(reprise render).");
  verb->callback([&globals, &action, flags] {
    action = [&globals, flags] { return Tuner(globals, *flags).run(); };
  });
}

}  // namespace reprise::app
