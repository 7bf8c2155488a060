// SPDX-License-Identifier: MIT
#include "lab/metrics/metric_set.h"

#include <algorithm>
#include <stdexcept>

namespace reprise::lab {

MetricSet MetricSet::usual() {
  MetricSet set;
  set.bits_.set();
  return set.remove(Metric::kColorVideoVdp);
}

MetricSet MetricSet::parse(std::string_view names) {
  MetricSet set;
  while (!names.empty()) {
    const std::string_view name = names.substr(0, names.find(','));
    names.remove_prefix(std::min(names.size(), name.size() + 1));
    if (name == "default" || name == "all") {
      set.bits_ |= usual().bits_;
      if (name == "all") set.bits_.set();
      continue;
    }
    const auto* found = std::find(kMetricNames.begin(), kMetricNames.end(), name);
    if (found == kMetricNames.end()) {
      std::string message =
          "there is no metric '" + std::string(name) + "'; there are: default, all";
      for (const char* known : kMetricNames) message += std::string(", ") + known;
      throw std::invalid_argument(message);
    }
    set.bits_.set(static_cast<size_t>(found - kMetricNames.begin()));
  }
  return set;
}

}  // namespace reprise::lab
