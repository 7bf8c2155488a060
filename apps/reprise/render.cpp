// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <filesystem>
#include <memory>
#include <optional>

#include "lab/capture/capture_writer.h"
#include "lab/capture/png_file.h"
#include "lab/metrics/display_space.h"
#include "lab/post/post_chain.h"
#include "lab/run/interrupt.h"
#include "lab/run/pass_times.h"
#include "lab/run/progress.h"
#include "lab/run/resolver.h"
#include "open_source.h"
#include "verbs.h"

namespace reprise::app {
namespace {

struct RenderFlags {
  std::string scene;
  std::filesystem::path directory;
  std::string plan = "reprise";
  SceneFlags scene_flags;
  bool with_reference = false;
  bool png = false;
  bool post = false;
  bool resume = false;
};

// Passes of a 16 x 16 grid, twice over.
constexpr uint32_t kMaxSpans = 1024;

std::string splitText(const lab::PassTimes& times, uint32_t frames, double evaluations) {
  double sum = 0.0;
  const auto medians = times.medians(0);
  for (const auto& [name, ms] : medians) sum += ms;
  std::string text = fmt::format("GPU time a frame, median of {} frames\n", frames);
  for (const auto& [name, ms] : medians) {
    text += fmt::format("  {:<12}{:>9.3f} ms {:>5.1f} %\n", name, ms,
                        sum > 0.0 ? 100.0 * ms / sum : 0.0);
  }
  text += fmt::format("  {:<12}{:>9.3f} ms\n", "all", sum);
  text += fmt::format("shading evaluations a pixel: {:.3f}\n", evaluations);
  return text;
}

// What --png writes: the frame by the tone curve alone, or behind the post chain.
class PngFrames {
 public:
  PngFrames(lab::Device& device, const RenderFlags& flags, VkExtent2D extent)
      : device_(device), directory_(flags.directory) {
    if (flags.post) chain_.emplace(device, extent);
  }

  void write(const lab::FrameInputs& inputs) const {
    lab::FloatImage image = lab::download(device_, chain_ ? chain_->shown() : *inputs.color);
    lab::writePng(directory_ / fmt::format("frame_{:04}.png", inputs.index + 1),
                  chain_ ? image : lab::displayImage(image));
  }
  void record(VkCommandBuffer commands, const lab::FrameInputs& inputs,
              lab::Timestamps& timestamps) const {
    if (!chain_) return;
    lab::fullBarrier(commands);
    chain_->record(commands, *inputs.color, inputs.frame_time_s, inputs.index == 0 || inputs.reset,
                   &timestamps);
  }

 private:
  lab::Device& device_;
  std::filesystem::path directory_;
  std::optional<lab::PostChain> chain_;
};

int render(const Globals& globals, const RenderFlags& flags) {
  if (flags.post && !flags.png) {
    throw lab::UsageError("--post shows what --png writes; EXR files hold the scene's own light");
  }
  if (!lab::namesScene(flags.scene)) {
    throw lab::UsageError("'" + flags.scene + "' is no scene (see 'reprise list')");
  }
  const lab::TechniqueChoice plan = lab::parseTechnique(flags.plan);
  const auto device = openDevice(globals);
  const auto source =
      openSource(*device, flags.scene, flags.scene_flags, lab::CaptureLayout::kAuto);
  lab::Resolver resolver(*device, plan, source->info());
  const RepriseSamplePlan first = resolver.plan(0).library;
  if (first.coarse_size > 1 || first.checkerboard != 0) {
    throw lab::UsageError("a capture cannot say that its pixels share shading: --plan " +
                          flags.plan + " is for live scenes");
  }
  lab::SourceInfo described = source->info();
  if (!flags.with_reference) described.reference_samples = 0;
  lab::CaptureWriter writer(flags.directory, described, plan.label, flags.resume);

  const PngFrames pngs(*device, flags, source->info().extent);
  lab::Timestamps timestamps(*device, kMaxSpans);
  source->setTimestamps(&timestamps);
  lab::PassTimes times;
  uint64_t evaluations = 0;
  const uint32_t frames = source->info().frame_count;
  {
    lab::Progress progress("render " + flags.scene, frames, globals.quiet);
    for (uint32_t index = 0; index < frames; ++index) {
      lab::throwIfInterrupted();
      lab::FrameInputs inputs;
      lab::SamplePlan sampling = resolver.plan(index);
      sampling.request = {};  // requests need history; a capture holds one evaluation a pixel
      source->prepare(sampling);
      device->submitAndWait([&](VkCommandBuffer commands) {
        timestamps.begin(commands);
        inputs = source->frame(commands, index, sampling);
        pngs.record(commands, inputs, timestamps);
      });
      times.add(index, timestamps.milliseconds());
      evaluations += source->takeEvaluations();
      // The reference renders into the images of the frame: the frame is written first.
      writer.add(*device, inputs);
      if (flags.png) pngs.write(inputs);
      if (flags.with_reference) writer.addReference(*source->reference(index));
      progress.step();
    }
  }
  writer.finish();
  if (writer.kept() > 0) spdlog::info("{} whole files were kept", writer.kept());

  const double pixels =
      static_cast<double>(source->info().extent.width) * source->info().extent.height * frames;
  const double evaluations_per_pixel = static_cast<double>(evaluations) / pixels;
  globals.print(splitText(times, frames, evaluations_per_pixel));
  globals.print(fmt::format("{} frames in {}\n", frames, flags.directory.string()));
  nlohmann::ordered_json document{{"directory", flags.directory.string()},
                                  {"frames", frames},
                                  {"shading_evaluations_per_pixel", evaluations_per_pixel}};
  for (const auto& [name, ms] : times.medians(0)) document["gpu_ms"][name] = ms;
  globals.printJson(document);
  return validationResult(*device);
}

}  // namespace

void addRender(CLI::App& app, const Globals& globals, Action& action) {
  CLI::App* verb = app.add_subcommand(
      "render", "renders a scene as a capture: EXR with colour, depth, motion, and capture.json");
  auto flags = std::make_shared<RenderFlags>();
  verb->add_option("SCENE", flags->scene, "scene/camera, such as brick/pan")->required();
  verb->add_option("-o,--output", flags->directory, "directory of the capture")->required();
  verb->add_option("--plan", flags->plan,
                   "technique, with settings, that the frames are sampled for")
      ->capture_default_str();
  flags->scene_flags.addTo(*verb, true);
  verb->add_flag("--reference", flags->with_reference,
                 "also write the many-sample reference of each frame");
  verb->add_flag("--png", flags->png, "also write each frame as PNG (x/(1+x), power 1/2.2)");
  verb->add_flag("--post", flags->post,
                 "PNGs behind a post chain: luminance adaptation, bloom, exposure, tone curve");
  verb->add_flag("--resume", flags->resume, "keep files that are there and whole");
  verb->footer(
      "Example: reprise render brick/pan --size 480x270 --frames 32 --reference -o /tmp/brick");
  verb->callback([&globals, &action, flags] {
    action = [&globals, flags] { return render(globals, *flags); };
  });
}

}  // namespace reprise::app
