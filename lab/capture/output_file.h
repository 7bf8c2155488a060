// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string_view>

namespace reprise::lab {

// Writes all of `bytes` beside `path` and renames: a reader sees the old file, the new one or none.
// Throws CaptureError (disk full, read-only target) and leaves no temporary file.
void writeOutputFile(const std::filesystem::path& path, std::string_view bytes);
// Creates the directory and those above it. Throws CaptureError.
void makeOutputDirectory(const std::filesystem::path& path);
// Throws CaptureError when it cannot be read.
std::string readWholeFile(const std::filesystem::path& path);

}  // namespace reprise::lab
