// SPDX-License-Identifier: MIT
//
// Misuse of the C API, call by call: each gives its code, one line that says what is wrong, and
// leaves the context as it was.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "formula_source.h"
#include "reprise/reprise.hpp"
#include "test_device.h"

namespace reprise::lab {
namespace {

constexpr VkExtent2D kExtent{32, 16};

struct Said {
  std::string text;
  uint32_t lines = 0;
};

void hear(RepriseMessageSeverity, const char* text, void* user) {
  auto* said = static_cast<Said*>(user);
  said->text = text;
  ++said->lines;
}

RepriseContextInfo goodInfo(Said& said) {
  Device& device = testDevice();
  RepriseContextInfo info{};
  info.size = sizeof(info);
  info.instance = device.instance();
  info.physical_device = device.physicalDevice();
  info.device = device.handle();
  info.get_instance_proc_addr = device.getInstanceProcAddr();
  info.technique = "taa";
  info.max_input_extent = kExtent;
  info.frames_in_flight = 2;
  info.depth_kind = REPRISE_DEPTH_PLANAR;
  info.message_callback = hear;
  info.message_user = &said;
  return info;
}

TEST(CreateContext, RefusesWhatCannotBe) {
  static const RepriseSettingValue unknown{"alhpa", 0.1, nullptr};
  static const RepriseSettingValue outside{"alpha", 2.0, nullptr};
  static const RepriseSettingValue no_number{"alpha", std::nan(""), nullptr};
  static const RepriseSettingValue no_choice{"clip", 0.0, "box"};
  static const RepriseSettingValue no_whole{"jitter_length", 2.5, nullptr};
  struct Case {
    const char* message;
    RepriseResult result;
    std::function<void(RepriseContextInfo&)> spoil;
  };
  const auto invalid = REPRISE_ERROR_INVALID_ARGUMENT;
  const Case cases[] = {
      {"info.instance is null", invalid, [](auto& i) { i.instance = VK_NULL_HANDLE; }},
      {"info.physical_device is null", invalid,
       [](auto& i) { i.physical_device = VK_NULL_HANDLE; }},
      {"info.device is null", invalid, [](auto& i) { i.device = VK_NULL_HANDLE; }},
      {"get_instance_proc_addr is null", invalid,
       [](auto& i) { i.get_instance_proc_addr = nullptr; }},
      {"info.technique is null", invalid, [](auto& i) { i.technique = nullptr; }},
      {"there is no technique 'tae'; near: 'taa'", invalid, [](auto& i) { i.technique = "tae"; }},
      {"preset", invalid, [](auto& i) { i.preset = "fsat"; }},
      {"info.settings is null", invalid, [](auto& i) { i.setting_count = 1; }},
      {"alhpa", invalid,
       [](auto& i) {
         i.settings = &unknown;
         i.setting_count = 1;
       }},
      {"alpha", invalid,
       [](auto& i) {
         i.settings = &outside;
         i.setting_count = 1;
       }},
      {"alpha", invalid,
       [](auto& i) {
         i.settings = &no_number;
         i.setting_count = 1;
       }},
      {"clip", invalid,
       [](auto& i) {
         i.settings = &no_choice;
         i.setting_count = 1;
       }},
      {"jitter_length", invalid,
       [](auto& i) {
         i.settings = &no_whole;
         i.setting_count = 1;
       }},
      {"0x16", invalid, [](auto& i) { i.max_input_extent.width = 0; }},
      {"must be in [1,", invalid, [](auto& i) { i.max_input_extent.height = 1u << 30; }},
      {"cannot upsample", REPRISE_ERROR_UNSUPPORTED,
       [](auto& i) {
         i.max_output_extent = {64, 32};
       }},
      {"frames_in_flight", invalid, [](auto& i) { i.frames_in_flight = 0; }},
      {"frames_in_flight", invalid, [](auto& i) { i.frames_in_flight = 9; }},
      {"depth_kind", invalid, [](auto& i) { i.depth_kind = static_cast<RepriseDepthKind>(77); }},
      {"info.flags", invalid, [](auto& i) { i.flags = 1u << 30; }},
  };
  for (const Case& c : cases) {
    SCOPED_TRACE(c.message);
    Said said;
    RepriseContextInfo info = goodInfo(said);
    c.spoil(info);
    RepriseContext context = reinterpret_cast<RepriseContext>(1);
    EXPECT_EQ(repriseCreateContext(&info, &context), c.result);
    EXPECT_EQ(context, nullptr);
    EXPECT_EQ(said.lines, 1u);
    EXPECT_NE(said.text.find(c.message), std::string::npos) << said.text;
    EXPECT_EQ(said.text.find('\n'), std::string::npos);
  }
  // Without a callback, or with a structure of another size, only the code says it.
  Said said;
  RepriseContextInfo info = goodInfo(said);
  RepriseContext context = nullptr;
  EXPECT_EQ(repriseCreateContext(nullptr, &context), invalid);
  EXPECT_EQ(repriseCreateContext(&info, nullptr), invalid);
  info.size -= 8;
  EXPECT_EQ(repriseCreateContext(&info, &context), invalid);
  info = goodInfo(said);
  info.message_callback = nullptr;
  info.technique = "nothing";
  EXPECT_EQ(repriseCreateContext(&info, &context), invalid);
  expectNoValidationMessages();
}

// A prepared context and a frame that it takes.
class Recording : public testing::Test {
 protected:
  Recording()
      : source(testDevice(), kExtent, {}),
        output(testDevice(), {.format = VK_FORMAT_R32G32B32A32_SFLOAT, .extent = kExtent}) {
    const RepriseContextInfo info = goodInfo(said);
    EXPECT_EQ(repriseCreateContext(&info, &context), REPRISE_SUCCESS);
    inputs = source.fill(0, {});
  }
  ~Recording() override {
    repriseDestroyContext(context);
    expectNoValidationMessages();
  }

