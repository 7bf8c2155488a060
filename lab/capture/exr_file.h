// SPDX-License-Identifier: MIT
//
// OpenEXR scanline and tiled files, first part, every channel in its own type. Attributes that we
// do not know are carried along, so that a filtered frame keeps what its renderer wrote.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace reprise::lab {

enum class ExrType { kUint = 0, kHalf = 1, kFloat = 2 };

struct ExrChannel {
  std::string name;  // "ViewLayer.Combined.R"
  ExrType type = ExrType::kHalf;
  std::vector<uint8_t> texels;  // tightly packed rows from top to bottom, empty after readExrHeader

  std::vector<float> floats() const;
};

struct ExrImage {
  uint32_t width = 0;
  uint32_t height = 0;
  std::vector<ExrChannel> channels;
  std::shared_ptr<const void> attributes;  // of the file it came from; null for a new one

  const ExrChannel* find(std::string_view name) const;
  ExrChannel* find(std::string_view name);
};

// Largest side that is read: a damaged header must not ask for all memory.
constexpr int kMaxExrSide = 16384;

// Throws CaptureError naming the file: absent, truncated, damaged, subsampled channels, deep data.
ExrImage readExr(const std::filesystem::path& path);
ExrImage readExrHeader(const std::filesystem::path& path);
// Whole or not at all. Throws CaptureError.
void writeExr(const std::filesystem::path& path, const ExrImage& image);

// One value a pixel from every `stride`th float, rounded to the channel's type.
ExrChannel exrChannel(std::string name, ExrType type, std::span<const float> values,
                      size_t stride = 1);

}  // namespace reprise::lab
