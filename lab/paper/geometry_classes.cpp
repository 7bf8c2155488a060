// SPDX-License-Identifier: MIT
#include "lab/paper/geometry_classes.h"

#include <algorithm>
#include <cmath>

#include "lab/metrics/psnr.h"

namespace reprise::lab {
namespace {

// A surface is thin where, within this many pixels on both sides, what is seen is farther by more
// than a share of its depth. A step of that share is an edge.
constexpr int kThin_px = 3;
constexpr float kBehind = 0.05f;

class DepthImage {
 public:
  explicit DepthImage(const FloatImage& view_depth)
      : image_(view_depth),
        width_(static_cast<int>(view_depth.width)),
        height_(static_cast<int>(view_depth.height)) {}

  bool isThin(int x, int y) const {
    const float behind = at(x, y) * (1.0f + kBehind);
    for (const auto& [dx, dy] : {std::pair{1, 0}, {0, 1}, {1, 1}, {1, -1}}) {
      bool before = false;
      bool after = false;
      for (int i = 1; i <= kThin_px; ++i) {
        before = before || at(x - i * dx, y - i * dy) > behind;
        after = after || at(x + i * dx, y + i * dy) > behind;
      }
      if (before && after) return true;
    }
    return false;
  }

  // On a plane, however slanted, the inverse of depth is linear across the screen.
  bool isEdge(int x, int y) const {
    const auto inverse = [&](int u, int v) { return 1.0f / at(u, v); };
    const float own = inverse(x, y);
    const float bend_x = inverse(x - 1, y) + inverse(x + 1, y) - 2.0f * own;
    const float bend_y = inverse(x, y - 1) + inverse(x, y + 1) - 2.0f * own;
    return std::max(std::abs(bend_x), std::abs(bend_y)) > kBehind * own;
  }

  int width() const { return width_; }
  int height() const { return height_; }

 private:
  float at(int x, int y) const {
    return *image_.at(static_cast<uint32_t>(std::clamp(x, 0, width_ - 1)),
                      static_cast<uint32_t>(std::clamp(y, 0, height_ - 1)));
  }

  const FloatImage& image_;
  int width_, height_;
};

}  // namespace

std::vector<GeometryClass> geometryClasses(const FloatImage& view_depth) {
  const DepthImage depth(view_depth);
  std::vector<GeometryClass> classes(view_depth.texelCount(), GeometryClass::kSurface);
  for (int y = 0; y < depth.height(); ++y) {
    for (int x = 0; x < depth.width(); ++x) {
      GeometryClass own = GeometryClass::kSurface;
      if (depth.isThin(x, y)) {
        own = GeometryClass::kThin;
      } else if (depth.isEdge(x, y)) {
        own = GeometryClass::kSilhouette;
      } else {
        continue;
      }
      for (int v = std::max(y - 1, 0); v <= std::min(y + 1, depth.height() - 1); ++v) {
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, depth.width() - 1); ++u) {
          GeometryClass& beside =
              classes[static_cast<size_t>(v) * view_depth.width + static_cast<size_t>(u)];
          beside = std::max(beside, own);
        }
      }
    }
  }
  return classes;
}

void ClassError::add(const std::vector<GeometryClass>& classes, const FloatImage& reference,
                     const FloatImage& image, const std::array<double, kGeometryClasses>& noise) {
  for (size_t i = 0; i < classes.size(); ++i) {
    const auto of = static_cast<size_t>(classes[i]);
    Sum& sum = sums_[of];
    for (size_t c = 0; c < 3; ++c) {
      const double d = double{image.texels[3 * i + c]} - double{reference.texels[3 * i + c]};
      sum.error += d * d / 3.0;
    }
    sum.noise += noise[of];
    ++sum.pixels;
  }
}

double ClassError::db(GeometryClass of) const {
  const Sum& sum = sums_[static_cast<size_t>(of)];
  if (sum.pixels == 0) return kMaxPsnr_db;
  return psnrDb(withoutNoise(sum.error, sum.noise) / static_cast<double>(sum.pixels));
}

double ClassError::share(GeometryClass of) const {
  size_t all = 0;
  for (const Sum& sum : sums_) all += sum.pixels;
  return static_cast<double>(sums_[static_cast<size_t>(of)].pixels) /
         static_cast<double>(std::max<size_t>(all, 1));
}

std::array<double, kGeometryClasses> meanByClass(const std::vector<GeometryClass>& classes,
                                                 const std::vector<float>& values) {
  std::array<double, kGeometryClasses> sums{};
  std::array<size_t, kGeometryClasses> counts{};
  for (size_t i = 0; i < classes.size(); ++i) {
    sums[static_cast<size_t>(classes[i])] += values[i];
    ++counts[static_cast<size_t>(classes[i])];
  }
  for (size_t of = 0; of < kGeometryClasses; ++of) {
    sums[of] /= static_cast<double>(std::max<size_t>(counts[of], 1));
  }
  return sums;
}

}  // namespace reprise::lab
