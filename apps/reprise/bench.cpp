// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "lab/capture/output_file.h"
#include "lab/run/copy_bandwidth.h"
#include "lab/run/interrupt.h"
#include "lab/run/progress.h"
#include "lab/run/sequence_run.h"
#include "open_source.h"
#include "verbs.h"

namespace reprise::app {
namespace {

struct BenchFlags {
  std::vector<std::string> techniques;
  std::string scene = "brick/pan";
  std::vector<std::string> sizes{"1280x720", "1920x1080", "2560x1440", "3840x2160"};
  uint32_t frames = 16;
  std::filesystem::path directory;
};

// Frames whose times do not count: pipelines and caches warm up, histories fill.
constexpr uint32_t kWarmUp = 4;

// Bytes that one frame must move: every input and history texel read once, every history and output
// texel written once. Filters that read a texel twice from memory move more.
uint64_t leastBytes(const lab::Resolver& resolver, const lab::FrameInputs& inputs) {
  uint64_t bytes = resolver.output().bytes();
  for (const lab::Image* image :
       {inputs.color, inputs.depth, inputs.motion, inputs.reactive, inputs.id}) {
    if (image != nullptr) bytes += image->bytes();
  }
  for (const RepriseMemoryItem& item : resolver.memory()) {
    // Of two copies one is read and one written; a single copy is written and read.
    bytes += item.copies >= 2 ? item.bytes / item.copies * 2 : item.bytes * 2;
  }
  return bytes;
}

struct Spread {
  double median = 0.0, low = 0.0, high = 0.0;  // ms: 50, 10 and 90 percent
};

Spread spreadOf(std::vector<double> ms) {
  std::sort(ms.begin(), ms.end());
  const auto at = [&](double fraction) {
    return ms.empty()
               ? 0.0
               : ms[static_cast<size_t>(fraction * static_cast<double>(ms.size() - 1) + 0.5)];
  };
  return {at(0.5), at(0.1), at(0.9)};
}

nlohmann::ordered_json benchOne(lab::Device& device, const lab::TechniqueChoice& choice,
                                lab::FrameSource& source, const BenchFlags& flags,
                                double copy_bytes_a_second, std::string& text) {
  lab::Resolver resolver(device, choice, source.info());
  uint64_t least_bytes = 0;
  std::vector<double> sums(flags.frames, 0.0);
  const lab::SequenceRun run = lab::runSequence(
      device, source, resolver, flags.frames + kWarmUp, false,
      [&](const lab::FrameDone& done) { least_bytes = leastBytes(resolver, done.inputs); });
  const VkExtent2D extent = source.info().extent;
  const double pixels = static_cast<double>(extent.width) * extent.height;
  nlohmann::ordered_json json{{"technique", choice.label},
                              {"extent", {extent.width, extent.height}}};
  json["passes"] = nlohmann::ordered_json::array();
  const auto row = [&](const std::string& name, const std::vector<double>& ms) {
    const Spread spread = spreadOf(ms);
    json["passes"].push_back({{"pass", name},
                              {"median_ms", spread.median},
                              {"low_ms", spread.low},
                              {"high_ms", spread.high}});
    text += fmt::format("  {:<12}{:>10.3f} ms  [{:.3f}, {:.3f}]  {:>7.4f} us/px", name,
                        spread.median, spread.low, spread.high, 1000.0 * spread.median / pixels);
    return spread;
  };
  for (const auto& [name, all] : run.resolve_times.all()) {
    const std::vector<double> ms(all.begin() + kWarmUp, all.end());
    row(name, ms);
    text += "\n";
    for (size_t i = 0; i < ms.size(); ++i) sums[i] += ms[i];
  }
  const Spread whole = row("all", sums);
  const double fraction = whole.median > 0.0 ? static_cast<double>(least_bytes) /
                                                   (0.001 * whole.median) / copy_bytes_a_second
                                             : 0.0;
  json["median_ms"] = whole.median;
  json["bytes_moved_at_least"] = least_bytes;
  json["fraction_of_copy_bandwidth"] = fraction;
  json["history_bytes"] = resolver.historyBytes();
  text += fmt::format("  moves >= {:.1f} MiB, {:.1f} % of copy bandwidth; history {:.2f} MiB\n",
                      static_cast<double>(least_bytes) / 1048576.0, 100.0 * fraction,
                      static_cast<double>(resolver.historyBytes()) / 1048576.0);
  return json;
}

int bench(const Globals& globals, const BenchFlags& flags) {
  std::vector<std::string> names = flags.techniques;
  if (names.empty()) {
    for (uint32_t i = 0; i < repriseGetTechniqueCount(); ++i)
      names.emplace_back(repriseGetTechnique(i)->name);
  }
  const std::vector<lab::TechniqueChoice> choices = lab::parseTechniques(names);
  const auto device = openDevice(globals);
  const double bandwidth = lab::measureCopyBandwidth(*device);
  nlohmann::ordered_json document{
      {"version", 1},
      {"command", globals.command},
      {"reprise", repriseGetVersion()},
      {"device", {{"name", device->name()}, {"driver", device->driver()}}},
      {"copy_bytes_per_second", bandwidth},
      {"runs", nlohmann::ordered_json::array()},
      {"skipped", nlohmann::ordered_json::array()}};
  globals.print(
      fmt::format("{}: copies {:.1f} GB/s (read + written)\n", device->name(), bandwidth * 1e-9));
  lab::Progress progress("bench", flags.sizes.size() * choices.size(), globals.quiet);
  for (const std::string& size : flags.sizes) {
    SceneFlags scene_flags;
    scene_flags.extent = size;
    scene_flags.frames = flags.frames + kWarmUp;
    const auto source = openSource(*device, flags.scene, scene_flags, lab::CaptureLayout::kAuto);
    for (const lab::TechniqueChoice& choice : choices) {
      lab::throwIfInterrupted();
      std::string text = fmt::format("{} at {}\n", choice.label, size);
      try {
        document["runs"].push_back(benchOne(*device, choice, *source, flags, bandwidth, text));
      } catch (const ApiError& error) {
        if (error.result != REPRISE_ERROR_OUT_OF_MEMORY &&
            error.result != REPRISE_ERROR_UNSUPPORTED)
          throw;
        text += fmt::format("  skipped: {}\n", error.what());
        document["skipped"].push_back(
            {{"technique", choice.label}, {"size", size}, {"reason", error.what()}});
      }
      progress.step();
      globals.print(text);
    }
  }
  if (!flags.directory.empty()) {
    lab::makeOutputDirectory(flags.directory);
    lab::writeOutputFile(flags.directory / "bench.json", document.dump(1) + "\n");
  }
  globals.printJson(document);
  return validationResult(*device);
}

}  // namespace

void addBench(CLI::App& app, const Globals& globals, Action& action) {
  CLI::App* verb =
      app.add_subcommand("bench", "times each pass of each technique by GPU timestamps");
  auto flags = std::make_shared<BenchFlags>();
  verb->add_option("-t,--techniques", flags->techniques, "techniques with settings (default: all)");
  verb->add_option("--scene", flags->scene, "where the frames come from")->capture_default_str();
  verb->add_option("--size", flags->sizes, "extents")->capture_default_str();
  verb->add_option("--frames", flags->frames, "timed frames, after 4 that are not")
      ->check(CLI::Range(1u, 10000u))
      ->capture_default_str();
  verb->add_option("-o,--output", flags->directory, "directory of bench.json");
  verb->footer("Example: reprise bench -t taa,taa:preset=fast --size 1280x720");
  verb->callback([&globals, &action, flags] {
    action = [&globals, flags] { return bench(globals, *flags); };
  });
}

}  // namespace reprise::app
