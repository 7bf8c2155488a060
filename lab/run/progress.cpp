// SPDX-License-Identifier: MIT
#include "lab/run/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace reprise::lab {
namespace {

using Seconds = std::chrono::duration<double>;

constexpr double kTerminalInterval_s = 0.1;
constexpr double kLineInterval_s = 5.0;
constexpr uint64_t kBarColumns = 24;

}  // namespace

Progress::Progress(std::string what, uint64_t steps, bool quiet)
    : what_(std::move(what)),
      steps_(std::max<uint64_t>(steps, 1)),
      quiet_(quiet),
      terminal_(isatty(STDERR_FILENO) == 1),
      begin_(std::chrono::steady_clock::now()),
      shown_(begin_) {}

Progress::~Progress() {
  if (!quiet_) show(true);
}

void Progress::step(uint64_t steps) {
  done_ = std::min(done_ + steps, steps_);
  if (quiet_) return;
  const auto now = std::chrono::steady_clock::now();
  const double interval_s = terminal_ ? kTerminalInterval_s : kLineInterval_s;
  if (Seconds(now - shown_).count() < interval_s) return;
  shown_ = now;
  show(false);
}

void Progress::show(bool last) {
  const double elapsed_s = Seconds(std::chrono::steady_clock::now() - begin_).count();
  const double rate = elapsed_s > 0.0 ? static_cast<double>(done_) / elapsed_s : 0.0;
  const double left_s = rate > 0.0 ? static_cast<double>(steps_ - done_) / rate : 0.0;
  std::string line;
  if (last) {
    line = fmt::format("{}: {} of {} in {:.1f} s", what_, done_, steps_, elapsed_s);
  } else if (terminal_) {
    const uint64_t filled = kBarColumns * done_ / steps_;
    line = fmt::format("{} [{}{}] {}/{}  {:.1f}/s  {:.0f} s left", what_, std::string(filled, '#'),
                       std::string(kBarColumns - filled, '.'), done_, steps_, rate, left_s);
  } else {
    line = fmt::format("{}: {} of {}, {:.1f}/s, {:.0f} s left", what_, done_, steps_, rate, left_s);
  }
  if (terminal_) {
    fmt::print(stderr, "\r\033[K{}{}", line, last ? "\n" : "");
  } else {
    fmt::print(stderr, "{}\n", line);
  }
  std::fflush(stderr);
}

}  // namespace reprise::lab
