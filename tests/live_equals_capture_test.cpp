// SPDX-License-Identifier: MIT
//
// A capture of a scene, filtered from disk, gives bit for bit what the live run gives.
#include <gtest/gtest.h>

#include <cstring>

#include "lab/capture/capture_source.h"
#include "lab/capture/capture_writer.h"
#include "lab/capture/temporary_directory.h"
#include "lab/render/scene_source.h"
#include "lab/run/sequence_run.h"

namespace reprise::lab {
namespace {

constexpr uint32_t kFrames = 6;

std::vector<FloatImage> run(Device& device, FrameSource& source, const char* technique) {
  Resolver resolver(device, parseTechnique(technique), source.info());
  return runSequence(device, source, resolver, kFrames, true, {}).images;
}

class LiveEqualsCapture : public testing::TestWithParam<const char*> {};

TEST_P(LiveEqualsCapture, BitForBit) {
  Device device({.validation = Device::validationAvailable()});
  const TemporaryDirectory directory;
  SceneSourceOptions options;
  options.extent = {97, 61};
  options.frames = kFrames;
  options.reference.samples = 2;
  options.reference.cache = "none";
  for (const char* scene : {"brick/rotate", "chart/pan:vx=0.37,vy=0.21"}) {
    SceneSource live(device, parseSceneRun(scene), options);
    {
      Resolver plan(device, parseTechnique(GetParam()), live.info());
      CaptureWriter writer(directory.path(), live.info(), GetParam(), false);
      for (uint32_t index = 0; index < kFrames; ++index) {
        FrameInputs inputs;
        device.submitAndWait([&](VkCommandBuffer commands) {
          SamplePlan sampling = plan.plan(index);
          sampling.request = {};
          inputs = live.frame(commands, index, sampling);
        });
        writer.add(device, inputs);
      }
      writer.finish();
    }
    const std::vector<FloatImage> expected = run(device, live, GetParam());
    CaptureSource capture(device, directory.path());
    const std::vector<FloatImage> filtered = run(device, capture, GetParam());
    ASSERT_EQ(filtered.size(), expected.size());
    for (uint32_t i = 0; i < kFrames; ++i) {
      ASSERT_EQ(std::memcmp(filtered[i].texels.data(), expected[i].texels.data(),
                            expected[i].texels.size() * sizeof(float)),
                0)
          << scene << ", frame " << i;
    }
  }
  for (const std::string& message : device.validationMessages()) ADD_FAILURE() << message;
}

INSTANTIATE_TEST_SUITE_P(Techniques, LiveEqualsCapture,
                         testing::Values("taa", "taa:preset=fast", "reprojection",
                                         "taa:motion_tolerance_px=1,sharpen=0.5", "taa:average=4"));

}  // namespace
}  // namespace reprise::lab
