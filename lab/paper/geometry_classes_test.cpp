// SPDX-License-Identifier: MIT
#include "lab/paper/geometry_classes.h"

#include <gtest/gtest.h>

#include "lab/metrics/psnr.h"

namespace reprise::lab {
namespace {

constexpr uint32_t kWidth = 24;
constexpr uint32_t kHeight = 12;

// A floor that is seen slanted: depth grows by more than a tenth from row to row.
FloatImage slantedFloor() {
  FloatImage depth(kWidth, kHeight, 1);
  for (uint32_t y = 0; y < kHeight; ++y) {
    for (uint32_t x = 0; x < kWidth; ++x) {
      *depth.at(x, y) = 10.0f / (1.0f + 0.3f * static_cast<float>(y));
    }
  }
  return depth;
}

GeometryClass at(const std::vector<GeometryClass>& classes, uint32_t x, uint32_t y) {
  return classes[y * kWidth + x];
}

TEST(GeometryClasses, ASlantedPlaneIsASurface) {
  const std::vector<GeometryClass> classes = geometryClasses(slantedFloor());
  // Rows at the border, where the image ends and so does the plane, are not asked.
  for (uint32_t y = 2; y + 2 < kHeight; ++y) {
    for (uint32_t x = 0; x < kWidth; ++x) {
      EXPECT_EQ(at(classes, x, y), GeometryClass::kSurface) << x << ", " << y;
    }
  }
}

TEST(GeometryClasses, AStepIsASilhouetteAndAPoleIsThin) {
  FloatImage depth(kWidth, kHeight, 1);
  for (uint32_t y = 0; y < kHeight; ++y) {
    for (uint32_t x = 0; x < kWidth; ++x) {
      const bool pole = x == 5 || x == 6;
      *depth.at(x, y) = pole || x >= 16 ? 2.0f : 3.0f;
    }
  }
  const std::vector<GeometryClass> classes = geometryClasses(depth);
  const uint32_t row = kHeight / 2;
  EXPECT_EQ(at(classes, 2, row), GeometryClass::kSurface);
  for (const uint32_t x : {4u, 5u, 6u, 7u}) EXPECT_EQ(at(classes, x, row), GeometryClass::kThin);
  EXPECT_EQ(at(classes, 11, row), GeometryClass::kSurface);
  for (const uint32_t x : {15u, 16u}) EXPECT_EQ(at(classes, x, row), GeometryClass::kSilhouette);
  EXPECT_EQ(at(classes, 20, row), GeometryClass::kSurface);
}

TEST(ClassError, KeepsClassesApartAndTakesNoiseOff) {
  const std::vector<GeometryClass> classes = {GeometryClass::kSurface, GeometryClass::kThin,
                                              GeometryClass::kThin, GeometryClass::kSurface};
  FloatImage reference(4, 1, 3);
  FloatImage image(4, 1, 3);
  for (size_t c = 0; c < 3; ++c) image.texels[3 + c] = 0.2f;
  EXPECT_EQ(meanByClass(classes, {1.0f, 3.0f, 5.0f, 2.0f}), (std::array{1.5, 0.0, 4.0}));
  ClassError error;
  error.add(classes, reference, image, {0.0, 0.0, 0.01});
  // Half of the thin pixels are off by 0.2, less the noise.
  EXPECT_NEAR(error.db(GeometryClass::kThin), psnrDb(0.02 - 0.01), 1e-4);
  EXPECT_EQ(error.db(GeometryClass::kSurface), kMaxPsnr_db);
  EXPECT_EQ(error.db(GeometryClass::kSilhouette), kMaxPsnr_db);
  EXPECT_DOUBLE_EQ(error.share(GeometryClass::kThin), 0.5);
  EXPECT_DOUBLE_EQ(error.share(GeometryClass::kSilhouette), 0.0);
}

}  // namespace
}  // namespace reprise::lab
