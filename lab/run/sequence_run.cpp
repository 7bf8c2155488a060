// SPDX-License-Identifier: MIT
#include "lab/run/sequence_run.h"

#include <algorithm>
#include <numeric>

#include "equations/hidden_light.h"
#include "lab/run/interrupt.h"

namespace reprise::lab {
namespace {

// Passes of a source with many samples repeat; 2048 spans hold a 16 x 16 grid and all resolves.
constexpr uint32_t kMaxSpans = 2048;

void addHiddenLight(FloatImage& image, const FloatImage& gains) {
  for (size_t i = 0; i < image.texelCount(); ++i) {
    float* rgb = &image.texels[4 * i];
    const float* gain = &gains.texels[4 * i];
    const eq::vec3 lit =
        eq::withHiddenLight({rgb[0], rgb[1], rgb[2]}, {gain[0], gain[1], gain[2]}, gain[3]);
    rgb[0] = lit.x;
    rgb[1] = lit.y;
    rgb[2] = lit.z;
  }
}

// Plans, renders and resolves frame `index`, the nth of `run`, and adds its times to it.
FrameInputs runFrame(Device& device, FrameSource& source, Resolver& resolver,
                     Timestamps& timestamps, uint32_t index, size_t n, SequenceRun& run) {
  throwIfInterrupted();
  FrameInputs inputs;
  const SamplePlan plan = resolver.plan(index, &timestamps);
  source.prepare(plan);
  device.submitAndWait([&](VkCommandBuffer commands) {
    timestamps.begin(commands);
    inputs = source.frame(commands, index, plan);
    resolver.record(commands, inputs, &timestamps);
  });
  auto spans = timestamps.milliseconds();
  const std::vector<std::string>& names = resolver.passNames();
  const auto resolve = std::stable_partition(spans.begin(), spans.end(), [&](const auto& span) {
    return std::find(names.begin(), names.end(), span.first) == names.end();
  });
  run.resolve_times.add(n, {resolve, spans.end()});
  run.render_times.add(n, {spans.begin(), resolve});
  return inputs;
}

double evaluationsPerPixel(uint64_t evaluations, const SourceInfo& info, size_t frames) {
  const double pixels =
      static_cast<double>(info.extent.width) * info.extent.height * static_cast<double>(frames);
  return static_cast<double>(evaluations) / pixels;
}

}  // namespace

SequenceRun runSequence(Device& device, FrameSource& source, Resolver& resolver, uint32_t frames,
                        bool keep_images, const std::function<void(const FrameDone&)>& done) {
  std::vector<uint32_t> all(frames);
  std::iota(all.begin(), all.end(), 0u);
  return runFrames(device, source, resolver, all, keep_images, done);
}

SequenceRun runFrames(Device& device, FrameSource& source, Resolver& resolver,
                      std::span<const uint32_t> frames, bool keep_images,
                      const std::function<void(const FrameDone&)>& done) {
  SequenceRun run;
  Timestamps timestamps(device, kMaxSpans);
  source.setTimestamps(&timestamps);
  source.takeEvaluations();
  for (size_t n = 0; n < frames.size(); ++n) {
    const FrameInputs inputs = runFrame(device, source, resolver, timestamps, frames[n], n, run);
    FloatImage image = download(device, resolver.output());
    if (inputs.late != nullptr) addHiddenLight(image, download(device, *inputs.late));
    if (done) done({frames[n], inputs, image});
    if (keep_images) run.images.push_back(std::move(image));
  }
  source.setTimestamps(nullptr);
  run.evaluations_per_pixel =
      evaluationsPerPixel(source.takeEvaluations(), source.info(), frames.size());
  return run;
}

std::vector<SequenceRun> runTogether(Device& device, FrameSource& source,
                                     std::span<const std::unique_ptr<Resolver>> resolvers,
                                     uint32_t frames, const std::function<void()>& done) {
  std::vector<SequenceRun> runs(resolvers.size());
  Timestamps timestamps(device, kMaxSpans);
  source.setTimestamps(&timestamps);
  source.takeEvaluations();
  for (uint32_t index = 0; index < frames; ++index) {
    for (size_t i = 0; i < resolvers.size(); ++i) {
      runFrame(device, source, *resolvers[i], timestamps, index, index, runs[i]);
      runs[i].evaluations_per_pixel +=
          evaluationsPerPixel(source.takeEvaluations(), source.info(), frames);
    }
    if (done) done();
  }
  source.setTimestamps(nullptr);
  return runs;
}

}  // namespace reprise::lab
