// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <array>

#include "lab/vk/image.h"
#include "lab/vk/timestamps.h"

namespace reprise::lab {
namespace {

TEST(Device, ListsAtLeastOneUsableDevice) {
  const std::vector<DeviceSummary> devices = Device::list();
  ASSERT_FALSE(devices.empty());
  EXPECT_TRUE(std::any_of(devices.begin(), devices.end(), [](const auto& d) { return d.usable; }));
}

TEST(Device, UnknownSelectorIsOneClearLine) {
  try {
    Device device({.selector = "no such device"});
    FAIL() << "a device was found";
  } catch (const DeviceError& error) {
    EXPECT_STREQ(error.what(), "no device 'no such device' (see 'reprise list')");
  }
}

TEST(Image, EveryFormatRoundTrips) {
  Device device({.validation = Device::validationAvailable()});
  for (const VkFormat format :
       {VK_FORMAT_R32_SFLOAT, VK_FORMAT_R32G32_SFLOAT, VK_FORMAT_R16G16B16A16_SFLOAT,
        VK_FORMAT_R32G32B32A32_SFLOAT, VK_FORMAT_R32_UINT, VK_FORMAT_D32_SFLOAT}) {
    Image image(device, {.format = format, .extent = {5, 3}});
    FloatImage texels = floatsFromTexels(format, {5, 3}, std::vector<uint8_t>(5 * 3 * 16).data());
    for (size_t i = 0; i < texels.texels.size(); ++i) {
      // Exact in every format: small multiples of 1/64, whole for integers, within [0, 1] for
      // depth.
      const float step = format == VK_FORMAT_R32_UINT ? 1.0f : 1.0f / 64.0f;
      texels.texels[i] = static_cast<float>(i) * step;
    }
    upload(device, image, texels);
    EXPECT_EQ(download(device, image).texels, texels.texels) << "format " << format;
  }
  EXPECT_TRUE(device.validationMessages().empty()) << device.validationMessages().front();
}

TEST(Timestamps, SpansAreNamedAndNotNegative) {
  Device device({.validation = Device::validationAvailable()});
  Buffer buffer(device, 1 << 20, BufferKind::kDevice);
  Timestamps timestamps(device);
  device.submitAndWait([&](VkCommandBuffer commands) {
    timestamps.begin(commands);
    timestamps.start(commands, "fill");
    vkCmdFillBuffer(commands, buffer.handle(), 0, VK_WHOLE_SIZE, 7);
    timestamps.stop(commands);
  });
  const auto spans = timestamps.milliseconds();
  ASSERT_EQ(spans.size(), 1u);
  EXPECT_EQ(spans[0].first, "fill");
  EXPECT_GE(spans[0].second, 0.0);
  EXPECT_TRUE(device.validationMessages().empty()) << device.validationMessages().front();
}

}  // namespace
}  // namespace reprise::lab
