// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include "lab/capture/description.h"

namespace reprise::lab {

// Motion of points at infinity between two pinhole cameras: only rotation and field of view count.
class FarMotion {
 public:
  // nullopt where a camera lacks its matrices or is no pinhole (clip.w = -z).
  static std::optional<FarMotion> between(const CaptureCamera& previous,
                                          const CaptureCamera& current, VkExtent2D extent);

  // (prev_px - px) for the point at infinity seen at `px`; nullopt where it was behind the camera.
  std::optional<std::array<float, 2>> at(double x_px, double y_px) const;

 private:
  // Rays of the current view to the previous view, rows.
  std::array<double, 9> rotation_{};
  std::array<double, 4> current_{}, previous_{};  // projection x scale, x shift, y scale, y shift
  double width_ = 0.0;
  double height_ = 0.0;
};

}  // namespace reprise::lab
