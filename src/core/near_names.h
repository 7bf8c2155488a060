// SPDX-License-Identifier: MIT
//
// "did you mean": the names that a mistyped one may have meant. Header only, for the library's
// settings and the lab's command line and captures alike.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

namespace reprise {

// Levenshtein: insertions, deletions and substitutions that turn `a` into `b`.
inline size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), size_t{0});
  for (size_t i = 1; i <= a.size(); ++i) {
    size_t diagonal = row[0];
    row[0] = i;
    for (size_t j = 1; j <= b.size(); ++j) {
      const size_t above = row[j];
      row[j] = std::min({above + 1, row[j - 1] + 1, diagonal + (a[i - 1] == b[j - 1] ? 0 : 1)});
      diagonal = above;
    }
  }
  return row[b.size()];
}

// Candidates within two edits of `name`, or that begin with it, joined as "'a', 'b'"; "" when none
// is.
template <typename Names>
std::string nearNames(std::string_view name, const Names& candidates) {
  constexpr size_t kMaxEdits = 2;  // a slip of the finger; more would name strangers
  std::string joined;
  for (const auto& item : candidates) {
    const std::string_view candidate = item;
    const bool starts_so = name.size() >= 2 && candidate.substr(0, name.size()) == name;
    if (!starts_so && editDistance(name, candidate) > kMaxEdits) continue;
    joined += (joined.empty() ? "'" : ", '") + std::string(candidate) + "'";
  }
  return joined;
}

}  // namespace reprise
