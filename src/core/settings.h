// SPDX-License-Identifier: MIT
//
// A technique's settings are one table. Rows are found by an enumerator, so that reading a value
// while recording is an array access and a misspelt name does not compile.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "reprise/reprise.h"

namespace reprise {

// Row builders, for readable tables. `index` must equal the row's position (checked by
// settingTable).
struct SettingRow {
  uint32_t index;
  RepriseSettingInfo info;
};

constexpr SettingRow numberSetting(uint32_t index, const char* name, double default_value,
                                   double minimum, double maximum, const char* unit,
                                   const char* effect, const char* source,
                                   uint32_t needs_prepare = 0) {
  return {index,
          {name, REPRISE_SETTING_FLOAT, minimum, maximum, default_value, nullptr, unit, effect,
           source, needs_prepare}};
}
constexpr SettingRow integerSetting(uint32_t index, const char* name, double default_value,
                                    double minimum, double maximum, const char* unit,
                                    const char* effect, const char* source,
                                    uint32_t needs_prepare = 0) {
  return {index,
          {name, REPRISE_SETTING_INTEGER, minimum, maximum, default_value, nullptr, unit, effect,
           source, needs_prepare}};
}
constexpr SettingRow switchSetting(uint32_t index, const char* name, bool default_value,
                                   const char* effect, const char* source) {
  return {index,
          {name, REPRISE_SETTING_BOOLEAN, 0.0, 1.0, default_value ? 1.0 : 0.0, nullptr, "", effect,
           source, 1}};
}
template <size_t kChoices>
constexpr SettingRow choiceSetting(uint32_t index, const char* name, uint32_t default_value,
                                   const char* const (&choices)[kChoices], const char* effect,
                                   const char* source, uint32_t needs_prepare = 1) {
  return {index,
          {name, REPRISE_SETTING_CHOICE, 0.0, static_cast<double>(kChoices - 2),
           static_cast<double>(default_value), choices, "", effect, source, needs_prepare}};
}

// Puts the rows in place; a row out of order or missing does not compile.
template <size_t kRows>
consteval std::array<RepriseSettingInfo, kRows> settingTable(const SettingRow (&rows)[kRows]) {
  std::array<RepriseSettingInfo, kRows> table{};
  for (size_t i = 0; i < kRows; ++i) {
    if (rows[i].index != i) throw "a setting's row is not at its enumerator's place";
    table[i] = rows[i].info;
  }
  return table;
}

class Settings {
 public:
  explicit Settings(const RepriseTechniqueInfo& technique);

  double number(uint32_t index) const { return values_[index]; }
  float real(uint32_t index) const { return static_cast<float>(values_[index]); }
  uint32_t choice(uint32_t index) const { return static_cast<uint32_t>(values_[index]); }
  bool on(uint32_t index) const { return values_[index] != 0.0; }

  // Throws Error with the near names when `name` is unknown.
  uint32_t find(const char* name) const;
  void applyPreset(const char* name);
  // All or nothing: a wrong one throws Error and leaves every value as it was. Returns whether a
  // setting that needs reprisePrepare changed.
  bool apply(const RepriseSettingValue* values, uint32_t count);

 private:
  double parse(const RepriseSettingInfo& info, const RepriseSettingValue& value) const;

  const RepriseTechniqueInfo* technique_;
  std::vector<double> values_;
};

}  // namespace reprise
