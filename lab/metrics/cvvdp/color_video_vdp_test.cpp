// SPDX-License-Identifier: MIT
//
// Figures of the authors' implementation (gfxdisp/ColorVideoVDP, commit 7ca201a, version 0.5.6) for
// images that are formulas. Its table is not part of this project: what needs it is skipped where
// REPRISE_DATA does not lead to cvvdp/csf_lut_weber_fixed_size.json.
#include "lab/metrics/cvvdp/color_video_vdp.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <optional>

#include "lab/metrics/cvvdp/pyramid.h"

namespace reprise::lab {
namespace {

constexpr uint32_t kWidth = 160;
constexpr uint32_t kHeight = 128;
// The implementation is in float, as the authors' is.
constexpr double kJodTolerance = 2.0e-4;

using Encoded = std::function<void(int x, int y, double* rgb)>;

// Display-encoded formula to display light.
FloatImage lightOf(const Encoded& encoded) {
  FloatImage image(kWidth, kHeight, 3);
  for (uint32_t y = 0; y < kHeight; ++y) {
    for (uint32_t x = 0; x < kWidth; ++x) {
      double rgb[3];
      encoded(static_cast<int>(x), static_cast<int>(y), rgb);
      for (size_t c = 0; c < 3; ++c) {
        const double v = std::min(std::max(rgb[c], 0.0), 1.0);
        image.at(x, y)[c] =
            static_cast<float>(v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
      }
    }
  }
  return image;
}

void fill(double* rgb, double v) {
  rgb[0] = rgb[1] = rgb[2] = v;
}
double ramp(int x) {
  return x / 159.0;
}
double checker(int x, int y, int side) {
  return (x / side + y / side) % 2 != 0 ? 1.0 : -1.0;
}
void hashed(int x, int y, double* rgb) {
  rgb[0] = ((7 * x + 13 * y) & 255) / 255.0;
  rgb[1] = ((x * x + y * y) & 255) / 255.0;
  rgb[2] = ((x * y) & 255) / 255.0;
}

std::optional<CsfTable> table() {
  const char* root = std::getenv("REPRISE_DATA");
  if (root == nullptr) return std::nullopt;
  const auto file = std::filesystem::path(root) / "cvvdp" / CsfTable::kFileName;
  if (!std::filesystem::exists(file)) return std::nullopt;
  return CsfTable::load(file);
}

TEST(ColorVideoVdp, OpponentColoursOfTheAuthors) {
  FloatImage colors(4, 1, 3);
  const float half = static_cast<float>(std::pow((0.5 + 0.055) / 1.055, 2.4));
  colors.texels = {1, 1, 1, half, half, half, 1, 0, 0, 0, 0, 1};
  const FloatImage dkl = opponentImage(colors, kVdpStandard4k);
  const float expected[] = {210.62375f, 0.75655f,  2.06955f,   45.57605f, 0.16371f,  0.44782f,
                            47.222f,    25.50089f, -42.91536f, 18.40977f, -7.34587f, 170.11656f};
  for (size_t i = 0; i < 12; ++i) EXPECT_NEAR(dkl.texels[i], expected[i], 3.0e-4f) << i;
}

TEST(ColorVideoVdp, TemporalFiltersOfTheAuthors) {
  const auto slow = temporalTaps(30.0);
  ASSERT_EQ(slow[0].size(), 9u);
  const float sustained[] = {0.04677f, 0.06419f, 0.10737f, 0.17481f, 0.21373f};
  const float transient[] = {-0.10166f, -0.11034f, -0.15002f, 0.03139f, 0.66126f};
  for (size_t i = 0; i < 5; ++i) {
    EXPECT_NEAR(slow[0][i], sustained[i], 1e-5f);
    EXPECT_NEAR(slow[0][8 - i], sustained[i], 1e-5f);
    EXPECT_NEAR(slow[3][i], transient[i], 1e-5f);
  }
  const auto fast = temporalTaps(60.0);
  ASSERT_EQ(fast[0].size(), 17u);
  EXPECT_NEAR(fast[0][8], 0.11317f, 1e-5f);
  EXPECT_NEAR(fast[3][8], 0.43322f, 1e-5f);
}

TEST(ColorVideoVdp, JodIsContinuousAndFalls) {
  EXPECT_EQ(jodFromQuality(0.0), 10.0);
  EXPECT_NEAR(jodFromQuality(0.1 - 1e-9), jodFromQuality(0.1 + 1e-9), 1e-8);
  EXPECT_LT(jodFromQuality(20.0), jodFromQuality(10.0));
}

TEST(ColorVideoVdp, APyramidKeepsFlatImagesFlat) {
  for (const auto& [width, height] : {std::pair{16u, 12u}, {15u, 9u}, {8u, 8u}}) {
    FloatImage flat(width, height, 1);
    for (float& v : flat.texels) v = 3.0f;
    const FloatImage half = reduced(flat);
    EXPECT_EQ(half.width, (width + 1) / 2);
    EXPECT_EQ(half.height, (height + 1) / 2);
    for (float v : half.texels) ASSERT_NEAR(v, 3.0f, 1e-5f);
    for (float v : expanded(half, width, height).texels) ASSERT_NEAR(v, 3.0f, 1e-5f);
    for (float v : maskingBlur(flat).texels) ASSERT_NEAR(v, 3.0f, 1e-5f);
  }
}

TEST(CsfTable, SensitivitiesOfTheAuthorsAndBadFiles) {
  const auto loaded = table();
  if (!loaded) GTEST_SKIP() << "REPRISE_DATA holds no cvvdp";
  const struct {
    double frequency;
    float luminance;
    float s[4];
  } cases[] = {{1, 100, {151.46f, 351.16f, 79.227f, 305.19f}},
               {4, 100, {311.98f, 190.68f, 40.359f, 240.99f}},
               {16, 100, {57.376f, 52.990f, 11.260f, 43.701f}},
               {4, 1, {60.861f, 37.948f, 9.3994f, 30.832f}}};
  for (const auto& c : cases) {
    const auto s = loaded->at(c.frequency).sensitivity(c.luminance);
    for (size_t i = 0; i < 4; ++i) EXPECT_NEAR(s[i], c.s[i], 2e-4f * c.s[i]) << c.frequency << i;
  }
}

TEST(CsfTable, BadFilesAreOneLineThatNamesThem) {
  EXPECT_THROW(CsfTable::load("nowhere.json"), std::runtime_error);
  const auto file = std::filesystem::path(testing::TempDir()) / "damaged_csf.json";
  for (const char* text : {"{", "[]", R"({"L_bkg":[1,2],"rho":[1,2],"o0_c1":[[1,2]]})"}) {
    std::ofstream(file) << text;
    try {
      CsfTable::load(file);
      ADD_FAILURE() << text;
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find("damaged_csf.json"), std::string::npos);
    }
  }
  std::filesystem::remove(file);
}

TEST(ColorVideoVdp, ImagesOfTheAuthors) {
  const auto loaded = table();
  if (!loaded) GTEST_SKIP() << "REPRISE_DATA holds no cvvdp";
  const Encoded grey = [](int x, int, double* rgb) { fill(rgb, ramp(x)); };
  const struct {
    Encoded reference, test;
    double jod_4k, jod_fhd;
  } cases[] = {
      {[](int, int, double* rgb) { fill(rgb, 0.5); }, [](int, int, double* rgb) { fill(rgb, 0.6); },
       10.0, 10.0},
      {grey, [](int x, int y, double* rgb) { fill(rgb, ramp(x) + 0.02 * checker(x, y, 1)); },
       9.975767, 9.841807},
      {grey, [](int x, int y, double* rgb) { fill(rgb, ramp(x) + 0.1 * checker(x, y, 8)); },
       4.484524, 3.463009},
      {hashed, [](int x, int y, double* rgb) { hashed(x + 1, y, rgb); }, 8.318206, 6.594099},
      {[](int x, int, double* rgb) { fill(rgb, x >= 80); },
       [](int x, int, double* rgb) { fill(rgb, x >= 81); }, 8.997149, 8.871370},
      {grey,
       [](int x, int, double* rgb) {
         fill(rgb, ramp(x));
         rgb[2] += 0.1;
       },
       7.833342, 7.537241}};
  const ColorVideoVdp near(*loaded, kVdpStandard4k);
  const ColorVideoVdp far(*loaded, kVdpStandardFhd);
  for (const auto& c : cases) {
    const FloatImage reference = lightOf(c.reference);
    const FloatImage test = lightOf(c.test);
    EXPECT_NEAR(jodFromQuality(near.imageQuality(reference, test)), c.jod_4k, kJodTolerance);
    EXPECT_NEAR(jodFromQuality(far.imageQuality(reference, test)), c.jod_fhd, kJodTolerance);
    EXPECT_EQ(jodFromQuality(near.imageQuality(test, test)), 10.0);
  }
}

TEST(ColorVideoVdp, VideosOfTheAuthors) {
  const auto loaded = table();
  if (!loaded) GTEST_SKIP() << "REPRISE_DATA holds no cvvdp";
  const ColorVideoVdp vdp(*loaded, kVdpStandard4k);
  const auto pattern = [](double sign) {
    return lightOf(
        [=](int x, int y, double* rgb) { fill(rgb, ramp(x) + sign * 0.05 * checker(x, y, 8)); });
  };
  const FloatImage reference = pattern(0.0);
  const FloatImage plus = pattern(1.0);
  const FloatImage minus = pattern(-1.0);
  const auto jod = [&](double frame_rate, bool flips) {
    return jodFromQuality(pooledQuality(vdp.videoQuality(
        30, frame_rate, [&](size_t) { return reference; },
        [&](size_t n) { return flips && n % 2 == 0 ? minus : plus; })));
  };
  EXPECT_NEAR(jod(60.0, false), 3.007186, kJodTolerance);
  EXPECT_NEAR(jod(60.0, true), 6.231329, kJodTolerance);
  EXPECT_NEAR(jod(30.0, false), 3.007185, kJodTolerance);
  EXPECT_NEAR(jod(30.0, true), 6.724265, kJodTolerance);
}

}  // namespace
}  // namespace reprise::lab
