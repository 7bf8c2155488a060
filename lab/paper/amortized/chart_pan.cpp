// SPDX-License-Identifier: MIT
#include "lab/paper/amortized/chart_pan.h"

#include <fmt/format.h>

namespace reprise::lab::amortized {
namespace {

// A pan of the same length in metres has `scale` times the pixels a frame at `scale` the extent.
std::unique_ptr<SceneSource> openPan(Device& device, double vx, double vy, uint32_t scale) {
  SceneSourceOptions options;
  options.extent = {ChartPan::kSide_px * scale, ChartPan::kSide_px * scale};
  options.frames = ChartPan::kFrames;
  options.reference.cache = "none";
  const std::string run = fmt::format("chart/pan:vx={},vy={}", vx * scale, vy * scale);
  return std::make_unique<SceneSource>(device, parseSceneRun(run), options);
}

FloatImage redOf(const FloatImage& image) {
  FloatImage red(image.width, image.height, 1);
  for (size_t i = 0; i < red.texels.size(); ++i) red.texels[i] = image.texels[i * image.channels];
  return red;
}

FloatImage fineImage(Device& device, double vx, double vy) {
  const auto source = openPan(device, vx, vy, ChartPan::kFineScale);
  FrameInputs inputs;
  device.submitAndWait([&](VkCommandBuffer commands) {
    inputs = source->frame(commands, ChartPan::kFrames - 1, SamplePlan{});
  });
  return redOf(download(device, *inputs.color));
}

}  // namespace

ChartPan::ChartPan(Device& device, double vx, double vy)
    : device_(device),
      source_(openPan(device, vx, vy, 1)),
      fit_(fineImage(device, vx, vy), kFineScale, kMargin_px) {}

FloatImage ChartPan::run(const std::string& technique) {
  Resolver resolver(device_, parseTechnique(technique), source_->info());
  FloatImage last;
  runSequence(device_, *source_, resolver, kFrames, false, [&](const FrameDone& done) {
    if (done.index + 1 == kFrames) last = done.image;
  });
  return redOf(last);
}

}  // namespace reprise::lab::amortized
