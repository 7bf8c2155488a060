// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>

#include "lab/capture/capture_error.h"
#include "lab/capture/capture_source.h"
#include "lab/capture/output_file.h"
#include "lab/capture/png_file.h"
#include "lab/capture/strict_json.h"
#include "lab/capture/video.h"
#include "lab/metrics/display_space.h"
#include "lab/run/progress.h"
#include "lab/run/sequence_run.h"
#include "open_source.h"
#include "verbs.h"

namespace reprise::app {
namespace {

struct FilterFlags {
  std::filesystem::path capture;
  std::filesystem::path directory;
  std::string technique = "reprise";
  std::string layout = "auto";
  double scale = 1.0;
  uint32_t frames = 0;  // 0: all
  bool png = false;
  std::filesystem::path video;
  bool resume = false;
};

// The input's file with its colour replaced: every other layer and all metadata stay.
void writeFiltered(const std::filesystem::path& path, const lab::CaptureSource& source,
                   const lab::FloatImage& image, bool larger) {
  lab::ExrImage file = source.current().file;
  const std::span<const float> texels(image.texels);
  const std::string& layer = source.description().color_layer;
  if (larger) {
    // Other layers have the input's extent, and a file has one.
    std::erase_if(file.channels, [&](const lab::ExrChannel& channel) {
      const std::string prefix = layer.empty() ? "" : layer + ".";
      return channel.name != prefix + "R" && channel.name != prefix + "G" &&
             channel.name != prefix + "B";
    });
    file.width = image.width;
    file.height = image.height;
  }
  for (size_t c = 0; c < 3; ++c) {
    const std::string name = (layer.empty() ? "" : layer + ".") + "RGB"[c];
    lab::ExrChannel* channel = file.find(name);
    *channel = lab::exrChannel(name, channel->type, texels.subspan(c), image.channels);
  }
  lab::writeExr(path, file);
}

bool isWhole(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return false;
  try {
    lab::readExr(path);
    return true;
  } catch (const lab::CaptureError&) {
    return false;
  }
}

// filter.json says what made the files, so that --resume does not mix two settings.
void claimDirectory(const FilterFlags& flags, const nlohmann::ordered_json& made_by) {
  std::error_code error;
  if (std::filesystem::equivalent(flags.capture, flags.directory, error)) {
    throw lab::UsageError(
        "the output directory is the capture itself: its frames would be overwritten");
  }
  lab::makeOutputDirectory(flags.directory);
  const std::filesystem::path note = flags.directory / "filter.json";
  if (flags.resume && std::filesystem::exists(note, error)) {
    const auto before = lab::parseJson(lab::readWholeFile(note), note.string());
    if (before != nlohmann::json(made_by)) {
      throw lab::UsageError("--resume: " + note.string() +
                            " was made by another technique, settings or input");
    }
  }
  lab::writeOutputFile(note, made_by.dump(1) + "\n");
}

int filter(const Globals& globals, const FilterFlags& flags) {
  const lab::TechniqueChoice choice = lab::parseTechnique(flags.technique);
  if (flags.scale > 1.0 && (choice.library->flags & REPRISE_TECHNIQUE_UPSAMPLES) == 0) {
    throw lab::UsageError("--scale: technique '" + choice.name + "' cannot upsample");
  }
  const auto device = openDevice(globals);
  const auto layout = static_cast<lab::CaptureLayout>(
      std::find(lab::kCaptureLayouts.begin(), lab::kCaptureLayouts.end(), flags.layout) -
      lab::kCaptureLayouts.begin());
  lab::CaptureSource source(*device, flags.capture, layout);
  reportCapture(source, false);
  const VkExtent2D input = source.info().extent;
  const VkExtent2D extent = parseExtent(scaledExtent(input, flags.scale));
  const bool larger = extent.width != input.width || extent.height != input.height;
  lab::Resolver resolver(*device, choice, source.info(), extent);
  nlohmann::ordered_json made_by{{"reprise", repriseGetVersion()},
                                 {"technique", choice.label},
                                 {"extent", {extent.width, extent.height}},
                                 {"capture", std::filesystem::absolute(flags.capture).string()}};
  claimDirectory(flags, made_by);

  const uint32_t all = source.info().frame_count;
  const uint32_t frames = flags.frames == 0 ? all : std::min(flags.frames, all);
  std::optional<lab::Video> video;
  if (!flags.video.empty()) {
    video.emplace(flags.video, extent.width, extent.height, source.info().frame_rate);
  }
  uint32_t kept = 0;
  const auto begin = std::chrono::steady_clock::now();
  lab::SequenceRun run;
  {
    lab::Progress progress("filter " + flags.capture.string(), frames, globals.quiet);
    // All frames are resolved, also those that are kept: history comes from the frames before.
    run =
        lab::runSequence(*device, source, resolver, frames, false, [&](const lab::FrameDone& done) {
          const std::string name = source.description().frameFile(done.index);
          const std::filesystem::path path = flags.directory / name;
          if (flags.resume && isWhole(path)) {
            ++kept;
          } else {
            writeFiltered(path, source, done.image, larger);
          }
          if (flags.png || video.has_value()) {
            const lab::FloatImage display = lab::displayImage(done.image);
            if (flags.png)
              lab::writePng(std::filesystem::path(path).replace_extension(".png"), display);
            if (video.has_value()) video->add(display);
          }
          progress.step();
        });
  }
  if (video.has_value()) video->finish();
  reportCapture(source, true);
  if (kept > 0) spdlog::info("{} whole frames were kept", kept);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  double resolve_ms = 0.0;
  for (const auto& [name, ms] : run.resolve_times.medians(0)) resolve_ms += ms;
  globals.print(fmt::format("{} frames by {} in {}: {:.1f} s, resolve {:.2f} ms a frame\n", frames,
                            choice.label, flags.directory.string(), seconds, resolve_ms));
  if (video.has_value()) globals.print(fmt::format("video: {}\n", flags.video.string()));
  const lab::Repairs& repairs = source.repairs();
  globals.printJson(
      {{"directory", flags.directory.string()},
       {"technique", choice.label},
       {"frames", frames},
       {"kept", kept},
       {"resolve_ms", resolve_ms},
       {"repaired",
        {{"color", repairs.color}, {"depth", repairs.depth}, {"motion", repairs.motion}}}});
  return validationResult(*device);
}

}  // namespace

void addFilter(CLI::App& app, const Globals& globals, Action& action) {
  CLI::App* verb = app.add_subcommand("filter", "antialiases a rendered EXR sequence");
  auto flags = std::make_shared<FilterFlags>();
  verb->add_option("CAPTURE", flags->capture,
                   "directory of EXR frames, with capture.json or without")
      ->required();
  verb->add_option("-t,--technique", flags->technique,
                   "technique with settings, such as taa:alpha=0.05")
      ->capture_default_str();
  verb->add_option("-o,--output", flags->directory, "directory of the filtered frames")->required();
  verb->add_option("--layout", flags->layout, "channel names, where there is no capture.json")
      ->check(CLI::IsMember(lab::kCaptureLayouts))
      ->capture_default_str();
  verb->add_option("--scale", flags->scale,
                   "output's extent over the input's, a side, for techniques that upsample; only "
                   "colour is written then")
      ->check(CLI::Range(1.0, 4.0))
      ->capture_default_str();
  verb->add_option("--frames", flags->frames, "only so many from the start; 0: all")
      ->capture_default_str();
  verb->add_flag("--png", flags->png, "also write each frame as PNG (x/(1+x), power 1/2.2)");
  verb->add_option("--video", flags->video, "also write an H.264 film, through ffmpeg");
  verb->add_flag("--resume", flags->resume, "keep frames that are there and whole");
  verb->footer(
      "Example: reprise filter renders/shot3 -t taa -o renders/shot3-aa --png --video shot3.mp4\n"
      "Other layers and metadata are kept; colour keeps its type (half or float).");
  verb->callback([&globals, &action, flags] {
    action = [&globals, flags] { return filter(globals, *flags); };
  });
}

}  // namespace reprise::app
