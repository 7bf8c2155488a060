// SPDX-License-Identifier: MIT
#include "lab/capture/exr_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cmath>
#include <csignal>
#include <cstring>
#include <fstream>
#include <limits>

#include "lab/capture/capture_error.h"
#include "lab/capture/output_file.h"
#include "lab/capture/png_file.h"
#include "lab/capture/temporary_directory.h"

namespace reprise::lab {
namespace {

ExrImage sampleImage(uint32_t width, uint32_t height) {
  std::vector<float> values(size_t{width} * height);
  for (size_t i = 0; i < values.size(); ++i) values[i] = 0.37f * static_cast<float>(i) - 3.0f;
  ExrImage image{width, height, {}, nullptr};
  image.channels.push_back(exrChannel("A.half", ExrType::kHalf, values));
  image.channels.push_back(exrChannel("B.float", ExrType::kFloat, values));
  for (float& value : values) value = std::abs(value);
  image.channels.push_back(exrChannel("C.uint", ExrType::kUint, values));
  return image;
}

std::string errorOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const CaptureError& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    return error.what();
  }
  return "";
}

TEST(Exr, EveryTypeComesBackBitForBit) {
  const TemporaryDirectory directory;
  for (const auto& [width, height] : {std::pair{257u, 89u}, {1u, 1u}, {3u, 200u}}) {
    const ExrImage image = sampleImage(width, height);
    writeExr(directory.path() / "a.exr", image);
    const ExrImage read = readExr(directory.path() / "a.exr");
    ASSERT_EQ(read.width, width);
    ASSERT_EQ(read.height, height);
    ASSERT_EQ(read.channels.size(), 3u);
    for (const ExrChannel& channel : image.channels) {
      const ExrChannel* other = read.find(channel.name);
      ASSERT_NE(other, nullptr);
      EXPECT_EQ(other->type, channel.type);
      EXPECT_EQ(other->texels, channel.texels) << channel.name;
    }
  }
}

TEST(Exr, SpecialValuesSurvive) {
  const TemporaryDirectory directory;
  const std::vector<float> values{0.0f,
                                  -0.0f,
                                  std::numeric_limits<float>::infinity(),
                                  std::numeric_limits<float>::quiet_NaN(),
                                  65504.0f,
                                  6.0e-8f};
  ExrImage image{6, 1, {}, nullptr};
  image.channels.push_back(exrChannel("R", ExrType::kHalf, values));
  writeExr(directory.path() / "a.exr", image);
  const std::vector<float> read = readExr(directory.path() / "a.exr").find("R")->floats();
  EXPECT_TRUE(std::signbit(read[1]));
  EXPECT_TRUE(std::isinf(read[2]));
  EXPECT_TRUE(std::isnan(read[3]));
  EXPECT_EQ(read[4], 65504.0f);
  EXPECT_GT(read[5], 0.0f);
}

TEST(Exr, DamageIsOneLineThatNamesTheFile) {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "a.exr";
  EXPECT_NE(errorOf([&] { readExr(path); }).find("a.exr: there is no such file"),
            std::string::npos);
  writeExr(path, sampleImage(64, 64));
  const std::string whole = readWholeFile(path);
  for (size_t size : {size_t{0}, size_t{3}, size_t{100}, whole.size() / 2, whole.size() - 10}) {
    std::ofstream(path, std::ios::binary | std::ios::trunc) << whole.substr(0, size);
    EXPECT_NE(errorOf([&] { readExr(path); }).find("a.exr"), std::string::npos) << size;
  }
  std::ofstream(path, std::ios::trunc) << "not an image at all, but text";
  EXPECT_NE(errorOf([&] { readExr(path); }).find("damaged"), std::string::npos);
}

TEST(OutputFile, ReplacesWholeAndLeavesNothingHalf) {
  const TemporaryDirectory directory;
  const auto path = directory.path() / "a.txt";
  writeOutputFile(path, "one");
  writeOutputFile(path, "two");
  EXPECT_EQ(readWholeFile(path), "two");

  // A full disk, as the file system would say it: no file may grow past 16 bytes.
  const auto before = std::signal(SIGXFSZ, SIG_IGN);
  rlimit limit{};
  getrlimit(RLIMIT_FSIZE, &limit);
  const rlimit small{16, limit.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string error = errorOf([&] { writeOutputFile(path, std::string(100, 'x')); });
  setrlimit(RLIMIT_FSIZE, &limit);
  std::signal(SIGXFSZ, before);
  EXPECT_NE(error.find("a.txt: cannot be written"), std::string::npos);
  EXPECT_EQ(readWholeFile(path), "two");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(directory.path()), {}), 1);

  EXPECT_NE(errorOf([&] { makeOutputDirectory(path / "below"); }).find("cannot be created"),
            std::string::npos);
  EXPECT_NE(errorOf([&] { writeOutputFile("/proc/nowhere/a", "x"); }).find("cannot be written"),
            std::string::npos);
}

TEST(Png, HasTheSignatureAndTheSize) {
  const std::string png = encodePng(FloatImage(257, 89, 3));
  ASSERT_GT(png.size(), 24u);
  EXPECT_EQ(png.substr(1, 3), "PNG");
  EXPECT_EQ(static_cast<uint8_t>(png[18]) * 256 + static_cast<uint8_t>(png[19]), 257);
  EXPECT_EQ(static_cast<uint8_t>(png[23]), 89);
}

}  // namespace
}  // namespace reprise::lab
