// SPDX-License-Identifier: MIT
//
// How blurred, and how far displaced, an image is: which Gaussian over the finely sampled scene
// comes nearest to it.
#pragma once

#include <cstdint>
#include <vector>

#include "lab/float_image.h"

namespace reprise::lab {

struct BlurMatch {
  double sigma_px = 0.0;    // standard deviation of a component
  double shift_x_px = 0.0;  // the image shows at p what the scene has at p + shift
  double shift_y_px = 0.0;
  double mean_squared_error = 0.0;
};

struct Displacement {
  double px;
  double weight;
};

class BlurFit {
 public:
  // `fine`: one channel, linear, `scale` texels a px each way. Pixels nearer than `margin_px` to
  // the border are not compared; it must hold the widest kernel (kWidestKernel_px).
  BlurFit(FloatImage fine, uint32_t scale, uint32_t margin_px);

  // The pixels inside the margin, through a Gaussian about the displaced pixel centres.
  FloatImage blurred(double sigma_px, double shift_x_px, double shift_y_px) const;

  // The same through samples at displacements along x and along y: a Gaussian about each.
  FloatImage spread(double sigma_px, const std::vector<Displacement>& along_x,
                    const std::vector<Displacement>& along_y) const;

  // Of `image`, one channel, linear, a texel a px, whole or as blurred() makes it: the deviation
  // without displacement.
  BlurMatch bestSigma(const FloatImage& image) const;
  // Deviation and displacement, each displacement within kLargestShift_px.
  BlurMatch bestShift(const FloatImage& image) const;

  static constexpr double kLargestSigma_px = 3.0;
  static constexpr double kLargestShift_px = 1.0;
  static constexpr double kWidestKernel_px = 3.5 * kLargestSigma_px + kLargestShift_px;

 private:
  struct Taps {  // weights of the fine texels from `first` on
    long first = 0;
    std::vector<float> weights;
  };
  Taps tapsOf(uint32_t px, double sigma_px, const std::vector<Displacement>& displacements,
              uint32_t fine_count) const;
  double error(const FloatImage& image, double sigma_px, double shift_x_px,
               double shift_y_px) const;

  FloatImage fine_;
  uint32_t scale_;
  uint32_t margin_px_;
};

}  // namespace reprise::lab
