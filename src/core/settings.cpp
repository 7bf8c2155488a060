// SPDX-License-Identifier: MIT
#include "core/settings.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "core/error.h"

namespace reprise {
namespace {

// Levenshtein distance with transpositions of neighbours counted as one edit.
size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::vector<size_t>> d(a.size() + 1, std::vector<size_t>(b.size() + 1));
  for (size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (size_t i = 1; i <= a.size(); ++i) {
    for (size_t j = 1; j <= b.size(); ++j) {
      const size_t substitution = d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, substitution});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
      }
    }
  }
  return d[a.size()][b.size()];
}

std::string rangeText(const RepriseSettingInfo& info) {
  char text[96];
  std::snprintf(text, sizeof(text), "[%g, %g]", info.minimum, info.maximum);
  return text;
}

}  // namespace

std::string nearNames(std::string_view name, const std::vector<std::string_view>& candidates) {
  // Two edits catch a slip of the finger; more would name strangers.
  constexpr size_t kMaxEdits = 2;
  std::vector<std::pair<size_t, std::string_view>> near;
  for (const std::string_view candidate : candidates) {
    const size_t edits = editDistance(name, candidate);
    const bool prefix = name.size() >= 2 && candidate.substr(0, name.size()) == name;
    if (edits <= kMaxEdits || prefix) near.emplace_back(prefix ? 0 : edits, candidate);
  }
  std::stable_sort(near.begin(), near.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::string joined;
  for (const auto& [edits, candidate] : near) {
    joined += (joined.empty() ? "'" : ", '") + std::string(candidate) + "'";
  }
  return joined;
}

Settings::Settings(const RepriseTechniqueInfo& technique) : technique_(&technique) {
  values_.reserve(technique.setting_count);
  for (uint32_t i = 0; i < technique.setting_count; ++i) {
    values_.push_back(technique.settings[i].default_value);
  }
}

uint32_t Settings::find(const char* name) const {
  if (name == nullptr) fail(REPRISE_ERROR_INVALID_ARGUMENT, "a setting has no name");
  std::vector<std::string_view> names;
  for (uint32_t i = 0; i < technique_->setting_count; ++i) {
    if (std::strcmp(technique_->settings[i].name, name) == 0) return i;
    names.emplace_back(technique_->settings[i].name);
  }
  const std::string near = nearNames(name, names);
  fail(REPRISE_ERROR_INVALID_ARGUMENT,
       "technique '" + std::string(technique_->name) + "' has no setting '" + name + "'" +
           (near.empty() ? "" : "; near: " + near));
}

double Settings::parse(const RepriseSettingInfo& info, const RepriseSettingValue& value) const {
  const std::string subject =
      "setting '" + std::string(info.name) + "' of technique '" + technique_->name + "'";
  double number = value.value;
  if (value.text != nullptr) {
    const std::string_view text = value.text;
    if (info.type == REPRISE_SETTING_CHOICE) {
      std::vector<std::string_view> names;
      for (uint32_t i = 0; info.choices[i] != nullptr; ++i) {
        if (text == info.choices[i]) return i;
        names.emplace_back(info.choices[i]);
      }
      std::string all;
      for (const std::string_view name : names) all += (all.empty() ? "" : ", ") + std::string(name);
      fail(REPRISE_ERROR_INVALID_ARGUMENT,
           subject + " cannot be '" + std::string(text) + "'; one of: " + all);
    }
    if (info.type == REPRISE_SETTING_BOOLEAN && (text == "true" || text == "on")) return 1.0;
    if (info.type == REPRISE_SETTING_BOOLEAN && (text == "false" || text == "off")) return 0.0;
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (status != std::errc() || end != text.data() + text.size()) {
      fail(REPRISE_ERROR_INVALID_ARGUMENT,
           subject + " wants a number, not '" + std::string(text) + "'");
    }
  }
  if (!std::isfinite(number) || number < info.minimum || number > info.maximum) {
    fail(REPRISE_ERROR_INVALID_ARGUMENT, subject + " must be in " + rangeText(info));
  }
  if (info.type != REPRISE_SETTING_FLOAT && number != std::floor(number)) {
    fail(REPRISE_ERROR_INVALID_ARGUMENT, subject + " must be a whole number");
  }
  return number;
}

void Settings::applyPreset(const char* name) {
  std::vector<std::string_view> names;
  for (uint32_t i = 0; i < technique_->preset_count; ++i) {
    const ReprisePresetInfo& preset = technique_->presets[i];
    if (std::strcmp(preset.name, name) == 0) {
      apply(preset.values, preset.value_count);
      return;
    }
    names.emplace_back(preset.name);
  }
  std::string all;
  for (const std::string_view known : names) all += (all.empty() ? "" : ", ") + std::string(known);
  fail(REPRISE_ERROR_INVALID_ARGUMENT,
       "technique '" + std::string(technique_->name) + "' has no preset '" + name + "'" +
           (all.empty() ? "" : "; it has: " + all));
}

bool Settings::apply(const RepriseSettingValue* values, uint32_t count) {
  std::vector<double> changed = values_;
  bool needs_prepare = false;
  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t index = find(values[i].name);
    const RepriseSettingInfo& info = technique_->settings[index];
    const double value = parse(info, values[i]);
    needs_prepare |= info.needs_prepare != 0 && value != changed[index];
    changed[index] = value;
  }
  values_ = std::move(changed);
  return needs_prepare;
}

}  // namespace reprise
