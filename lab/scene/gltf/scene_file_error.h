// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

namespace reprise::lab {

// A scene's file that cannot be used; what() is one line that names the file and what is wrong.
class SceneFileError : public std::runtime_error {
 public:
  SceneFileError(const std::string& file, const std::string& what)
      : std::runtime_error(file + ": " + what) {}
};

}  // namespace reprise::lab
