// SPDX-License-Identifier: MIT
#include "lab/capture/output_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

#include "lab/capture/capture_error.h"

namespace reprise::lab {

void writeOutputFile(const std::filesystem::path& path, std::string_view bytes) {
  std::filesystem::path temporary = path;
  temporary += ".part";
  const int file = open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  const auto fail = [&](int error) {
    if (file >= 0) close(file);
    unlink(temporary.c_str());
    throw CaptureError(path.string(), "",
                       std::string("cannot be written: ") + std::strerror(error));
  };
  if (file < 0) fail(errno);
  while (!bytes.empty()) {
    const ssize_t written = write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) fail(errno);
    bytes.remove_prefix(static_cast<size_t>(written));
  }
  // Some file systems report a full disk only here.
  if (close(file) != 0 || rename(temporary.c_str(), path.c_str()) != 0) {
    const int error = errno;
    unlink(temporary.c_str());
    throw CaptureError(path.string(), "",
                       std::string("cannot be written: ") + std::strerror(error));
  }
}

void makeOutputDirectory(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) throw CaptureError(path.string(), "", "cannot be created: " + error.message());
}

std::string readWholeFile(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  if (!file.is_open() || file.bad()) throw CaptureError(path.string(), "", "cannot be read");
  return text;
}

}  // namespace reprise::lab
