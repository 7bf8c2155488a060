// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "lab/float_image.h"

namespace reprise::lab {

// RGB display values in [0, 1] (others clamped), rounded to 8 bits.
std::string encodePng(const FloatImage& display);
// Whole or not at all. Throws CaptureError.
void writePng(const std::filesystem::path& path, const FloatImage& display);

}  // namespace reprise::lab
