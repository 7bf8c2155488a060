// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace reprise::lab {

// Progress of long work on standard error: a bar with rate and time left on a terminal, a line
// about every five seconds otherwise, nothing when quiet.
class Progress {
 public:
  Progress(std::string what, uint64_t steps, bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void step(uint64_t steps = 1);

 private:
  void show(bool last);

  std::string what_;
  uint64_t steps_;
  uint64_t done_ = 0;
  bool quiet_;
  bool terminal_;
  std::chrono::steady_clock::time_point begin_;
  std::chrono::steady_clock::time_point shown_;
};

}  // namespace reprise::lab
