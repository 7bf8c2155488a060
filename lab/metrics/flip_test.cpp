// SPDX-License-Identifier: MIT
//
// Figures printed by the authors' C++ implementation (NVlabs/flip, commit 1eb247c) for images that
// are formulas. Tolerance 1e-4: a double-precision evaluation of the same equations differs by up
// to 6e-5.
#include "lab/metrics/flip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace reprise::lab {
namespace {

constexpr double kTolerance = 1.0e-4;
constexpr float kDefaultPpd = kFlipPixelsPerDegree;

struct Rgb {
  float r, g, b;
};
using Formula = std::function<Rgb(int, int)>;

FloatImage imageOf(int width, int height, const Formula& formula) {
  FloatImage image(static_cast<uint32_t>(width), static_cast<uint32_t>(height), 3);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Rgb rgb = formula(x, y);
      float* texel = image.at(static_cast<uint32_t>(x), static_cast<uint32_t>(y));
      texel[0] = rgb.r;
      texel[1] = rgb.g;
      texel[2] = rgb.b;
    }
  }
  return image;
}

Formula flat(float r, float g, float b) {
  return [=](int, int) { return Rgb{r, g, b}; };
}
Formula grey(const std::function<float(int, int)>& value) {
  return [=](int x, int y) {
    const float v = value(x, y);
    return Rgb{v, v, v};
  };
}
Rgb hashed(int x, int y) {
  return {static_cast<float>((7 * x + 13 * y) & 255) / 255.0f,
          static_cast<float>((x * x + y * y) & 255) / 255.0f,
          static_cast<float>((x * y) & 255) / 255.0f};
}

struct Case {
  const char* name;
  int width, height;
  Formula reference, test;
  float ppd;
  double mean;
  double largest = -1.0, centre = -1.0, beside = -1.0, corner = -1.0;  // -1: not given
};

const std::vector<Case>& cases() {
  const Formula step = grey([](int x, int) { return x >= 32 ? 1.0f : 0.0f; });
  const Formula shifted = grey([](int x, int) { return x >= 33 ? 1.0f : 0.0f; });
  const Formula dot = grey([](int x, int y) { return x == 32 && y == 24 ? 1.0f : 0.0f; });
  const Formula black = flat(0, 0, 0);
  const Formula hash = hashed;
  const Formula hash_beside = [](int x, int y) { return hashed(x + 1, y); };
  const Formula ramp = grey([](int x, int) { return static_cast<float>(x) / 63.0f; });
  const Formula stairs = grey([](int x, int) { return static_cast<float>(x / 8) / 7.0f; });
  const Formula checker = grey([](int x, int y) { return static_cast<float>((x + y) & 1); });
  const Formula half = flat(0.5f, 0.5f, 0.5f);
  const auto plane = [](float blue) -> Formula {
    return [=](int x, int y) {
      return Rgb{static_cast<float>(x) / 63.0f, static_cast<float>(y) / 47.0f, blue};
    };
  };
  static const std::vector<Case> all{
      {"1", 16, 16, half, flat(0.6f, 0.6f, 0.6f), kDefaultPpd, .196255, .196255, .196255, .196255,
       .196255},
      {"2", 16, 16, black, flat(1, 1, 1), kDefaultPpd, .967388, .967388, .967388, .967388, .967388},
      {"3", 16, 16, flat(0, 1, 0), flat(0, 0, 1), kDefaultPpd, 1.0},
      {"4", 16, 16, flat(1, 0, 0), flat(0, 1, 1), kDefaultPpd, .979911},
      {"5", 16, 16, flat(.25f, .5f, .125f), flat(.5f, .5f, .125f), kDefaultPpd, .435744},
      {"6", 64, 48, step, shifted, kDefaultPpd, .051732, .772917, .538265, .357566, 0.0},
      {"6b", 64, 48, step, shifted, 30.0f, .037258, .953169, .953169, 0.0, 0.0},
      {"6c", 64, 48, step, shifted, 20.0f, .031332, .965638, .965638, 0.0, 0.0},
      {"7", 64, 48, dot, black, kDefaultPpd, .004658, .864906, .864906, .043043, 0.0},
      {"7b", 64, 48, dot, black, 30.0f, .001808, .979940, .979940, 0.0, 0.0},
      {"8", 64, 48, hash, hash_beside, kDefaultPpd, .237170, .781354, .357058, .196591, .314720},
      {"8b", 64, 48, hash, hash_beside, 30.0f, .591687, .974168, .763939, .813414, .321397},
      {"9", 64, 48, ramp, stairs, kDefaultPpd, .179601, .727025, .100249, .141616, .259103},
      {"10", 64, 48, checker, half, kDefaultPpd, .005010, .515740, .001040, .001040, .515740},
      {"10b", 64, 48, checker, half, 30.0f, .385587, .813576, .417986, .334526, .813576},
      {"10c", 64, 48, checker, half, 20.0f, .778607, .984652, .961109, .587264, .984652},
      {"11", 64, 48, plane(.25f), plane(.5f), kDefaultPpd, .482331, .530277, .491312, .494773,
       .434713},
  };
  return all;
}

