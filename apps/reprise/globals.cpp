// SPDX-License-Identifier: MIT
#include "globals.h"

#include <fmt/format.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "lab/run/technique_choice.h"

namespace reprise::app {

void Globals::print(std::string_view text) const {
  if (json || quiet) return;
  fmt::print("{}", text);
  std::fflush(stdout);
}

void Globals::printJson(const nlohmann::ordered_json& document) const {
  if (json) fmt::print("{}\n", document.dump(1));
}

void startLog(const Globals& globals) {
  auto logger = spdlog::stderr_color_mt("reprise");
  logger->set_pattern("reprise: %^%l%$: %v");
  logger->set_level(globals.quiet ? spdlog::level::err
                                  : spdlog::level::from_str(globals.log_level));
  spdlog::set_default_logger(logger);
}

std::unique_ptr<lab::Device> openDevice(const Globals& globals) {
  auto device = std::make_unique<lab::Device>(
      lab::DeviceOptions{.selector = globals.device, .validation = globals.validation});
  spdlog::debug("device: {} ({})", device->name(), device->driver());
  return device;
}

ExitCode validationResult(const lab::Device& device) {
  for (const std::string& message : device.validationMessages())
    spdlog::error("validation: {}", message);
  return device.validationMessages().empty() ? kDone : kDevice;
}

VkExtent2D parseExtent(const std::string& text) {
  constexpr uint32_t kMaxSide = 16384;
  VkExtent2D extent{};
  const char* end = text.data() + text.size();
  const auto [x, width_status] = std::from_chars(text.data(), end, extent.width);
  if (width_status == std::errc() && x != end && *x == 'x') {
    const auto [rest, height_status] = std::from_chars(x + 1, end, extent.height);
    const bool inside = extent.width >= 1 && extent.width <= kMaxSide && extent.height >= 1 &&
                        extent.height <= kMaxSide;
    if (height_status == std::errc() && rest == end && inside) return extent;
  }
  throw lab::UsageError(fmt::format(
      "'{}' is no extent: WIDTHxHEIGHT, each in [1, {}], such as 960x540", text, kMaxSide));
}

std::string scaledExtent(VkExtent2D extent, double scale) {
  const auto scaled = [scale](uint32_t side) { return std::max(1l, std::lround(side * scale)); };
  return fmt::format("{}x{}", scaled(extent.width), scaled(extent.height));
}

}  // namespace reprise::app
