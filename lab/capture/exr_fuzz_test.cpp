// SPDX-License-Identifier: MIT
//
// Readers of files under random damage: they return or throw CaptureError, nothing else. Seeds are
// fixed; REPRISE_FUZZ_ROUNDS raises the number of rounds.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <random>

#include "lab/capture/capture_error.h"
#include "lab/capture/description.h"
#include "lab/capture/exr_file.h"
#include "lab/capture/output_file.h"
#include "lab/capture/temporary_directory.h"

namespace reprise::lab {
namespace {

int rounds(int otherwise) {
  const char* text = std::getenv("REPRISE_FUZZ_ROUNDS");
  return text != nullptr ? std::atoi(text) : otherwise;
}

std::string damaged(std::string bytes, std::mt19937& random) {
  const int hits = 1 + static_cast<int>(random() % 6);
  for (int i = 0; i < hits && !bytes.empty(); ++i) {
    const size_t at = random() % bytes.size();
    switch (random() % 4) {
      case 0:
        bytes[at] = static_cast<char>(random());
        break;
      case 1:
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << random() % 8));
        break;
      case 2:
        bytes.erase(at, 1 + random() % 8);
        break;
      default:
        bytes.insert(at, 1 + random() % 8, static_cast<char>(random()));
        break;
    }
  }
  return bytes;
}

TEST(Fuzz, ExrReader) {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "a.exr";
  std::vector<float> values(24 * 16, 0.5f);
  ExrImage image{24, 16, {}, nullptr};
  for (const char* name : {"color.R", "color.G", "color.B"}) {
    image.channels.push_back(exrChannel(name, ExrType::kHalf, values));
  }
  image.channels.push_back(exrChannel("depth.Z", ExrType::kFloat, values));
  writeExr(path, image);
  const std::string whole = readWholeFile(path);
  std::mt19937 random(7);
  int refused = 0;
  for (int round = 0; round < rounds(3000); ++round) {
    std::ofstream(path, std::ios::binary | std::ios::trunc) << damaged(whole, random);
    try {
      const ExrImage read = readExr(path);
      for (const ExrChannel& channel : read.channels) (void)channel.floats();
    } catch (const CaptureError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 0);
}

TEST(Fuzz, Description) {
  CaptureDescription description;
  description.extent = {24, 16};
  description.color_layer = "color";
  description.depth.channel = "depth.Z";
  description.motion.channels = {"motion.X", "motion.Y"};
  for (uint32_t i = 0; i < 3; ++i) {
    CaptureFrameInfo frame;
    frame.number = i + 1;
    frame.camera = CaptureCamera{0.1f, 10.0f, MatrixRows{1.0f}, MatrixRows{1.0f}};
    description.frames.push_back(frame);
  }
  const std::string whole = descriptionText(description);
  std::mt19937 random(11);
  int refused = 0;
  for (int round = 0; round < rounds(3000); ++round) {
    try {
      (void)parseDescription(damaged(whole, random), "capture.json");
    } catch (const CaptureError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 0);
}

}  // namespace
}  // namespace reprise::lab
