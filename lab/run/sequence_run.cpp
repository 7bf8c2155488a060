// SPDX-License-Identifier: MIT
#include "lab/run/sequence_run.h"

#include <algorithm>
#include <cmath>

#include "lab/run/interrupt.h"

namespace reprise::lab {
namespace {

// Passes of a source with many samples repeat; 2048 spans hold a 16 x 16 grid and all resolves.
constexpr uint32_t kMaxSpans = 2048;

float medianLength(const FloatImage& motion) {
  std::vector<float> lengths(motion.texelCount());
  for (size_t i = 0; i < lengths.size(); ++i) {
    lengths[i] = std::hypot(motion.texels[2 * i], motion.texels[2 * i + 1]);
  }
  if (lengths.empty()) return 0.0f;
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

// Adds spans of one frame, summed by name, as one entry a name.
void addSpans(const std::vector<std::pair<std::string, double>>& spans, size_t frame,
              std::vector<std::pair<std::string, std::vector<double>>>& pass_ms) {
  for (const auto& [name, ms] : spans) {
    auto pass = std::find_if(pass_ms.begin(), pass_ms.end(),
                             [&name = name](const auto& known) { return known.first == name; });
    if (pass == pass_ms.end()) pass = pass_ms.insert(pass_ms.end(), {name, {}});
    pass->second.resize(frame + 1, 0.0);
    pass->second[frame] += ms;
  }
}

}  // namespace

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

SequenceRun runSequence(Device& device, FrameSource& source, Resolver& resolver, uint32_t frames,
                        bool keep_images, const std::function<void(const FrameDone&)>& done) {
  SequenceRun run;
  Timestamps timestamps(device, kMaxSpans);
  source.setTimestamps(&timestamps);
  source.takeEvaluations();
  run.resolve_passes = resolver.passNames();
  const SourceInfo& info = source.info();
  for (uint32_t index = 0; index < frames; ++index) {
    throwIfInterrupted();
    FrameInputs inputs;
    device.submitAndWait([&](VkCommandBuffer commands) {
      timestamps.begin(commands);
      inputs = source.frame(commands, index, resolver.plan(index));
      resolver.record(commands, inputs, &timestamps);
    });
    addSpans(timestamps.milliseconds(), index, run.pass_ms);
    run.median_motion_px.push_back(medianLength(source.motion(index)));
    FloatImage image = download(device, resolver.output());
    if (done) done({index, inputs, image});
    if (keep_images) run.images.push_back(std::move(image));
  }
  source.setTimestamps(nullptr);
  const double pixels = static_cast<double>(info.extent.width) * info.extent.height * frames;
  run.evaluations_per_pixel = static_cast<double>(source.takeEvaluations()) / pixels;
  return run;
}

}  // namespace reprise::lab
