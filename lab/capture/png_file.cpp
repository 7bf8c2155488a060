// SPDX-License-Identifier: MIT
#include "lab/capture/png_file.h"

#include <png.h>

#include <algorithm>
#include <vector>

#include "lab/capture/capture_error.h"
#include "lab/capture/output_file.h"

namespace reprise::lab {

std::string encodePng(const FloatImage& display) {
  std::vector<uint8_t> texels(display.texelCount() * 3);
  for (size_t i = 0; i < display.texelCount(); ++i) {
    for (size_t c = 0; c < 3; ++c) {
      const float value = std::clamp(display.texels[display.channels * i + c], 0.0f, 1.0f);
      texels[3 * i + c] = static_cast<uint8_t>(value * 255.0f + 0.5f);
    }
  }
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = display.width;
  image.height = display.height;
  image.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = 0;
  std::string bytes;
  const bool sized =
      png_image_write_to_memory(&image, nullptr, &size, 0, texels.data(), 0, nullptr);
  if (sized) bytes.resize(size);
  if (!sized ||
      !png_image_write_to_memory(&image, bytes.data(), &size, 0, texels.data(), 0, nullptr)) {
    throw CaptureError("PNG", "", std::string("cannot be encoded: ") + image.message);
  }
  bytes.resize(size);
  return bytes;
}

void writePng(const std::filesystem::path& path, const FloatImage& display) {
  writeOutputFile(path, encodePng(display));
}

}  // namespace reprise::lab
