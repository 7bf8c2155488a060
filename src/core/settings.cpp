// SPDX-License-Identifier: MIT
#include "core/settings.h"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "core/error.h"
#include "core/near_names.h"

namespace reprise {
namespace {

std::string rangeText(const RepriseSettingInfo& info) {
  char text[96];
  std::snprintf(text, sizeof(text), "[%g, %g]", info.minimum, info.maximum);
  return text;
}

}  // namespace

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
  fail(REPRISE_ERROR_INVALID_ARGUMENT, "technique '" + std::string(technique_->name) +
                                           "' has no setting '" + name + "'" +
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
      for (const std::string_view name : names)
        all += (all.empty() ? "" : ", ") + std::string(name);
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
  fail(REPRISE_ERROR_INVALID_ARGUMENT, "technique '" + std::string(technique_->name) +
                                           "' has no preset '" + name + "'" +
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
