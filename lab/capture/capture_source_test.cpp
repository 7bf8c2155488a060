// SPDX-License-Identifier: MIT
#include "lab/capture/capture_source.h"

#include <gtest/gtest.h>

#include "lab/capture/capture_error.h"
#include "lab/capture/capture_writer.h"
#include "lab/capture/output_file.h"
#include "lab/capture/temporary_directory.h"

namespace reprise::lab {
namespace {

constexpr VkExtent2D kExtent{7, 5};

// Frames with images of the formats of live ones, written through CaptureWriter.
class Written {
 public:
  explicit Written(Device& device, bool resume = false, uint32_t frames = 3) : device_(device) {
    write(resume, frames);
  }

  void write(bool resume, uint32_t frames) {
    const Image color(device_, {.format = VK_FORMAT_R16G16B16A16_SFLOAT, .extent = kExtent});
    const Image depth(device_, {.format = VK_FORMAT_R32_SFLOAT, .extent = kExtent});
    const Image motion(device_, {.format = VK_FORMAT_R32G32_SFLOAT, .extent = kExtent});
    SourceInfo info{.name = "test",
                    .extent = kExtent,
                    .frame_count = frames,
                    .frame_rate = 50.0,
                    .depth_kind = REPRISE_DEPTH_REVERSED_INFINITE,
                    .reference_samples = 4};
    CaptureWriter writer(directory.path(), info, "taa", resume);
    for (uint32_t i = 0; i < frames; ++i) {
      fill(color, 0.1f + static_cast<float>(i));
      fill(depth, 0.01f);
      fill(motion, 0.25f);
      FrameInputs inputs;
      inputs.index = i;
      inputs.extent = kExtent;
      inputs.color = &color;
      inputs.depth = &depth;
      inputs.motion = &motion;
      inputs.jitter_px[0] = 0.1f * static_cast<float>(i);
      inputs.near_plane = 0.05f;
      inputs.camera = RepriseCamera{};
      inputs.reset = i == 0;
      writer.add(device_, inputs);
      writer.addReference(FloatImage(kExtent.width, kExtent.height, 3));
      color_bytes.push_back(downloadBytes(device_, color));
    }
    kept = writer.kept();
    writer.finish();
  }

  TemporaryDirectory directory;
  std::vector<std::vector<uint8_t>> color_bytes;
  uint32_t kept = 0;

 private:
  void fill(const Image& image, float first) {
    const uint32_t channels = image.format() == VK_FORMAT_R16G16B16A16_SFLOAT ? 4
                              : image.format() == VK_FORMAT_R32G32_SFLOAT     ? 2
                                                                              : 1;
    FloatImage texels(kExtent.width, kExtent.height, channels);
    for (size_t i = 0; i < texels.texels.size(); ++i) {
      texels.texels[i] =
          channels == 4 && i % 4 == 3 ? 1.0f : first + 0.013f * static_cast<float>(i % 64);
    }
    upload(device_, image, texels);
  }

  Device& device_;
};

TEST(CaptureSource, GivesBackTheWritersImagesBitForBit) {
  Device device;
  const Written written(device);
  CaptureSource source(device, written.directory.path());
  EXPECT_EQ(source.info().frame_count, 3u);
  EXPECT_EQ(source.info().depth_kind, REPRISE_DEPTH_REVERSED_INFINITE);
  EXPECT_EQ(source.info().reference_samples, 4u);
  // Out of order and again: any frame at any time.
  for (uint32_t index : {0u, 1u, 2u, 0u, 2u, 2u}) {
    FrameInputs inputs;
    device.submitAndWait(
        [&](VkCommandBuffer commands) { inputs = source.frame(commands, index, {}); });
    EXPECT_EQ(downloadBytes(device, *inputs.color), written.color_bytes[index]) << index;
    EXPECT_EQ(inputs.jitter_px[0], 0.1f * static_cast<float>(index));
    EXPECT_EQ(inputs.near_plane, 0.05f);
    EXPECT_EQ(inputs.reset, index == 0);
    EXPECT_TRUE(inputs.camera.has_value());
    EXPECT_FLOAT_EQ(source.geometry(index).motion_px.texels[0], 0.25f);
  }
  EXPECT_TRUE(source.reference(1).has_value());
}

TEST(CaptureSource, AMissingFrameIsFoundBeforeWorkBegins) {
  Device device;
  const Written written(device);
  std::filesystem::remove(written.directory.path() / "frame_0002.exr");
  try {
    CaptureSource source(device, written.directory.path());
    FAIL() << "no error";
  } catch (const CaptureError& error) {
    EXPECT_NE(std::string(error.what()).find("frame_0002.exr: frame 2: the file is missing"),
              std::string::npos);
  }
  EXPECT_THROW(CaptureSource(device, written.directory.path() / "nowhere"), CaptureError);
}

TEST(CaptureSource, ADamagedFrameIsToldWhenItsTurnComes) {
  Device device;
  const Written written(device);
  const auto path = written.directory.path() / "frame_0002.exr";
  std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
  CaptureSource source(device, written.directory.path());
  device.submitAndWait([&](VkCommandBuffer commands) { source.frame(commands, 0, {}); });
  EXPECT_THROW(
      device.submitAndWait([&](VkCommandBuffer commands) { source.frame(commands, 1, {}); }),
      CaptureError);
  // The device is still good.
  device.submitAndWait([&](VkCommandBuffer commands) { source.frame(commands, 2, {}); });
}

TEST(CaptureWriter, ResumeKeepsWholeFilesAndReplacesDamagedOnes) {
  Device device;
  Written written(device);
  EXPECT_EQ(written.kept, 0u);
  const auto path = written.directory.path() / "frame_0003.exr";
  const std::string whole = readWholeFile(path);
  std::filesystem::resize_file(path, 100);
  written.write(true, 3);
  EXPECT_EQ(written.kept, 2u);
  EXPECT_EQ(readWholeFile(path).size(), whole.size());
}

}  // namespace
}  // namespace reprise::lab
