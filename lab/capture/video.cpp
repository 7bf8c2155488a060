// SPDX-License-Identifier: MIT
#include "lab/capture/video.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <vector>

#include "lab/capture/capture_error.h"

extern char** environ;

namespace reprise::lab {

Video::Video(std::filesystem::path path, uint32_t width, uint32_t height, double frame_rate)
    : path_(std::move(path)), temporary_(path_) {
  temporary_.replace_extension(".part" + path_.extension().string());
  // yuv420p, which every player shows, needs even sides.
  std::vector<std::string> arguments{"ffmpeg",
                                     "-y",
                                     "-loglevel",
                                     "error",
                                     "-f",
                                     "rawvideo",
                                     "-pix_fmt",
                                     "rgb24",
                                     "-video_size",
                                     fmt::format("{}x{}", width, height),
                                     "-framerate",
                                     fmt::format("{}", frame_rate),
                                     "-i",
                                     "-",
                                     "-vf",
                                     "pad=ceil(iw/2)*2:ceil(ih/2)*2",
                                     "-c:v",
                                     "libx264",
                                     "-crf",
                                     "12",
                                     "-pix_fmt",
                                     "yuv420p",
                                     temporary_.string()};
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);

  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw CaptureError(path_.string(), "", std::strerror(errno));
  // A ffmpeg that ends early must show as an error of write().
  signal(SIGPIPE, SIG_IGN);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
  const int status = posix_spawnp(&process_, "ffmpeg", &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[0]);
  input_ = ends[1];
  if (status != 0) {
    close(input_);
    input_ = -1;
    process_ = -1;
    throw CaptureError(path_.string(), "",
                       std::string("ffmpeg cannot be started: ") + std::strerror(status));
  }
}

Video::~Video() {
  if (process_ < 0) return;
  waitForFfmpeg();
  std::error_code ignored;
  std::filesystem::remove(temporary_, ignored);
}

int Video::waitForFfmpeg() {
  if (input_ >= 0) close(input_);
  input_ = -1;
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  return status;
}

void Video::add(const FloatImage& display) {
  std::vector<uint8_t> texels(display.texelCount() * 3);
  for (size_t i = 0; i < texels.size(); ++i) {
    texels[i] = static_cast<uint8_t>(std::clamp(display.texels[i], 0.0f, 1.0f) * 255.0f + 0.5f);
  }
  for (size_t done = 0; done < texels.size();) {
    const ssize_t written = write(input_, texels.data() + done, texels.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) throw CaptureError(path_.string(), "", "ffmpeg has ended early");
    done += static_cast<size_t>(written);
  }
}

void Video::finish() {
  if (waitForFfmpeg() != 0) {
    std::error_code ignored;
    std::filesystem::remove(temporary_, ignored);
    throw CaptureError(path_.string(), "", "ffmpeg could not write the video");
  }
  std::error_code error;
  std::filesystem::rename(temporary_, path_, error);
  if (error) throw CaptureError(path_.string(), "", "cannot be written: " + error.message());
}

}  // namespace reprise::lab
