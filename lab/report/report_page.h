// SPDX-License-Identifier: MIT
//
// One HTML file that needs nothing else: table, plots a frame, image comparer. Any command with
// results and images can write one.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "lab/float_image.h"
#include "lab/report/results.h"

namespace reprise::lab {

// Images of one source, by what they show and frame. Display values, RGB.
class ReportImages {
 public:
  // Pictures are kept as PNG up to this many bytes; of what exceeds it, every second frame is
  // dropped until it fits.
  explicit ReportImages(uint64_t budget_bytes) : budget_bytes_(budget_bytes) {}

  // `what`: "reference" or a technique as written; `png` an 8-bit PNG. Error maps are "flip of " +
  // technique.
  void add(const std::string& source, const std::string& what, uint32_t frame, std::string png);
  void fitBudget();

  // source -> what -> frame -> PNG.
  using Frames = std::map<uint32_t, std::string>;
  const std::map<std::string, std::map<std::string, Frames>>& all() const { return images_; }
  uint64_t bytes() const { return bytes_; }

 private:
  uint64_t budget_bytes_;
  uint64_t bytes_ = 0;
  std::map<std::string, std::map<std::string, Frames>> images_;
};

std::string reportPage(const std::string& title, const Results& results,
                       const ReportImages& images);

}  // namespace reprise::lab
