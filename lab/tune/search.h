// SPDX-License-Identifier: MIT
//
// Search of a technique's settings for the best score: one setting at a time, as long as any
// helps, by ever smaller steps (coordinate search; Hooke and Jeeves 1961). It needs no derivative,
// survives a noisy score by `least_gain`, and every step of it can be read.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "reprise/reprise.h"

namespace reprise::lab {

// A setting that the search may change, and how far; a choice or a boolean has all its values.
struct TunedSetting {
  const RepriseSettingInfo* info = nullptr;
  double minimum = 0.0;
  double maximum = 0.0;
};

// "bound" with its whole range, "bound=0.5:4" with a part of it. Throws std::invalid_argument,
// naming what is near, for a name that `technique` has not, an empty range or one outside.
TunedSetting parseTunedSetting(const RepriseTechniqueInfo& technique, std::string_view text);

// As a technique's setting is written: "0.25", "true", "variance".
std::string settingText(const RepriseSettingInfo& info, double value);

struct SearchOptions {
  uint32_t evaluations = 150;  // of the score, at most; the first is of the start
  double first_step = 2.0;     // factor between values tried
  double last_step = 1.1;      // the search ends below it
  double least_gain = 0.005;   // less than this is no improvement
};

struct SearchStep {
  uint32_t evaluation = 0;  // 1: the start
  double score = 0.0;
  std::vector<double> values;  // a value a setting
};

// Higher is better; no number loses against everything.
using Score = std::function<double(const std::vector<double>& values)>;

struct SearchResult {
  SearchStep start, best;
  uint32_t evaluations = 0;
  bool ended = false;  // false: `evaluations` were used up first
};

// `on_better` is called with the start and each improvement; null is allowed. No point is scored
// twice.
SearchResult searchSettings(const std::vector<TunedSetting>& settings, std::vector<double> start,
                            const Score& score, const SearchOptions& options,
                            const std::function<void(const SearchStep&)>& on_better);

}  // namespace reprise::lab
