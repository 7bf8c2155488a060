// SPDX-License-Identifier: MIT
//
// Options of every verb, and what they decide.
#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "lab/vk/device.h"

namespace reprise::app {

// Exit codes; part of the interface.
enum ExitCode {
  kDone = 0,
  kCheckFailed = 1,
  kUsage = 2,
  kInput = 3,
  kDevice = 4,
  kInterrupted = 130
};

struct Globals {
  std::string device;
  bool validation = false;
  std::string log_level = "info";
  bool quiet = false;
  bool json = false;
  std::string command;  // as it was typed

  // Nothing but a document goes to standard output with --json.
  void print(std::string_view text) const;
  void printJson(const nlohmann::ordered_json& document) const;
};

void startLog(const Globals& globals);
std::unique_ptr<lab::Device> openDevice(const Globals& globals);
// Logs what the validation layer found. kDone when it was silent or off.
ExitCode validationResult(const lab::Device& device);

// "960x540"; throws UsageError.
VkExtent2D parseExtent(const std::string& text);
// "WIDTHxHEIGHT" of `extent` times `scale`, rounded, at least 1 a side.
std::string scaledExtent(VkExtent2D extent, double scale);

}  // namespace reprise::app
