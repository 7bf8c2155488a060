// SPDX-License-Identifier: MIT
#include "lab/tune/search.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <stdexcept>

#include "core/near_names.h"

namespace reprise::lab {
namespace {

// From zero no factor leads away: the first step there is this share of the range, or of the
// default where that is smaller.
constexpr double kShareOfRange = 0.1;

uint32_t choiceCount(const RepriseSettingInfo& info) {
  if (info.type == REPRISE_SETTING_BOOLEAN) return 2;
  uint32_t count = 0;
  while (info.choices[count] != nullptr) ++count;
  return count;
}

bool isNamed(const RepriseSettingInfo& info) {
  return info.type == REPRISE_SETTING_CHOICE || info.type == REPRISE_SETTING_BOOLEAN;
}

// What is tried is what is printed.
double threeDigits(double value) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.3g", value);
  return std::strtod(text, nullptr);
}

double stepped(const TunedSetting& setting, double value, double factor) {
  double next = value * factor;
  if (value == 0.0) {
    const double share = kShareOfRange * (setting.maximum - std::max(setting.minimum, 0.0));
    const double usual = std::abs(setting.info->default_value);
    next = factor < 1.0 ? 0.0 : (usual > 0.0 ? std::min(usual, share) : share) * (factor - 1.0);
  }
  if (setting.info->type == REPRISE_SETTING_INTEGER) {
    next = std::round(next);
    if (next == value) next += factor > 1.0 ? 1.0 : -1.0;
  } else {
    next = threeDigits(next);
  }
  return std::clamp(next, setting.minimum, setting.maximum);
}

class Search {
 public:
  Search(const std::vector<TunedSetting>& settings, const Score& score,
         const SearchOptions& options, const std::function<void(const SearchStep&)>& on_better)
      : settings_(settings), score_(score), options_(options), on_better_(on_better) {}

  SearchResult run(const std::vector<double>& start) {
    result_.best = {0, -HUGE_VAL, start};
    tryValues(start);
    // A score that is no number is none to begin from, but something else may be better.
    result_.best.evaluation = 1;
    result_.start = result_.best;
    result_.ended = true;
    for (double step = options_.first_step; step >= options_.last_step && !spent();
         step = std::sqrt(step)) {
      bool better = true;
      while (better && !spent()) {
        better = false;
        for (size_t i = 0; i < settings_.size(); ++i) better |= along(i, step);
      }
    }
    result_.ended = !spent();
    return result_;
  }

 private:
  bool spent() const { return result_.evaluations >= options_.evaluations; }

  bool along(size_t i, double step) {
    return isNamed(*settings_[i].info) ? amongNames(i)
                                       : (inDirection(i, step) || inDirection(i, 1.0 / step));
  }

  bool amongNames(size_t i) {
    bool better = false;
    for (uint32_t choice = 0; choice < choiceCount(*settings_[i].info); ++choice) {
      std::vector<double> values = result_.best.values;
      values[i] = choice;
      better |= tryValues(values);
    }
    return better;
  }

  bool inDirection(size_t i, double factor) {
    bool better = false;
    for (;;) {
      std::vector<double> values = result_.best.values;
      values[i] = stepped(settings_[i], values[i], factor);
      if (values[i] == result_.best.values[i] || !tryValues(values)) return better;
      better = true;
    }
  }

  bool tryValues(const std::vector<double>& values) {
    if (spent()) return false;
    if (!known_.emplace(values, true).second) return false;
    ++result_.evaluations;
    const double score = score_(values);
    const bool first = result_.evaluations == 1;
    if (!std::isfinite(score)) return false;
    if (!first && score < result_.best.score + options_.least_gain) return false;
    result_.best = {result_.evaluations, score, values};
    if (on_better_) on_better_(result_.best);
    return true;
  }

  const std::vector<TunedSetting>& settings_;
  const Score& score_;
  const SearchOptions& options_;
  const std::function<void(const SearchStep&)>& on_better_;
  std::map<std::vector<double>, bool> known_;
  SearchResult result_;
};

double parseEnd(std::string_view text, double otherwise, std::string_view whole) {
  if (text.empty()) return otherwise;
  double value = 0.0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
    throw std::invalid_argument("'" + std::string(whole) + "' is not NAME or NAME=LOW:HIGH");
  }
  return value;
}

}  // namespace

TunedSetting parseTunedSetting(const RepriseTechniqueInfo& technique, std::string_view text) {
  const size_t equals = text.find('=');
  const std::string_view name = text.substr(0, equals);
  std::vector<std::string> names;
  for (uint32_t i = 0; i < technique.setting_count; ++i) {
    const RepriseSettingInfo& info = technique.settings[i];
    names.emplace_back(info.name);
    if (name != info.name) continue;
    TunedSetting setting{&info, info.minimum, info.maximum};
    if (equals == std::string_view::npos) return setting;
    const std::string_view range = text.substr(equals + 1);
    const size_t colon = range.find(':');
    if (isNamed(info) || colon == std::string_view::npos) {
      throw std::invalid_argument("'" + std::string(text) + "' is not NAME or NAME=LOW:HIGH" +
                                  (isNamed(info) ? "; it is no number" : ""));
    }
    setting.minimum = parseEnd(range.substr(0, colon), info.minimum, text);
    setting.maximum = parseEnd(range.substr(colon + 1), info.maximum, text);
    if (setting.minimum < info.minimum || setting.maximum > info.maximum ||
        setting.minimum >= setting.maximum) {
      char all[64];
      std::snprintf(all, sizeof(all), "[%g, %g]", info.minimum, info.maximum);
      throw std::invalid_argument("'" + std::string(text) + "' is no range within " + all);
    }
    return setting;
  }
  const std::string near = nearNames(name, names);
  throw std::invalid_argument("technique '" + std::string(technique.name) + "' has no setting '" +
                              std::string(name) + "'" + (near.empty() ? "" : "; near: " + near) +
                              " (see 'reprise list')");
}

std::string settingText(const RepriseSettingInfo& info, double value) {
  if (info.type == REPRISE_SETTING_CHOICE) return info.choices[static_cast<size_t>(value)];
  if (info.type == REPRISE_SETTING_BOOLEAN) return value != 0.0 ? "true" : "false";
  char text[32];
  std::snprintf(text, sizeof(text), info.type == REPRISE_SETTING_INTEGER ? "%.0f" : "%.6g", value);
  return text;
}

SearchResult searchSettings(const std::vector<TunedSetting>& settings, std::vector<double> start,
                            const Score& score, const SearchOptions& options,
                            const std::function<void(const SearchStep&)>& on_better) {
  return Search(settings, score, options, on_better).run(start);
}

}  // namespace reprise::lab
