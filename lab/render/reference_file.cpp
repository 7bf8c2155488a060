// SPDX-License-Identifier: MIT
#include "lab/render/reference_file.h"

#include <unistd.h>

#include <cstring>
#include <fstream>
#include <string>

namespace reprise::lab {
namespace {

// Raw native-endian floats: a cache serves the machine that wrote it.
struct Header {
  char magic[8] = {'r', 'p', 'r', 's', 'r', 'e', 'f', '1'};
  uint32_t width = 0;
  uint32_t height = 0;
  uint32_t samples_a_half = 0;
  uint32_t padding = 0;
  uint64_t checksum = 0;
};

uint64_t checksum(const ReferenceSums& sums) {
  uint64_t hash = hashBytes(&sums.samples_a_half, sizeof(sums.samples_a_half));
  for (const FloatImage& half : sums.halves) {
    hash = hashBytes(half.texels.data(), half.texels.size() * sizeof(float), hash);
  }
  return hash;
}

}  // namespace

uint64_t hashBytes(const void* data, size_t bytes, uint64_t hash) {
  const auto* byte = static_cast<const uint8_t*>(data);
  // Eight bytes a step: references are megabytes, and FNV-1a by single bytes would be felt.
  for (; bytes >= 8; bytes -= 8, byte += 8) {
    uint64_t word;
    std::memcpy(&word, byte, 8);
    hash = (hash ^ word) * 1099511628211ull;
    hash ^= hash >> 32;
  }
  for (; bytes > 0; --bytes, ++byte) hash = (hash ^ *byte) * 1099511628211ull;
  return hash;
}

ReferenceFileState readReferenceFile(const std::filesystem::path& path, uint32_t width,
                                     uint32_t height, ReferenceSums& sums) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return ReferenceFileState::kAbsent;
  Header header;
  const Header expected;
  file.read(reinterpret_cast<char*>(&header), sizeof(header));
  if (!file || std::memcmp(header.magic, expected.magic, sizeof(header.magic)) != 0 ||
      header.width != width || header.height != height || header.samples_a_half == 0 ||
      header.padding != 0) {
    return ReferenceFileState::kDamaged;
  }
  sums.samples_a_half = header.samples_a_half;
  for (FloatImage& half : sums.halves) {
    half = FloatImage(width, height, 3);
    file.read(reinterpret_cast<char*>(half.texels.data()),
              static_cast<std::streamsize>(half.texels.size() * sizeof(float)));
  }
  if (!file || file.peek() != std::char_traits<char>::eof() || checksum(sums) != header.checksum) {
    return ReferenceFileState::kDamaged;
  }
  return ReferenceFileState::kWhole;
}

bool writeReferenceFile(const std::filesystem::path& path, const ReferenceSums& sums) {
  std::error_code error;
  std::filesystem::create_directories(path.parent_path(), error);
  const std::filesystem::path temporary = path.string() + ".tmp" + std::to_string(getpid());
  Header header;
  header.width = sums.halves[0].width;
  header.height = sums.halves[0].height;
  header.samples_a_half = sums.samples_a_half;
  header.checksum = checksum(sums);
  std::ofstream file(temporary, std::ios::binary);
  file.write(reinterpret_cast<const char*>(&header), sizeof(header));
  for (const FloatImage& half : sums.halves) {
    file.write(reinterpret_cast<const char*>(half.texels.data()),
               static_cast<std::streamsize>(half.texels.size() * sizeof(float)));
  }
  file.close();
  if (file) std::filesystem::rename(temporary, path, error);
  if (!file || error) {
    std::filesystem::remove(temporary, error);
    return false;
  }
  return true;
}

}  // namespace reprise::lab
