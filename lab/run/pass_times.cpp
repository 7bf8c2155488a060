// SPDX-License-Identifier: MIT
#include "lab/run/pass_times.h"

#include <algorithm>

namespace reprise::lab {

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

void PassTimes::add(size_t frame, const std::vector<std::pair<std::string, double>>& spans) {
  for (const auto& [name, ms] : spans) {
    auto pass = std::find_if(passes_.begin(), passes_.end(),
                             [&name = name](const auto& known) { return known.first == name; });
    if (pass == passes_.end()) pass = passes_.insert(passes_.end(), {name, {}});
    pass->second.resize(frame + 1, 0.0);
    pass->second[frame] += ms;
  }
}

std::vector<std::pair<std::string, double>> PassTimes::medians(size_t first_frame) const {
  std::vector<std::pair<std::string, double>> medians;
  for (const auto& [name, ms] : passes_) {
    const size_t begin = std::min(first_frame, ms.empty() ? 0 : ms.size() - 1);
    medians.emplace_back(name, median({ms.begin() + static_cast<std::ptrdiff_t>(begin), ms.end()}));
  }
  return medians;
}

}  // namespace reprise::lab
