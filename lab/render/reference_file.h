// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "lab/float_image.h"

namespace reprise::lab {

// Sums of reference samples of one frame, RGB float, in two independent halves of `samples_a_half`.
struct ReferenceSums {
  uint32_t samples_a_half = 0;
  FloatImage halves[2];
};

// 64-bit FNV-1a of bytes, continued from `hash`.
uint64_t hashBytes(const void* data, size_t bytes, uint64_t hash = 14695981039346656037ull);

enum class ReferenceFileState { kAbsent, kDamaged, kWhole };

// Reads what writeReferenceFile wrote. Damaged: wrong magic, extent, length or checksum.
ReferenceFileState readReferenceFile(const std::filesystem::path& path, uint32_t width,
                                     uint32_t height, ReferenceSums& sums);
// Writes beside `path` and renames, so that a reader never sees half a file. False when the disk
// refuses: a cache that cannot be written is no error.
bool writeReferenceFile(const std::filesystem::path& path, const ReferenceSums& sums);

}  // namespace reprise::lab
