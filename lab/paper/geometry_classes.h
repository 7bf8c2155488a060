// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lab/float_image.h"

namespace reprise::lab {

// What a pixel shows: where visibility decides how good it looks, and where shading alone does.
enum class GeometryClass : uint8_t {
  kSurface,     // no edge within a pixel
  kSilhouette,  // an edge of one surface before another
  kThin         // surfaces with something farther close by on both sides
};
constexpr size_t kGeometryClasses = 3;

// A class a pixel; silhouettes and thin surfaces with the pixels beside them, where they are
// antialiased.
std::vector<GeometryClass> geometryClasses(const FloatImage& view_depth);

// Squared error over many frames, apart by class.
class ClassError {
 public:
  // Display values, RGB. `noise`: the mean squared error of `reference` itself in each class; it is
  // independent of the image, adds up with its error and is taken off again.
  void add(const std::vector<GeometryClass>& classes, const FloatImage& reference,
           const FloatImage& image, const std::array<double, kGeometryClasses>& noise);

  // dB over all pixels added; kMaxPsnr_db where there is none.
  double db(GeometryClass of) const;
  // Of all pixels, [0, 1].
  double share(GeometryClass of) const;

 private:
  struct Sum {
    double error = 0.0;  // of a pixel: mean over channels
    double noise = 0.0;
    size_t pixels = 0;
  };
  std::array<Sum, kGeometryClasses> sums_{};
};

// Mean of `values`, one a pixel, in each class; 0 where there is no pixel.
std::array<double, kGeometryClasses> meanByClass(const std::vector<GeometryClass>& classes,
                                                 const std::vector<float>& values);

}  // namespace reprise::lab
