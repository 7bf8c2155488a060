// SPDX-License-Identifier: MIT
#include "lab/run/sequence_run.h"

#include <algorithm>
#include <numeric>
#include <tuple>

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

auto membersOf(const RepriseSamplePlan& plan) {
  // As many names as it has members: a new one is compared before this compiles again.
  const auto& [size, jitter_px, mip_bias, period, offset, sigma_px, seed, quadrant, coarse_size,
               origin_px, motion_back, depth_samples, checkerboard, coarse_covered] = plan;
  return std::make_tuple(size, jitter_px[0], jitter_px[1], mip_bias, period, offset, sigma_px, seed,
                         quadrant, coarse_size, origin_px[0], origin_px[1], motion_back,
                         depth_samples, checkerboard, coarse_covered);
}

// What is rendered on request is that technique's own.
bool agree(const SamplePlan& a, const SamplePlan& b) {
  return !a.request && !b.request && a.grid == b.grid &&
         membersOf(a.library) == membersOf(b.library);
}

struct Rendered {
  FrameInputs inputs;
  std::vector<std::pair<std::string, double>> spans;  // without the resolve's
};

// Renders and resolves frame `index`, the nth of `run`, and adds its times to it.
Rendered runFrame(Device& device, FrameSource& source, Resolver& resolver, Timestamps& timestamps,
                  const SamplePlan& plan, uint32_t index, size_t n, SequenceRun& run) {
  throwIfInterrupted();
  FrameInputs inputs;
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
  spans.erase(resolve, spans.end());
  run.render_times.add(n, spans);
  return {std::move(inputs), std::move(spans)};
}

FloatImage resolved(Device& device, const Resolver& resolver, const FrameInputs& inputs) {
  FloatImage image = download(device, resolver.output());
  if (inputs.late != nullptr) addHiddenLight(image, download(device, *inputs.late));
  return image;
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
    const FrameInputs inputs = runFrame(device, source, resolver, timestamps,
                                        resolver.plan(frames[n], &timestamps), frames[n], n, run)
                                   .inputs;
    FloatImage image = resolved(device, resolver, inputs);
    if (done) done({frames[n], inputs, image});
    if (keep_images) run.images.push_back(std::move(image));
  }
  source.setTimestamps(nullptr);
  run.evaluations_per_pixel =
      evaluationsPerPixel(source.takeEvaluations(), source.info(), frames.size());
  return run;
}

std::vector<SequenceRun> runShared(Device& device, FrameSource& source,
                                   std::span<const std::unique_ptr<Resolver>> resolvers,
                                   std::span<const uint32_t> frames,
                                   const std::function<void(size_t, const FrameDone&)>& done) {
  std::vector<SequenceRun> runs(resolvers.size());
  Timestamps timestamps(device, kMaxSpans);
  source.setTimestamps(&timestamps);
  source.takeEvaluations();
  for (size_t n = 0; n < frames.size(); ++n) {
    std::vector<SamplePlan> plans;
    for (const auto& resolver : resolvers) plans.push_back(resolver->plan(frames[n], &timestamps));
    std::vector<bool> resolved_by(resolvers.size(), false);
    for (size_t first = 0; first < resolvers.size(); ++first) {
      if (resolved_by[first]) continue;
      const Rendered rendered = runFrame(device, source, *resolvers[first], timestamps,
                                         plans[first], frames[n], n, runs[first]);
      const double evaluations =
          evaluationsPerPixel(source.takeEvaluations(), source.info(), frames.size());
      for (size_t i = first; i < resolvers.size(); ++i) {
        if (i > first) {
          if (resolved_by[i] || !agree(plans[first], plans[i])) continue;
          device.submitAndWait([&](VkCommandBuffer commands) {
            timestamps.begin(commands);
            resolvers[i]->record(commands, rendered.inputs, &timestamps);
          });
          runs[i].resolve_times.add(n, timestamps.milliseconds());
          runs[i].render_times.add(n, rendered.spans);
        }
        resolved_by[i] = true;
        runs[i].evaluations_per_pixel += evaluations;
        if (done) {
          done(i, {frames[n], rendered.inputs, resolved(device, *resolvers[i], rendered.inputs)});
        }
      }
    }
  }
  source.setTimestamps(nullptr);
  return runs;
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
      runFrame(device, source, *resolvers[i], timestamps, resolvers[i]->plan(index, &timestamps),
               index, index, runs[i]);
      runs[i].evaluations_per_pixel +=
          evaluationsPerPixel(source.takeEvaluations(), source.info(), frames);
    }
    if (done) done();
  }
  source.setTimestamps(nullptr);
  return runs;
}

}  // namespace reprise::lab
