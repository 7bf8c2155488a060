// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace reprise::lab {

double median(std::vector<double> values);

// GPU time of passes in ms, by name, in the order first recorded, a value a frame.
class PassTimes {
 public:
  // Spans of one frame; those of one name are summed.
  void add(size_t frame, const std::vector<std::pair<std::string, double>>& spans);

  const std::vector<std::pair<std::string, std::vector<double>>>& all() const { return passes_; }
  // Over the frames from `first_frame` on.
  std::vector<std::pair<std::string, double>> medians(size_t first_frame) const;

 private:
  std::vector<std::pair<std::string, std::vector<double>>> passes_;
};

}  // namespace reprise::lab
