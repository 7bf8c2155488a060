// SPDX-License-Identifier: MIT
//
// A technique with settings as a user writes it: "taa:alpha=0.05,clip=variance", "ss:n=4".
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reprise/reprise.h"

namespace reprise::lab {

// The user asked for something that does not exist or cannot be; exit code 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct TechniqueChoice {
  std::string label;   // as written; unique within a list
  std::string name;    // "taa", "ss"
  std::string preset;  // "" or a preset's name, from "taa:preset=fast"
  std::vector<std::pair<std::string, std::string>> settings;  // without the preset
  const RepriseTechniqueInfo* library = nullptr;              // what resolves; `none` for ss
  uint32_t grid = 1;                                          // N of N x N supersampling

  // C views of `settings`; valid while this object lives unchanged.
  std::vector<RepriseSettingValue> values() const;
};

// `ss` is the lab's: only a source that renders can take N x N samples a pixel.
extern const RepriseTechniqueInfo kSupersamplingInfo;
// Every technique that the command line knows: the library's, then the lab's.
std::vector<const RepriseTechniqueInfo*> allTechniques();

// Splits at spaces, and at commas that come before a technique's name:
// "none,taa:alpha=0.1,clip=none". Throws UsageError, with the near names, for unknown techniques,
// settings and values out of range.
std::vector<TechniqueChoice> parseTechniques(const std::vector<std::string>& texts);
TechniqueChoice parseTechnique(std::string_view text);

}  // namespace reprise::lab
