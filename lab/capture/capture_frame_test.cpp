// SPDX-License-Identifier: MIT
//
// Each kind of damage and each convention, on captures of a few pixels written here; and, where
// REPRISE_DATA points to them, on files of Blender.
#include "lab/capture/capture_frame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <functional>

#include "lab/capture/capture_error.h"
#include "lab/capture/layouts.h"
#include "lab/capture/output_file.h"
#include "lab/capture/temporary_directory.h"

namespace reprise::lab {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr uint32_t kWidth = 8;
constexpr uint32_t kHeight = 4;

// A capture of one frame, 8 x 4, grey 0.5, depth 2, motion (1, -2).
struct SmallCapture {
  SmallCapture() {
    description.extent = {kWidth, kHeight};
    description.color_layer = "color";
    description.depth.channel = "depth.Z";
    description.motion.channels = {"motion.X", "motion.Y"};
    description.frames.resize(1);
    description.frames[0].number = 1;
    const auto flat = [](float value) { return std::vector<float>(kWidth * kHeight, value); };
    color = flat(0.5f);
    depth = flat(2.0f);
    x = flat(1.0f);
    y = flat(-2.0f);
  }

  void write(ExrType color_type = ExrType::kHalf) const {
    ExrImage file{kWidth, kHeight, {}, nullptr};
    for (const char* name : {"color.R", "color.G", "color.B"}) {
      file.channels.push_back(exrChannel(name, color_type, color));
    }
    file.channels.push_back(exrChannel("depth.Z", ExrType::kFloat, depth));
    file.channels.push_back(exrChannel("motion.X", ExrType::kFloat, x));
    file.channels.push_back(exrChannel("motion.Y", ExrType::kFloat, y));
    writeExr(directory.path() / "frame_0001.exr", file);
  }
  CaptureFrame read() const { return readCaptureFrame(directory.path(), description, 0); }
  std::string error() const {
    try {
      read();
    } catch (const CaptureError& error) {
      return error.what();
    }
    return "no error";
  }