  RepriseFrame goodFrame() const {
    const auto image = [](const Image& i) {
      return RepriseImage{i.view(), i.extent(), VK_IMAGE_LAYOUT_GENERAL};
    };
    RepriseFrame frame{};
    frame.size = sizeof(frame);
    frame.color = image(*inputs.color);
    frame.depth = image(*inputs.depth);
    frame.motion = image(*inputs.motion);
    frame.output = image(output);
    frame.motion_scale[0] = frame.motion_scale[1] = 1.0f;
    frame.near_plane = 0.1f;
    frame.far_plane = 100.0f;
    frame.pre_exposure = 1.0f;
    frame.frame_time_s = 0.016f;
    return frame;
  }
  RepriseResult record(const RepriseFrame& frame) {
    RepriseResult result = REPRISE_SUCCESS;
    testDevice().submitAndWait(
        [&](VkCommandBuffer commands) { result = repriseRecord(context, commands, &frame); });
    return result;
  }

  Said said;
  FormulaSource source;
  Image output;
  FrameInputs inputs;
  RepriseContext context = nullptr;
};

TEST_F(Recording, NothingBeforePrepare) {
  EXPECT_EQ(record(goodFrame()), REPRISE_ERROR_NOT_PREPARED);
  EXPECT_NE(said.text.find("reprisePrepare must be called"), std::string::npos);
  uint32_t count = 0;
  EXPECT_EQ(repriseGetMemory(context, nullptr, 0, &count), REPRISE_ERROR_NOT_PREPARED);
  EXPECT_EQ(repriseGetPassCount(context), 0u);
  EXPECT_EQ(repriseGetPassName(context, 0), nullptr);
  // The plan needs none.
  RepriseSamplePlan plan{};
  plan.size = sizeof(plan);
  EXPECT_EQ(repriseGetSamplePlan(context, 3, &plan), REPRISE_SUCCESS);
}

TEST_F(Recording, EachBadFieldIsNamed) {
  ASSERT_EQ(reprisePrepare(context), REPRISE_SUCCESS);
  static RepriseCamera camera{};
  camera.projection[0] = std::nanf("");
  const float nan = std::nanf("");
  struct Case {
    const char* message;
    std::function<void(RepriseFrame&)> spoil;
  };
  const Case cases[] = {
      {"frame.size", [](auto& f) { f.size = 8; }},
      {"color.view is null", [](auto& f) { f.color.view = VK_NULL_HANDLE; }},
      {"depth.view is null", [](auto& f) { f.depth.view = VK_NULL_HANDLE; }},
      {"motion.view is null", [](auto& f) { f.motion.view = VK_NULL_HANDLE; }},
      {"output.view is null", [](auto& f) { f.output.view = VK_NULL_HANDLE; }},
      {"color.extent 31x16 is smaller", [](auto& f) { f.color.extent.width = 31; }},
      {"output.extent 32x15 is smaller", [](auto& f) { f.output.extent.height = 15; }},
      {"color.layout must be", [](auto& f) { f.color.layout = VK_IMAGE_LAYOUT_UNDEFINED; }},
      {"input_extent 33x16",
       [](auto& f) {
         f.input_extent = {33, 16};
       }},
      {"input_extent 0x16",
       [](auto& f) {
         f.input_extent = {0, 16};
       }},
      {"cannot upsample",
       [](auto& f) {
         f.input_extent = {16, 8};
         f.output_extent = {32, 16};
       }},
      {"jitter_px", [](auto& f) { f.jitter_px[1] = 1.01f; }},
      {"jitter_px", [nan](auto& f) { f.jitter_px[0] = nan; }},
      {"motion_scale", [](auto& f) { f.motion_scale[0] = 0.0f; }},
      {"motion_scale", [nan](auto& f) { f.motion_scale[1] = nan; }},
      {"coarse_size", [](auto& f) { f.coarse_size = 5; }},
      {"coarse_origin_px",
       [](auto& f) {
         f.coarse_size = 2;
         f.coarse_origin_px[1] = 2;
       }},
      {"coarse_origin_px", [](auto& f) { f.coarse_origin_px[0] = -1; }},
      {"checkerboard", [](auto& f) { f.checkerboard = 3; }},
      {"pre_exposure", [](auto& f) { f.pre_exposure = 0.0f; }},
      {"pre_exposure", [nan](auto& f) { f.pre_exposure = nan; }},
      {"frame_time_s", [](auto& f) { f.frame_time_s = -1.0f; }},
      {"milliseconds", [](auto& f) { f.frame_time_s = 16.6f; }},
      {"camera.projection", [](auto& f) { f.camera = &camera; }},
      {"depth_samples.extent 31x16 is smaller",
       [](auto& f) {
         f.depth_samples = f.depth;
         f.depth_samples.extent.width = 31;
       }},
      {"depth_samples.layout must be",
       [](auto& f) {
         f.depth_samples = f.depth;
         f.depth_samples.layout = VK_IMAGE_LAYOUT_UNDEFINED;
       }},
  };
  ASSERT_EQ(record(goodFrame()), REPRISE_SUCCESS);
  for (const Case& c : cases) {
    SCOPED_TRACE(c.message);
    said = {};
    RepriseFrame frame = goodFrame();
    c.spoil(frame);
    EXPECT_LT(record(frame), REPRISE_SUCCESS);
    EXPECT_EQ(said.lines, 1u);
    EXPECT_NE(said.text.find(c.message), std::string::npos) << said.text;
    EXPECT_EQ(said.text.rfind("repriseRecord: ", 0), 0u) << said.text;
  }
  // After all that the context still works.
  EXPECT_EQ(record(goodFrame()), REPRISE_SUCCESS);
}

TEST_F(Recording, PlanesAreCheckedWhereTheyCount) {
  RepriseContextInfo info = goodInfo(said);
  info.depth_kind = REPRISE_DEPTH_DEVICE;
  RepriseContext device_depth = nullptr;
  ASSERT_EQ(repriseCreateContext(&info, &device_depth), REPRISE_SUCCESS);
  ASSERT_EQ(reprisePrepare(device_depth), REPRISE_SUCCESS);
  RepriseFrame frame = goodFrame();
  frame.far_plane = 0.05f;
  testDevice().submitAndWait([&](VkCommandBuffer commands) {
    EXPECT_EQ(repriseRecord(device_depth, commands, &frame), REPRISE_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(said.text.find("far_plane"), std::string::npos);
    frame.near_plane = 0.0f;
    EXPECT_EQ(repriseRecord(device_depth, commands, &frame), REPRISE_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(said.text.find("near_plane"), std::string::npos);
  });
  repriseDestroyContext(device_depth);
}

TEST_F(Recording, RequestsAreAskedForInOrder) {
  RepriseContextInfo request_info = goodInfo(said);
  request_info.technique = "amortized";
  request_info.settings = nullptr;
  request_info.setting_count = 0;
  RepriseContext amortized = nullptr;
  ASSERT_EQ(repriseCreateContext(&request_info, &amortized), REPRISE_SUCCESS);
  RepriseSampleRequests requests{};
  EXPECT_EQ(repriseGetSampleRequests(amortized, &requests), REPRISE_ERROR_INVALID_ARGUMENT);
  requests.size = sizeof(requests);
  EXPECT_EQ(repriseGetSampleRequests(amortized, &requests), REPRISE_ERROR_NOT_PREPARED);
  ASSERT_EQ(reprisePrepare(amortized), REPRISE_SUCCESS);
  EXPECT_EQ(repriseGetSampleRequests(amortized, &requests), REPRISE_SUCCESS);
  EXPECT_NE(requests.buffer, VkBuffer{VK_NULL_HANDLE});
  EXPECT_GT(requests.bytes, 16u);
  testDevice().submitAndWait([&](VkCommandBuffer commands) {
    RepriseFrame frame = goodFrame();
    frame.motion_back_count = REPRISE_MAX_MOTION_BACK + 1;
    EXPECT_EQ(repriseRecordRequest(amortized, commands, &frame), REPRISE_ERROR_INVALID_ARGUMENT);
    frame.motion_back_count = 1;  // and no list
    EXPECT_EQ(repriseRecord(amortized, commands, &frame), REPRISE_ERROR_INVALID_ARGUMENT);
    frame = goodFrame();
    RepriseFrame unshaded = frame;
    unshaded.color = {};
    unshaded.output = {};
    EXPECT_EQ(repriseRecordRequest(amortized, commands, &unshaded), REPRISE_SUCCESS);
    // Once a frame.
    EXPECT_EQ(repriseRecordRequest(amortized, commands, &unshaded), REPRISE_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(repriseRecord(amortized, commands, &unshaded), REPRISE_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(repriseRecord(amortized, commands, &frame), REPRISE_SUCCESS);
  });
  const RepriseSettingValue off{"requests", 0.0, "false"};
  EXPECT_EQ(repriseSetSettings(amortized, &off, 1), REPRISE_SUCCESS);
  ASSERT_EQ(reprisePrepare(amortized), REPRISE_SUCCESS);
  EXPECT_EQ(repriseGetSampleRequests(amortized, &requests), REPRISE_ERROR_UNSUPPORTED);
  repriseDestroyContext(amortized);
}

TEST_F(Recording, NullArguments) {
  const auto invalid = REPRISE_ERROR_INVALID_ARGUMENT;
  ASSERT_EQ(reprisePrepare(context), REPRISE_SUCCESS);
  const RepriseFrame frame = goodFrame();
  EXPECT_EQ(repriseRecord(context, VK_NULL_HANDLE, &frame), invalid);
  testDevice().submitAndWait([&](VkCommandBuffer commands) {
    EXPECT_EQ(repriseRecord(context, commands, nullptr), invalid);
    EXPECT_EQ(repriseRecord(nullptr, commands, &frame), invalid);
    EXPECT_EQ(repriseRecordRequest(context, commands, &frame), REPRISE_ERROR_UNSUPPORTED);
  });
  EXPECT_EQ(repriseGetSamplePlan(context, 0, nullptr), invalid);
  RepriseSamplePlan plan{};
  EXPECT_EQ(repriseGetSamplePlan(context, 0, &plan), invalid);  // size 0
  EXPECT_EQ(repriseGetMemory(context, nullptr, 0, nullptr), invalid);
  EXPECT_EQ(repriseGetMemory(context, nullptr, 4, nullptr), invalid);
  EXPECT_EQ(repriseSetSettings(context, nullptr, 1), invalid);
  EXPECT_EQ(repriseGetSetting(context, "alpha", nullptr), invalid);
  double value = 0.0;
  EXPECT_EQ(repriseGetSetting(context, "alhpa", &value), invalid);
  EXPECT_EQ(repriseGetSetting(context, nullptr, &value), invalid);
  EXPECT_EQ(reprisePrepare(nullptr), invalid);
  EXPECT_EQ(repriseReset(nullptr), invalid);
  EXPECT_EQ(repriseResize(nullptr, kExtent, kExtent), invalid);
  EXPECT_EQ(repriseResize(context, {0, 0}, {0, 0}), invalid);
  EXPECT_EQ(repriseGetPassCount(nullptr), 0u);
  EXPECT_EQ(repriseGetTechnique(1000), nullptr);
  EXPECT_EQ(repriseFindTechnique(nullptr), nullptr);
  EXPECT_STREQ(repriseResultText(static_cast<RepriseResult>(5)), "unknown result");
  repriseDestroyContext(nullptr);
  EXPECT_EQ(record(frame), REPRISE_SUCCESS);
}

TEST_F(Recording, ABadSettingAmongGoodOnesChangesNothing) {
  ASSERT_EQ(reprisePrepare(context), REPRISE_SUCCESS);
  double before = 0.0;
  ASSERT_EQ(repriseGetSetting(context, "alpha", &before), REPRISE_SUCCESS);
  const RepriseSettingValue values[] = {{"alpha", 0.5, nullptr}, {"gamma", -3.0, nullptr}};
  EXPECT_EQ(repriseSetSettings(context, values, 2), REPRISE_ERROR_INVALID_ARGUMENT);
  double after = 0.0;
  ASSERT_EQ(repriseGetSetting(context, "alpha", &after), REPRISE_SUCCESS);
  EXPECT_EQ(before, after);
}

TEST_F(Recording, SettingsThatRebuildWantPrepareAndKeepHistory) {
  ASSERT_EQ(reprisePrepare(context), REPRISE_SUCCESS);
  ASSERT_EQ(record(goodFrame()), REPRISE_SUCCESS);
  const RepriseSettingValue now{"alpha", 0.2, nullptr};
  ASSERT_EQ(repriseSetSettings(context, &now, 1), REPRISE_SUCCESS);
  EXPECT_EQ(record(goodFrame()), REPRISE_SUCCESS);
  const RepriseSettingValue rebuild{"clip", 0.0, "minmax"};
  ASSERT_EQ(repriseSetSettings(context, &rebuild, 1), REPRISE_SUCCESS);
  EXPECT_EQ(record(goodFrame()), REPRISE_ERROR_NOT_PREPARED);
  ASSERT_EQ(reprisePrepare(context), REPRISE_SUCCESS);
  EXPECT_EQ(record(goodFrame()), REPRISE_SUCCESS);
}

TEST_F(Recording, MemoryIsReportedImageByImage) {
  ASSERT_EQ(reprisePrepare(context), REPRISE_SUCCESS);
  uint32_t count = 0;
  ASSERT_EQ(repriseGetMemory(context, nullptr, 0, &count), REPRISE_SUCCESS);
  ASSERT_GT(count, 0u);
  std::vector<RepriseMemoryItem> items(count);
  ASSERT_EQ(repriseGetMemory(context, items.data(), count, &count), REPRISE_SUCCESS);
  EXPECT_STREQ(items[0].name, "history color");
  EXPECT_EQ(items[0].copies, 2u);
  EXPECT_GE(items[0].bytes, uint64_t{2} * 8 * kExtent.width * kExtent.height);
}

TEST(Plan, IsAPureFunctionOfTheFrameAndRepeatsAfterItsPeriod) {
  for (const std::string& name : everyTechnique()) {
    FormulaSource source(testDevice(), kExtent, {});
    Resolver resolver(testDevice(), parseTechnique(name), source.info());
    for (uint32_t frame = 0; frame < 40; ++frame) {
      const RepriseSamplePlan plan = resolver.plan(frame).library;
      const RepriseSamplePlan again = resolver.plan(frame).library;
      EXPECT_EQ(plan.jitter_px[0], again.jitter_px[0]);
      EXPECT_LE(std::abs(plan.jitter_px[0]), 1.0f);
      EXPECT_LE(std::abs(plan.jitter_px[1]), 1.0f);
      EXPECT_GE(plan.coarse_size, 1u);
      EXPECT_LE(plan.coarse_size, static_cast<uint32_t>(REPRISE_MAX_COARSE_SIZE));
      EXPECT_LE(plan.checkerboard, 2u);
      EXPECT_LE(plan.coarse_covered, plan.coarse_size - 1);
      for (const int32_t origin_px : plan.coarse_origin_px) {
        EXPECT_GE(origin_px, 0);
        EXPECT_LT(origin_px, static_cast<int32_t>(plan.coarse_size));
      }
      if (plan.period > 0) {
        EXPECT_EQ(resolver.plan(frame + plan.period).library.jitter_px[0], plan.jitter_px[0])
            << name;
      }
    }
  }
}

TEST(Requirements, AreMetByTheTestDeviceAndCheckedInWords) {
  Device& device = testDevice();
  RepriseRequirements requirements{};
  EXPECT_EQ(repriseGetRequirements("taa", VK_NULL_HANDLE, VK_NULL_HANDLE, nullptr, &requirements),
            REPRISE_ERROR_INVALID_ARGUMENT);  // size 0
  requirements.size = sizeof(requirements);
  EXPECT_EQ(repriseGetRequirements("taa", VK_NULL_HANDLE, VK_NULL_HANDLE, nullptr, &requirements),
            REPRISE_SUCCESS);
  EXPECT_GE(requirements.vulkan_version, VK_API_VERSION_1_2);
  EXPECT_EQ(repriseGetRequirements("taa", device.instance(), device.physicalDevice(),
                                   device.getInstanceProcAddr(), &requirements),
            REPRISE_SUCCESS);
  EXPECT_EQ(repriseGetRequirements("taa", VK_NULL_HANDLE, device.physicalDevice(), nullptr,
                                   &requirements),
            REPRISE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(repriseGetRequirements("tea", VK_NULL_HANDLE, VK_NULL_HANDLE, nullptr, &requirements),
            REPRISE_ERROR_INVALID_ARGUMENT);
}

}  // namespace
}  // namespace reprise::lab
