// SPDX-License-Identifier: MIT
//
// Several techniques over one sequence at once come out as each by itself does.
#include "lab/run/sequence_run.h"

#include <gtest/gtest.h>

#include <numeric>
#include <utility>

#include "lab/render/scene_source.h"
#include "lab/run/technique_choice.h"
#include "tests/test_device.h"

namespace reprise::lab {
namespace {

constexpr VkExtent2D kExtent{32, 18};
constexpr uint32_t kFrames = 5;

SceneSourceOptions small() {
  SceneSourceOptions options;
  options.extent = kExtent;
  options.frames = kFrames;
  options.reference.cache = "none";
  return options;
}

// Writes down for which frames and plans it was asked.
class Logged final : public FrameSource {
 public:
  explicit Logged(Device& device) : source_(device, parseSceneRun("brick/pan"), small()) {}

  const SourceInfo& info() const override { return source_.info(); }
  void prepare(const SamplePlan& plan) override { source_.prepare(plan); }
  FrameInputs frame(VkCommandBuffer commands, uint32_t index, const SamplePlan& plan) override {
    asked.push_back({index, plan.library.checkerboard});
    return source_.frame(commands, index, plan);
  }
  std::optional<FloatImage> reference(uint32_t index) override { return source_.reference(index); }
  FrameGeometry geometry(uint32_t index) override { return source_.geometry(index); }
  void setTimestamps(Timestamps* timestamps) override { source_.setTimestamps(timestamps); }
  uint64_t takeEvaluations() override { return source_.takeEvaluations(); }

  std::vector<std::pair<uint32_t, uint32_t>> asked;

 private:
  SceneSource source_;
};

using Resolvers = std::vector<std::unique_ptr<Resolver>>;

Resolvers resolversOf(Device& device, const std::vector<std::string>& techniques,
                      const SourceInfo& info) {
  Resolvers resolvers;
  for (const std::string& technique : techniques) {
    resolvers.push_back(std::make_unique<Resolver>(device, parseTechnique(technique), info));
  }
  return resolvers;
}

SequenceRun alone(Device& device, const std::string& technique) {
  Logged source(device);
  Resolver resolver(device, parseTechnique(technique), source.info());
  return runSequence(device, source, resolver, kFrames, true, nullptr);
}

// Times are a machine's; that there is one a frame of each pass is not.
void expectTimedAs(const PassTimes& run, const PassTimes& alone) {
  ASSERT_EQ(run.all().size(), alone.all().size());
  for (size_t i = 0; i < run.all().size(); ++i) {
    EXPECT_EQ(run.all()[i].first, alone.all()[i].first);
    EXPECT_EQ(run.all()[i].second.size(), kFrames) << run.all()[i].first;
  }
}

void expectCountedAs(const SequenceRun& run, const SequenceRun& alone) {
  EXPECT_GT(alone.evaluations_per_pixel, 0.0);
  EXPECT_NEAR(run.evaluations_per_pixel, alone.evaluations_per_pixel, 1e-9);
  expectTimedAs(run.render_times, alone.render_times);
  expectTimedAs(run.resolve_times, alone.resolve_times);
}

// A driver may take a timestamp when it next has to: lavapipe took that before a pass that reads
// nothing drawn after the pass, which then had 0.001 of the resolve's time and not a tenth.
TEST(SequenceRun, APassThatReadsNothingDrawnHasItsTime) {
  Device& device = testDevice();
  SceneSourceOptions options = small();
  options.extent = {320, 180};
  SceneSource source(device, parseSceneRun("brick/pan"), options);
  Resolver resolver(device, parseTechnique("cpst"), source.info());
  const SequenceRun run = runSequence(device, source, resolver, kFrames, false, nullptr);
  double moments_ms = 0.0;
  double resolve_ms = 0.0;
  for (const auto& [name, ms] : run.resolve_times.medians(1)) {
    if (name == "moments") moments_ms = ms;
    if (name == "resolve") resolve_ms = ms;
  }
  EXPECT_GT(resolve_ms, 0.0);
  EXPECT_GT(moments_ms, 0.02 * resolve_ms);
}

TEST(SequenceRun, TogetherIsInTurnFrameByFrame) {
  Device& device = testDevice();
  const std::vector<std::string> techniques = {"taa", "checkerboard", "taa:alpha=0.5"};
  Logged source(device);
  const Resolvers resolvers = resolversOf(device, techniques, source.info());
  uint32_t done = 0;
  const std::vector<SequenceRun> runs =
      runTogether(device, source, resolvers, kFrames, [&] { ++done; });
  EXPECT_EQ(done, kFrames);
  ASSERT_EQ(runs.size(), techniques.size());
  ASSERT_EQ(source.asked.size(), kFrames * techniques.size());
  for (size_t n = 0; n < source.asked.size(); ++n) {
    const auto& [frame, checkerboard] = source.asked[n];
    EXPECT_EQ(frame, n / techniques.size());
    EXPECT_EQ(checkerboard != 0, n % techniques.size() == 1);
  }
  for (size_t i = 0; i < techniques.size(); ++i) {
    const SequenceRun by_itself = alone(device, techniques[i]);
    expectCountedAs(runs[i], by_itself);
    EXPECT_EQ(download(device, resolvers[i]->output()).texels, by_itself.images.back().texels)
        << techniques[i];
  }
  expectNoValidationMessages();
}

TEST(SequenceRun, WhatSamplesAlikeIsRenderedOnce) {
  Device& device = testDevice();
  const std::vector<std::string> techniques = {"taa", "checkerboard", "taa:alpha=0.5",
                                               "checkerboard:alpha=0.5"};
  Logged source(device);
  const Resolvers resolvers = resolversOf(device, techniques, source.info());
  std::vector<uint32_t> frames(kFrames);
  std::iota(frames.begin(), frames.end(), 0u);
  std::vector<std::vector<FloatImage>> images(techniques.size());
  const std::vector<SequenceRun> runs =
      runShared(device, source, resolvers, frames, [&](size_t i, const FrameDone& frame) {
        EXPECT_EQ(frame.index, images[i].size());
        images[i].push_back(frame.image);
      });
  EXPECT_EQ(source.asked.size(), kFrames * 2);
  for (size_t i = 0; i < techniques.size(); ++i) {
    const SequenceRun by_itself = alone(device, techniques[i]);
    expectCountedAs(runs[i], by_itself);
    ASSERT_EQ(images[i].size(), kFrames);
    for (uint32_t frame = 0; frame < kFrames; ++frame) {
      EXPECT_EQ(images[i][frame].texels, by_itself.images[frame].texels)
          << techniques[i] << ", " << frame;
    }
  }
  EXPECT_NE(images[0].back().texels, images[2].back().texels);
  expectNoValidationMessages();
}

}  // namespace
}  // namespace reprise::lab
