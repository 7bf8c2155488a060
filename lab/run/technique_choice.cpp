// SPDX-License-Identifier: MIT
#include "lab/run/technique_choice.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "core/near_names.h"

namespace reprise::lab {
namespace {

constexpr double kMaxGrid = 16.0;
const RepriseSettingInfo kSupersamplingSettings[] = {
    {"n", REPRISE_SETTING_INTEGER, 1.0, kMaxGrid, 4.0, nullptr, "samples a side",
     "n x n stratified samples a pixel, each with its own visibility and shading",
     "the baseline of Yang et al. 2009", 0},
};

std::string rangeText(const RepriseSettingInfo& info) {
  if (info.type == REPRISE_SETTING_CHOICE) {
    std::string all;
    for (uint32_t i = 0; info.choices[i] != nullptr; ++i) {
      all += (i == 0 ? "one of " : ", ") + std::string(info.choices[i]);
    }
    return all;
  }
  if (info.type == REPRISE_SETTING_BOOLEAN) return "true or false";
  char text[96];
  std::snprintf(text, sizeof(text), "a %snumber in [%g, %g]",
                info.type == REPRISE_SETTING_INTEGER ? "whole " : "", info.minimum, info.maximum);
  return text;
}

bool fits(const RepriseSettingInfo& info, std::string_view text) {
  if (info.type == REPRISE_SETTING_CHOICE) {
    for (uint32_t i = 0; info.choices[i] != nullptr; ++i) {
      if (text == info.choices[i]) return true;
    }
    return false;
  }
  if (info.type == REPRISE_SETTING_BOOLEAN &&
      (text == "true" || text == "false" || text == "on" || text == "off")) {
    return true;
  }
  double value = 0.0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc() || end != text.data() + text.size()) return false;
  const bool whole = info.type == REPRISE_SETTING_FLOAT || value == std::floor(value);
  return std::isfinite(value) && whole && value >= info.minimum && value <= info.maximum;
}

void addSetting(TechniqueChoice& choice, const RepriseTechniqueInfo& info, std::string_view name,
                std::string_view value) {
  const std::string subject = "technique '" + choice.name + "'";
  if (name == "preset" && info.preset_count > 0) {
    std::string all;
    for (uint32_t i = 0; i < info.preset_count; ++i) {
      if (value == info.presets[i].name) {
        choice.preset = value;
        return;
      }
      all += (i == 0 ? "" : ", ") + std::string(info.presets[i].name);
    }
    throw UsageError(subject + " has no preset '" + std::string(value) + "'; it has: " + all);
  }
  std::vector<std::string> names;
  for (uint32_t i = 0; i < info.setting_count; ++i) {
    const RepriseSettingInfo& setting = info.settings[i];
    if (name == setting.name) {
      if (!fits(setting, value)) {
        throw UsageError("setting '" + std::string(name) + "' of " + subject + " must be " +
                         rangeText(setting) + ", not '" + std::string(value) + "'");
      }
      choice.settings.emplace_back(name, value);
      return;
    }
    names.emplace_back(setting.name);
  }
  const std::string near = nearNames(name, names);
  throw UsageError(subject + " has no setting '" + std::string(name) + "'" +
                   (near.empty() ? "" : "; near: " + near) + " (see 'reprise list')");
}

}  // namespace

const RepriseTechniqueInfo kSupersamplingInfo = {
    .name = "ss",
    .summary = "N x N stratified supersampling by true per-sample shading (scenes only)",
    .source = "baseline",
    .flags = 0,
    .settings = kSupersamplingSettings,
    .setting_count = 1,
    .presets = nullptr,
    .preset_count = 0,
};

std::vector<const RepriseTechniqueInfo*> allTechniques() {
  std::vector<const RepriseTechniqueInfo*> all;
  for (uint32_t i = 0; i < repriseGetTechniqueCount(); ++i) all.push_back(repriseGetTechnique(i));
  all.push_back(&kSupersamplingInfo);
  return all;
}

std::vector<RepriseSettingValue> TechniqueChoice::values() const {
  std::vector<RepriseSettingValue> values;
  if (library == nullptr || name != library->name) return values;
  for (const auto& [key, text] : settings) values.push_back({key.c_str(), 0.0, text.c_str()});
  return values;
}

TechniqueChoice parseTechnique(std::string_view text) {
  TechniqueChoice choice;
  choice.label = text;
  const size_t colon = text.find(':');
  choice.name = text.substr(0, colon);
  const RepriseTechniqueInfo* info = nullptr;
  std::vector<std::string> names;
  for (const RepriseTechniqueInfo* known : allTechniques()) {
    if (choice.name == known->name) info = known;
    names.emplace_back(known->name);
  }
  if (info == nullptr) {
    const std::string near = nearNames(choice.name, names);
    throw UsageError("there is no technique '" + choice.name + "'" +
                     (near.empty() ? "" : "; near: " + near) + " (see 'reprise list')");
  }
  choice.library = info == &kSupersamplingInfo ? repriseFindTechnique("none") : info;

  std::string_view rest = colon == std::string_view::npos ? "" : text.substr(colon + 1);
  while (!rest.empty()) {
    const size_t comma = rest.find(',');
    const std::string_view pair = rest.substr(0, comma);
    rest = comma == std::string_view::npos ? "" : rest.substr(comma + 1);
    const size_t equals = pair.find('=');
    if (equals == std::string_view::npos) {
      throw UsageError("technique '" + choice.name + "': '" + std::string(pair) +
                       "' is not name=value");
    }
    addSetting(choice, *info, pair.substr(0, equals), pair.substr(equals + 1));
  }
  if (info == &kSupersamplingInfo) {
    choice.grid = static_cast<uint32_t>(kSupersamplingSettings[0].default_value);
    for (const auto& [key, value] : choice.settings) {
      choice.grid = static_cast<uint32_t>(std::stod(value));
    }
  }
  return choice;
}

std::vector<TechniqueChoice> parseTechniques(const std::vector<std::string>& texts) {
  std::vector<std::string> items;
  for (const std::string& text : texts) {
    bool first_of_text = true;
    size_t begin = 0;
    while (begin <= text.size()) {
      const size_t end = std::min(text.find_first_of(", ", begin), text.size());
      const std::string piece = text.substr(begin, end - begin);
      // "name=value" goes on with the technique before it; "name" or "name:..." begins another.
      const size_t colon = piece.find(':');
      const size_t equals = piece.find('=');
      const bool setting =
          equals != std::string::npos && (colon == std::string::npos || equals < colon);
      if (!piece.empty() && setting && !first_of_text) {
        items.back() += (items.back().find(':') == std::string::npos ? ":" : ",") + piece;
      } else if (!piece.empty()) {
        items.push_back(piece);
        first_of_text = false;
      }
      begin = end + 1;
    }
  }
  if (items.empty()) throw UsageError("no technique is named");
  std::vector<TechniqueChoice> choices;
  for (const std::string& item : items) {
    for (const TechniqueChoice& known : choices) {
      if (known.label == item) throw UsageError("technique '" + item + "' is named twice");
    }
    choices.push_back(parseTechnique(item));
  }
  return choices;
}

}  // namespace reprise::lab
