// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include <filesystem>

#include "lab/float_image.h"

namespace reprise::lab {

// An H.264 film through ffmpeg: frames go to its standard input, and the file appears under its
// name when finish() has returned.
class Video {
 public:
  // Throws CaptureError when ffmpeg cannot be started.
  Video(std::filesystem::path path, uint32_t width, uint32_t height, double frame_rate);
  ~Video();
  Video(const Video&) = delete;
  Video& operator=(const Video&) = delete;

  // RGB display values. Throws CaptureError when ffmpeg has ended.
  void add(const FloatImage& display);
  void finish();

 private:
  int waitForFfmpeg();

  std::filesystem::path path_;
  std::filesystem::path temporary_;
  int input_ = -1;
  pid_t process_ = -1;
};

}  // namespace reprise::lab