  TemporaryDirectory directory;
  CaptureDescription description;
  std::vector<float> color, depth, x, y;
};

TEST(CaptureFrame, ReadsWhatIsThere) {
  SmallCapture capture;
  capture.write();
  const CaptureFrame frame = capture.read();
  EXPECT_TRUE(frame.color_is_half);
  EXPECT_EQ(frame.color.size(), 8u * kWidth * kHeight);
  EXPECT_EQ(frame.depth[5], 2.0f);
  EXPECT_EQ(frame.motion[0], 1.0f);
  EXPECT_EQ(frame.motion[1], -2.0f);
  EXPECT_EQ(frame.repairs.total(), 0u);
  capture.write(ExrType::kFloat);
  EXPECT_FALSE(capture.read().color_is_half);
  EXPECT_EQ(capture.read().color.size(), 16u * kWidth * kHeight);
}

TEST(CaptureFrame, MotionConventions) {
  SmallCapture capture;
  capture.write();
  CaptureDescription::Motion& motion = capture.description.motion;
  motion.scale = {1.0f, -1.0f};
  EXPECT_EQ(capture.read().motion[1], 2.0f);
  motion.scale = {0.5f, 0.5f};
  motion.unit = MotionUnit::kUv;
  EXPECT_EQ(capture.read().motion[0], 0.5f * kWidth);
  EXPECT_EQ(capture.read().motion[1], -1.0f * kHeight);
  motion.unit = MotionUnit::kNdc;
  EXPECT_EQ(capture.read().motion[0], 0.25f * kWidth);
  motion.from_previous = true;
  EXPECT_EQ(capture.read().motion[0], -0.25f * kWidth);
}

TEST(CaptureFrame, NoNumbersAreCountedAndReplaced) {
  SmallCapture capture;
  capture.color[9] = kNan;
  capture.color[10] = kInfinity;
  capture.depth[3] = kNan;
  capture.depth[4] = kInfinity;  // what nothing covers, as some renderers write it
  capture.x[7] = kNan;
  capture.description.depth.background = 1000.0f;
  capture.write(ExrType::kFloat);
  const CaptureFrame frame = capture.read();
  EXPECT_EQ(frame.repairs.color, 2u);
  EXPECT_EQ(frame.repairs.depth, 1u);
  EXPECT_EQ(frame.repairs.motion, 1u);
  const auto* texels = reinterpret_cast<const float*>(frame.color.data());
  EXPECT_EQ(texels[4 * 9], 0.5f);
  EXPECT_EQ(texels[4 * 10], 0.5f);
  EXPECT_EQ(frame.depth[3], 1000.0f);
  EXPECT_EQ(frame.depth[4], 1000.0f);
  EXPECT_EQ(frame.motion[2 * 7], 0.0f);
  // A frame of nothing else is black.
  capture.color.assign(capture.color.size(), kNan);
  capture.write();
  EXPECT_EQ(capture.read().color[0], 0u);
  EXPECT_EQ(capture.read().repairs.color, uint64_t{kWidth} * kHeight);
}

TEST(CaptureFrame, RayDepthBecomesPlanar) {
  SmallCapture capture;
  capture.write();
  capture.description.depth.kind = CaptureDepth::kRay;
  EXPECT_NE(capture.error().find("frame 1: camera: depth of the kind 'ray' needs"),
            std::string::npos);
  MatrixRows projection{};
  projection[0] = 1.0f;
  projection[5] = 2.0f;
  projection[14] = -1.0f;
  capture.description.frames[0].camera = CaptureCamera{0.1f, 100.0f, std::nullopt, projection};
  const CaptureFrame frame = capture.read();
  // Pixel (0, 0): ndc (-0.875, 0.75), ray (-0.875, 0.375, -1).
  EXPECT_NEAR(frame.depth[0], 2.0 / std::sqrt(0.875 * 0.875 + 0.375 * 0.375 + 1.0), 1e-6);
}

TEST(CaptureFrame, BackgroundMotionComesFromTheCameras) {
  SmallCapture capture;
  capture.description.depth.background = 1000.0f;
  capture.description.motion.background_is_zero = true;
  capture.depth[0] = 1000.0f;
  capture.x[0] = capture.y[0] = 0.0f;
  capture.write();
  MatrixRows projection{};
  projection[0] = projection[5] = 1.0f;
  projection[14] = -1.0f;
  MatrixRows straight{};
  straight[0] = straight[5] = straight[10] = straight[15] = 1.0f;
  MatrixRows turned = straight;
  turned[0] = turned[10] = std::cos(0.1f);
  turned[2] = std::sin(0.1f);
  turned[8] = -std::sin(0.1f);
  auto& frames = capture.description.frames;
  frames.insert(frames.begin(), CaptureFrameInfo{});
  frames[0].camera = CaptureCamera{0.1f, 100.0f, straight, projection};
  frames[1].camera = CaptureCamera{0.1f, 100.0f, turned, projection};
  const CaptureFrame frame = readCaptureFrame(capture.directory.path(), capture.description, 1);
  EXPECT_GT(std::abs(frame.motion[0]), 0.1f);
  EXPECT_EQ(frame.motion[2], 1.0f);  // covered pixels keep theirs
}

TEST(CaptureFrame, EachKindOfDamageNamesFileFrameAndField) {
  SmallCapture capture;
  EXPECT_NE(capture.error().find("frame_0001.exr: there is no such file"), std::string::npos);
  capture.write();
  capture.description.depth.channel = "depth.W";
  EXPECT_NE(capture.error().find("frame_0001.exr: frame 1: depth: there is no channel 'depth.W'"),
            std::string::npos);
  capture.description.depth.channel = "depth.Z";
  capture.description.extent.width = 9;
  EXPECT_NE(capture.error().find("frame 1: extent: 8x4 where the sequence has 9x4"),
            std::string::npos);
  capture.description.extent.width = 8;
  capture.x[11] = 9.0f;
  capture.write();
  EXPECT_NE(capture.error().find("frame 1: motion: (9, -2) px at pixel (3, 1) is larger"),
            std::string::npos)
      << capture.error();
  const auto path = capture.directory.path() / "frame_0001.exr";
  std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
  EXPECT_NE(capture.error().find("frame_0001.exr: truncated or damaged"), std::string::npos);
}

TEST(Layouts, EngineFilesAreDescribedByTheirChannels) {
  SmallCapture capture;
  capture.write();
  const DetectedCapture planar = detectCapture(capture.directory.path(), CaptureLayout::kAuto);
  EXPECT_EQ(planar.description.color_layer, "color");
  EXPECT_EQ(planar.description.depthKind(), REPRISE_DEPTH_PLANAR);
  EXPECT_FALSE(planar.assumptions.empty());
  capture.depth.assign(capture.depth.size(), 0.5f);
  capture.write();
  EXPECT_EQ(detectCapture(capture.directory.path(), CaptureLayout::kEngine).description.depthKind(),
            REPRISE_DEPTH_REVERSED_INFINITE);
  EXPECT_THROW(detectCapture(capture.directory.path(), CaptureLayout::kBlender), CaptureError);
  // A gap in the numbers is a missing frame, not another sequence.
  std::filesystem::copy(capture.directory.path() / "frame_0001.exr",
                        capture.directory.path() / "frame_0003.exr");
  EXPECT_EQ(
      detectCapture(capture.directory.path(), CaptureLayout::kEngine).description.frames.size(),
      3u);
  std::filesystem::copy(capture.directory.path() / "frame_0001.exr",
                        capture.directory.path() / "other_0001.exr");
  EXPECT_THROW(detectCapture(capture.directory.path(), CaptureLayout::kEngine), CaptureError);
  EXPECT_THROW(detectCapture(TemporaryDirectory().path(), CaptureLayout::kAuto), CaptureError);
}

std::filesystem::path dataOr(const char* folder) {
  const char* root = std::getenv("REPRISE_DATA");
  return root == nullptr ? std::filesystem::path() : std::filesystem::path(root) / folder;
}

TEST(Blender, FilesAsBlenderWroteThem) {
  const std::filesystem::path directory = dataOr("blender-raw");
  if (!std::filesystem::exists(directory)) GTEST_SKIP() << "REPRISE_DATA holds no blender-raw";
  const DetectedCapture detected = detectCapture(directory, CaptureLayout::kAuto);
  EXPECT_EQ(detected.description.color_layer, "ViewLayer.Combined");
  ASSERT_EQ(detected.description.frames.size(), 2u);
  EXPECT_EQ(detected.description.frameFile(1), "room_0021.exr");
  const CaptureFrame frame = readCaptureFrame(directory, detected.description, 1);
  EXPECT_EQ(frame.repairs.total(), 0u);
  EXPECT_NE(frame.file.find("ViewLayer.Vector.W"), nullptr);
  // Metadata and layers come along.
  const TemporaryDirectory out;
  writeExr(out.path() / "a.exr", frame.file);
  const ExrImage back = readExr(out.path() / "a.exr");
  EXPECT_EQ(back.channels.size(), frame.file.channels.size());
  EXPECT_NE(readWholeFile(out.path() / "a.exr").find("BlenderMultiChannel"), std::string::npos);
}

}  // namespace
}  // namespace reprise::lab
