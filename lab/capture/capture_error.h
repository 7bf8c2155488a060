// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

namespace reprise::lab {

// Input that cannot be read or is inconsistent, or output that cannot be written; exit code 3. One
// line: "FILE: FIELD: what is wrong". FIELD may be empty.
class CaptureError : public std::runtime_error {
 public:
  CaptureError(const std::string& file, const std::string& field, const std::string& what)
      : std::runtime_error(file + ": " + (field.empty() ? "" : field + ": ") + what) {}
};

}  // namespace reprise::lab
