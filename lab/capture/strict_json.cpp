// SPDX-License-Identifier: MIT
#include "lab/capture/strict_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/near_names.h"
#include "lab/capture/capture_error.h"

namespace reprise::lab {

StrictObject::StrictObject(const nlohmann::json& value, std::string file, std::string path)
    : value_(value), file_(std::move(file)), path_(std::move(path)) {
  if (!value_.is_object()) throw CaptureError(file_, path_, "must be an object");
}

std::string StrictObject::path(const char* key) const {
  return path_.empty() ? key : path_ + "." + key;
}

void StrictObject::fail(const char* key, const std::string& what) const {
  throw CaptureError(file_, path(key), what);
}

bool StrictObject::has(const char* key) {
  asked_.emplace_back(key);
  return value_.contains(key);
}

const nlohmann::json& StrictObject::member(const char* key) {
  if (!has(key)) fail(key, "is missing");
  return value_[key];
}

StrictObject StrictObject::object(const char* key) {
  return StrictObject(member(key), file_, path(key));
}

std::string StrictObject::text(const char* key) {
  const nlohmann::json& value = member(key);
  if (!value.is_string()) fail(key, "must be a text");
  return value.get<std::string>();
}

std::string StrictObject::text(const char* key, const char* otherwise) {
  return has(key) ? text(key) : otherwise;
}

double StrictObject::number(const char* key, double minimum, double maximum) {
  const nlohmann::json& value = member(key);
  if (!value.is_number()) fail(key, "must be a number");
  const double number = value.get<double>();
  if (!(number >= minimum && number <= maximum)) {
    fail(key, fmt::format("{} is not in [{}, {}]", number, minimum, maximum));
  }
  return number;
}

double StrictObject::number(const char* key, double minimum, double maximum, double otherwise) {
  return has(key) ? number(key, minimum, maximum) : otherwise;
}

bool StrictObject::boolean(const char* key, bool otherwise) {
  if (!has(key)) return otherwise;
  if (!value_[key].is_boolean()) fail(key, "must be true or false");
  return value_[key].get<bool>();
}

std::vector<double> StrictObject::numbers(const char* key, size_t count) {
  const nlohmann::json& value = member(key);
  const bool right = value.is_array() && value.size() == count &&
                     std::all_of(value.begin(), value.end(), [](const nlohmann::json& element) {
                       return element.is_number() && std::isfinite(element.get<double>());
                     });
  if (!right) fail(key, fmt::format("must be {} numbers", count));
  return value.get<std::vector<double>>();
}

size_t StrictObject::choice(const char* key, const std::vector<std::string>& choices,
                            const char* otherwise) {
  const std::string value = otherwise == nullptr ? text(key) : text(key, otherwise);
  const auto found = std::find(choices.begin(), choices.end(), value);
  if (found == choices.end()) {
    fail(key, fmt::format("'{}' is not one of {}", value, fmt::join(choices, ", ")));
  }
  return static_cast<size_t>(found - choices.begin());
}

void StrictObject::finish() const {
  for (const auto& [key, value] : value_.items()) {
    if (std::find(asked_.begin(), asked_.end(), key) != asked_.end()) continue;
    const std::string near = nearNames(key, asked_);
    fail(key.c_str(), "unknown key" + (near.empty() ? "" : "; near: " + near));
  }
}

nlohmann::json parseJson(const std::string& text, const std::string& file) {
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    const size_t end = std::min(error.byte, text.size());
    const auto begin = text.begin();
    const auto line = std::count(begin, begin + static_cast<std::ptrdiff_t>(end), '\n') + 1;
    throw CaptureError(file, fmt::format("line {}", line), "is no valid JSON");
  }
}

}  // namespace reprise::lab
