// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <cstdlib>
#include <filesystem>
#include <memory>

#include "compare_output.h"
#include "lab/capture/capture_error.h"
#include "lab/capture/output_file.h"
#include "lab/metrics/display_space.h"
#include "lab/metrics/workers.h"
#include "lab/post/show_sequence.h"
#include "lab/report/results_table.h"
#include "lab/run/progress.h"
#include "lab/run/read_truth.h"
#include "lab/run/sequence_run.h"
#include "open_source.h"
#include "verbs.h"

namespace reprise::app {
namespace {

struct CompareFlags {
  std::vector<std::string> sources;
  std::vector<std::string> techniques = {"none", "taa", "reprise"};
  std::filesystem::path directory;
  SceneFlags scene_flags;
  std::string layout = "auto";
  std::filesystem::path baseline;
  double max_drop_db = 0.1;
  uint32_t report_mib = 48;
  std::string metrics = "default";
  std::filesystem::path cvvdp_table;
  bool post = false;
};

bool upsamples(const lab::TechniqueChoice& choice) {
  return choice.grid <= 1 && (choice.library->flags & REPRISE_TECHNIQUE_UPSAMPLES) != 0;
}

nlohmann::ordered_json settingJson(const RepriseSettingInfo& info, double value) {
  switch (info.type) {
    case REPRISE_SETTING_CHOICE:
      return info.choices[static_cast<size_t>(value)];
    case REPRISE_SETTING_BOOLEAN:
      return value != 0.0;
    case REPRISE_SETTING_INTEGER:
      return static_cast<int64_t>(value);
    default:
      return value;
  }
}

// Every picture, the reference's and each technique's, goes through the same chain from its start.
lab::PassTimes throughPost(lab::Device& device, const std::vector<lab::FloatImage*>& pictures,
                           const lab::SequenceTruth& truth) {
  lab::PassTimes times;
  lab::showSequence(
      device, pictures, truth.frame_rate, [&](size_t i) { return truth.frames[i].reset; }, {},
      [&](size_t i, const auto& spans) { times.add(i, spans); });
  return times;
}

lab::SequenceTruth readTruth(lab::Device& device, lab::FrameSource& source, uint32_t frames,
                             bool post, bool quiet) {
  lab::SequenceTruth truth;
  {
    lab::Progress progress("reference of " + source.info().name, frames, quiet);
    truth = lab::readTruth(source, frames, [&] { progress.step(); });
  }
  if (post) {
    std::vector<lab::FloatImage*> references;
    for (lab::FrameTruth& frame : truth.frames) references.push_back(&frame.reference);
    throughPost(device, references, truth);
  }
  return truth;
}

size_t firstCounted(size_t frames) {
  return frames > lab::kWarmUpFrames ? lab::kWarmUpFrames : 0;
}

lab::RunCost costOf(const lab::SequenceRun& run, const lab::Resolver& resolver) {
  lab::RunCost cost;
  const size_t first = firstCounted(run.images.size());
  cost.passes_ms = run.resolve_times.medians(first);
  cost.render_ms = run.render_times.medians(first);
  for (const auto& [name, ms] : cost.passes_ms) cost.median_ms += ms;
  cost.shading_evaluations_per_pixel = run.evaluations_per_pixel;
  cost.history_bytes = resolver.historyBytes();
  return cost;
}

lab::RunResult compareOne(lab::Device& device, lab::FrameSource& source, VkExtent2D output_extent,
                          const lab::TechniqueChoice& choice, const lab::SequenceTruth& truth,
                          lab::MeterOptions options, CompareOutput& output, bool post, bool quiet) {
  lab::Resolver resolver(device, choice, source.info(), output_extent);
  const std::string& name = source.info().name;
  lab::SequenceRun run;
  {
    lab::Progress progress(name + " by " + choice.label, truth.frames.size(), quiet);
    run = lab::runSequence(device, source, resolver, static_cast<uint32_t>(truth.frames.size()),
                           true, [&](const lab::FrameDone&) { progress.step(); });
  }
  lab::RunResult result;
  const VkExtent2D input = source.info().extent;
  result.source = name;
  result.technique = choice.label;
  if (input.width != output_extent.width || input.height != output_extent.height) {
    result.settings.emplace_back("input", fmt::format("{}x{}", input.width, input.height));
  }
  if (choice.grid > 1) result.settings.emplace_back("n", choice.grid);
  for (const auto& [info, value] : resolver.settings()) {
    result.settings.emplace_back(info->name, settingJson(*info, value));
  }
  result.reference_samples = source.info().reference_samples;
  result.reference_filter = source.info().reference_filter;
  result.cost = costOf(run, resolver);
  if (post) {
    std::vector<lab::FloatImage*> images;
    for (lab::FloatImage& image : run.images) images.push_back(&image);
    result.cost.post_ms = throughPost(device, images, truth).medians(firstCounted(images.size()));
  }
  lab::onWorkers(run.images.size(), [&](size_t i) {
    output.addImage(name, choice.label, static_cast<uint32_t>(i), lab::displayImage(run.images[i]));
  });
  options.on_error_map = [&](size_t frame, const lab::FloatImage& error) {
    output.addError(name, choice.label, static_cast<uint32_t>(frame), error);
  };
  result.figures = lab::measureSequence(truth, run.images, options);
  return result;
}

// Its table is data that comes apart from this project: the flag's file, or what REPRISE_DATA
// holds.
std::optional<lab::ColorVideoVdp> openColorVideoVdp(const CompareFlags& flags,
                                                    const lab::MetricSet& metrics) {
  if (!metrics.has(lab::Metric::kColorVideoVdp)) return std::nullopt;
  std::filesystem::path file = flags.cvvdp_table;
  if (const char* root = std::getenv("REPRISE_DATA"); file.empty() && root != nullptr) {
    file = std::filesystem::path(root) / "cvvdp" / lab::CsfTable::kFileName;
    std::error_code error;
    if (!std::filesystem::exists(file, error)) file.clear();
  }
  if (file.empty()) {
    spdlog::warn(
        "ColorVideoVDP is unavailable: its table {} is neither given (--cvvdp-table) nor below "
        "REPRISE_DATA/cvvdp",
        lab::CsfTable::kFileName);
    return std::nullopt;
  }
  try {
    return lab::ColorVideoVdp(lab::CsfTable::load(file), lab::kVdpStandard4k);
  } catch (const std::runtime_error& error) {
    throw lab::CaptureError("--cvvdp-table", "", error.what());
  }
}

int compare(const Globals& globals, const CompareFlags& flags) {
  const std::vector<lab::TechniqueChoice> choices = lab::parseTechniques(flags.techniques);
  lab::MeterOptions options{.metrics = lab::MetricSet::parse(flags.metrics)};
  const std::optional<lab::ColorVideoVdp> vdp = openColorVideoVdp(flags, options.metrics);
  options.color_video_vdp = vdp ? &*vdp : nullptr;
  // Read first: a comparison of an hour must not end in a missing file.
  const std::string baseline = flags.baseline.empty() ? "" : lab::readWholeFile(flags.baseline);
  const auto layout = static_cast<lab::CaptureLayout>(
      std::find(lab::kCaptureLayouts.begin(), lab::kCaptureLayouts.end(), flags.layout) -
      lab::kCaptureLayouts.begin());
  CompareOutput output(flags.directory, uint64_t{flags.report_mib} << 20);
  lab::Results results;
  results.command = globals.command;
  if (flags.post) results.post = "luminance adaptation, bloom, exposure";
  int code = kDone;
  for (const std::string& text : flags.sources) {
    // Each source has a device of its own: after a scene's raster passes lavapipe 22.3 defers the
    // timestamps of a capture's frames, which have none, to the end of the submission.
    const auto device = openDevice(globals);
    results.device = device->name();
    results.driver = device->driver();
    const auto source = openSource(*device, text, flags.scene_flags, layout);
    const lab::SourceInfo& info = source->info();
    if (results.runs.empty()) {
      results.extent[0] = info.extent.width;
      results.extent[1] = info.extent.height;
    }
    const uint32_t frames = std::min(flags.scene_flags.frames, info.frame_count);
    // Techniques that upsample get a smaller scene; the reference is everyone's.
    std::unique_ptr<lab::FrameSource> small;
    if (flags.scene_flags.scale > 1.0) {
      if (!lab::namesScene(text)) {
        throw lab::UsageError("--scale renders scenes smaller; '" + text +
                              "' is a capture: see filter --scale");
      }
      SceneFlags smaller = flags.scene_flags;
      smaller.extent = scaledExtent(info.extent, 1.0 / smaller.scale);
      smaller.view_extent = info.extent;
      small = openSource(*device, text, smaller, layout);
    }
    const auto sourceOf = [&](const lab::TechniqueChoice& choice) -> lab::FrameSource& {
      return small != nullptr && upsamples(choice) ? *small : *source;
    };
    // Fails for techniques that cannot work on this source before anything long begins.
    for (const lab::TechniqueChoice& choice : choices) {
      lab::Resolver resolver(*device, choice, sourceOf(choice).info(), info.extent);
      sourceOf(choice).prepare(resolver.plan(0));
    }
    const lab::SequenceTruth truth = readTruth(*device, *source, frames, flags.post, globals.quiet);
    lab::onWorkers(truth.frames.size(), [&](size_t i) {
      output.addImage(info.name, "reference", static_cast<uint32_t>(i),
                      lab::displayImage(truth.frames[i].reference));
    });
    for (const lab::TechniqueChoice& choice : choices) {
      results.runs.push_back(compareOne(*device, sourceOf(choice), info.extent, choice, truth,
                                        options, output, flags.post, globals.quiet));
    }
    reportCapture(*source, true);
    code = std::max<int>(code, validationResult(*device));
  }
  output.finish(results);
  globals.print(lab::resultsTable(results));
  globals.print(fmt::format("\nreport: {}\n", (flags.directory / "report.html").string()));
  globals.printJson(lab::resultsJson(results));
  if (!flags.baseline.empty()) {
    const lab::BaselineCheck check =
        lab::checkBaseline(results, baseline, flags.baseline.string(), flags.max_drop_db);
    for (const std::string& failure : check.failures) spdlog::error("{}", failure);
    globals.print(fmt::format("baseline: {} runs compared, {} failed\n", check.compared,
                              check.failures.size()));
    if (!check.failures.empty() && code == kDone) code = kCheckFailed;
  }
  return code;
}

}  // namespace

void addCompare(CLI::App& app, const Globals& globals, Action& action) {
  CLI::App* verb = app.add_subcommand(
      "compare", "measures techniques against the reference and writes a report");
  auto flags = std::make_shared<CompareFlags>();
  verb->add_option("SOURCE", flags->sources,
                   "scenes (brick/pan) or directories of captures with references")
      ->required();
  verb->add_option(
          "-t,--techniques", flags->techniques,
          "techniques with settings, separated by spaces or commas: none,taa:alpha=0.05,ss:n=4")
      ->capture_default_str();
  verb->add_option("-o,--output", flags->directory, "directory of the results")->required();
  flags->scene_flags.addTo(*verb, true);
  verb->add_option("--scale", flags->scene_flags.scale,
                   "scenes: techniques that upsample get frames this much smaller a side than "
                   "--size; the others get it whole")
      ->check(CLI::Range(1.0, 4.0))
      ->capture_default_str();
  verb->add_option("--metrics", flags->metrics,
                   "figures to measure, separated by commas: default, all, or names of "
                   "docs/metrics.md; cvvdp is not in default")
      ->capture_default_str();
  verb->add_option("--cvvdp-table", flags->cvvdp_table,
                   "csf_lut_weber_fixed_size.json of ColorVideoVDP; by default below "
                   "REPRISE_DATA/cvvdp");
  verb->add_flag("--post", flags->post,
                 "measure what is seen behind a renderer's post chain (luminance adaptation, "
                 "bloom, exposure, tone curve), the reference behind the same one");
  verb->add_option("--layout", flags->layout, "channel names of captures without capture.json")
      ->check(CLI::IsMember(lab::kCaptureLayouts))
      ->capture_default_str();
  verb->add_option("--baseline", flags->baseline,
                   "an earlier results.json: exit 1 where PSNR fell");
  verb->add_option("--max-drop", flags->max_drop_db,
                   "dB by which PSNR may fall below the baseline's")
      ->check(CLI::Range(0.0, 100.0))
      ->capture_default_str();
  verb->add_option(
          "--report-mib", flags->report_mib,
          "MiB of pictures in report.html; beyond it every second frame is left out of the page")
      ->check(CLI::Range(1u, 2048u))
      ->capture_default_str();
  verb->footer(
      "Example: reprise compare brick/pan -t none,reprise,ss:n=4 --size 480x270 --frames 32 -o "
      "/tmp/compare");
  verb->callback([&globals, &action, flags] {
    action = [&globals, flags] { return compare(globals, *flags); };
  });
}

}  // namespace reprise::app