TEST(Flip, AuthorsFigures) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    const FloatImage error = flipErrorMap(imageOf(c.width, c.height, c.reference),
                                          imageOf(c.width, c.height, c.test), c.ppd);
    EXPECT_NEAR(meanOf(error), c.mean, kTolerance);
    // Single pixels of row 11 carry the float noise that the last square root amplifies.
    const double tolerance = c.name == std::string("11") ? 1.0e-3 : kTolerance;
    const uint32_t w = error.width / 2;
    const uint32_t h = error.height / 2;
    if (c.largest >= 0.0) {
      EXPECT_NEAR(*std::max_element(error.texels.begin(), error.texels.end()), c.largest,
                  tolerance);
      EXPECT_NEAR(*error.at(w, h), c.centre, tolerance);
      EXPECT_NEAR(*error.at(w - 3, h + 2), c.beside, tolerance);
      EXPECT_NEAR(*error.at(0, 0), c.corner, tolerance);
    }
  }
}

TEST(Flip, EqualImagesHaveNoError) {
  const FloatImage image = imageOf(37, 11, hashed);
  EXPECT_EQ(meanOf(flipErrorMap(image, image, kDefaultPpd)), 0.0);
}

TEST(Flip, OnePixel) {
  const FloatImage a = imageOf(1, 1, flat(0.2f, 0.2f, 0.2f));
  const FloatImage b = imageOf(1, 1, flat(0.4f, 0.4f, 0.4f));
  EXPECT_GT(meanOf(flipErrorMap(a, b, kDefaultPpd)), 0.0);
}

Rgb bright(int x, int y) {
  const float v = (1.0f + static_cast<float>(y % 16) / 16.0f) *
                  std::exp2(std::floor(14.0f * static_cast<float>(x) / 64.0f) - 7.0f);
  return {v, v / 2.0f, v / 4.0f};
}

TEST(HdrFlip, AuthorsFigures) {
  const FloatImage reference = imageOf(64, 48, bright);
  const FloatImage brighter = imageOf(64, 48, [](int x, int y) {
    const Rgb v = bright(x, y);
    const float scale = y >= 24 ? 1.25f : 1.0f;
    return Rgb{v.r * scale, v.g * scale, v.b * scale};
  });
  const FloatImage firefly = imageOf(64, 48, [](int x, int y) {
    return x == 40 && y == 20 ? Rgb{1000, 1000, 1000} : bright(x, y);
  });
  struct HdrCase {
    HdrTonemapper tonemapper;
    double brighter, brighter_largest, firefly, firefly_largest, first, last;
  };
  for (const HdrCase& c :
       {HdrCase{HdrTonemapper::kAces, .139706, .346535, .003944, .696688, -5.105401, 1.848796},
        HdrCase{HdrTonemapper::kReinhard, .116007, .248482, .002897, .530698, -3.686197, 3.267999},
        HdrCase{HdrTonemapper::kHable, .114263, .242450, .003043, .581904, -4.543572, 2.410624}}) {
    const HdrFlip b = hdrFlip(reference, brighter, kDefaultPpd, c.tonemapper);
    EXPECT_EQ(b.exposures, 7u);
    EXPECT_NEAR(b.first_exposure, c.first, 1.0e-4);
    EXPECT_NEAR(b.last_exposure, c.last, 1.0e-4);
    EXPECT_NEAR(meanOf(b.error), c.brighter, kTolerance);
    EXPECT_NEAR(*std::max_element(b.error.texels.begin(), b.error.texels.end()), c.brighter_largest,
                5.0e-4);
    const HdrFlip f = hdrFlip(reference, firefly, kDefaultPpd, c.tonemapper);
    EXPECT_NEAR(meanOf(f.error), c.firefly, kTolerance);
    EXPECT_NEAR(*std::max_element(f.error.texels.begin(), f.error.texels.end()), c.firefly_largest,
                5.0e-4);
  }
}

}  // namespace
}  // namespace reprise::lab
