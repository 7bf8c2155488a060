// SPDX-License-Identifier: MIT
//
// Reads a JSON object member by member, with the file and the member's path in every error, and
// refuses members that nobody asked for.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace reprise::lab {

class StrictObject {
 public:
  // Throws CaptureError when `value` is no object. `path` is "" for the document.
  StrictObject(const nlohmann::json& value, std::string file, std::string path);

  bool has(const char* key);
  StrictObject object(const char* key);
  const nlohmann::json& member(const char* key);  // must be there
  std::string path(const char* key) const;

  std::string text(const char* key);
  std::string text(const char* key, const char* otherwise);
  double number(const char* key, double minimum, double maximum);
  double number(const char* key, double minimum, double maximum, double otherwise);
  bool boolean(const char* key, bool otherwise);
  std::vector<double> numbers(const char* key, size_t count);
  // The index of the member's text in `choices`.
  size_t choice(const char* key, const std::vector<std::string>& choices, const char* otherwise);

  // Throws CaptureError, naming near keys, when the object has a member that was not asked for.
  void finish() const;

  [[noreturn]] void fail(const char* key, const std::string& what) const;

 private:
  const nlohmann::json& value_;
  std::string file_;
  std::string path_;
  std::vector<std::string> asked_;
};

// Throws CaptureError with line and column for text that is no JSON.
nlohmann::json parseJson(const std::string& text, const std::string& file);

}  // namespace reprise::lab
