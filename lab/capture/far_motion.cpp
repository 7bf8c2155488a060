// SPDX-License-Identifier: MIT
#include "lab/capture/far_motion.h"

namespace reprise::lab {
namespace {

bool isPinhole(const MatrixRows& p) {
  return p[12] == 0.0f && p[13] == 0.0f && p[14] == -1.0f && p[15] == 0.0f && p[0] != 0.0f &&
         p[5] != 0.0f && p[1] == 0.0f && p[4] == 0.0f;
}

}  // namespace

std::optional<FarMotion> FarMotion::between(const CaptureCamera& previous,
                                            const CaptureCamera& current, VkExtent2D extent) {
  if (!previous.view || !previous.projection || !current.view || !current.projection) return {};
  if (!isPinhole(*previous.projection) || !isPinhole(*current.projection)) return {};
  FarMotion motion;
  motion.width_ = extent.width;
  motion.height_ = extent.height;
  // previous_view_ray = R_previous R_current^T current_view_ray.
  for (size_t r = 0; r < 3; ++r) {
    for (size_t c = 0; c < 3; ++c) {
      double sum = 0.0;
      for (size_t k = 0; k < 3; ++k) {
        sum += double{(*previous.view)[4 * r + k]} * double{(*current.view)[4 * c + k]};
      }
      motion.rotation_[3 * r + c] = sum;
    }
  }
  const auto scales = [](const MatrixRows& p) {
    return std::array<double, 4>{p[0], p[2], p[5], p[6]};
  };
  motion.current_ = scales(*current.projection);
  motion.previous_ = scales(*previous.projection);
  return motion;
}

std::optional<std::array<float, 2>> FarMotion::at(double x_px, double y_px) const {
  // ndc = (scale * x + shift * z) / -z on the plane z = -1; y up.
  const double ray[3] = {(2.0 * x_px / width_ - 1.0 + current_[1]) / current_[0],
                         (1.0 - 2.0 * y_px / height_ + current_[3]) / current_[2], -1.0};
  double then[3];
  for (size_t r = 0; r < 3; ++r) {
    then[r] =
        rotation_[3 * r] * ray[0] + rotation_[3 * r + 1] * ray[1] + rotation_[3 * r + 2] * ray[2];
  }
  if (then[2] >= 0.0) return std::nullopt;
  const double ndc_x = (previous_[0] * then[0] + previous_[1] * then[2]) / -then[2];
  const double ndc_y = (previous_[2] * then[1] + previous_[3] * then[2]) / -then[2];
  return std::array<float, 2>{static_cast<float>((ndc_x + 1.0) * 0.5 * width_ - x_px),
                              static_cast<float>((1.0 - ndc_y) * 0.5 * height_ - y_px)};
}

}  // namespace reprise::lab
