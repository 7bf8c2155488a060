// SPDX-License-Identifier: MIT
#include "lab/metrics/cvvdp/csf_table.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace reprise::lab {
namespace {

std::vector<double> logOfAxis(const nlohmann::json& axis) {
  std::vector<double> values;
  for (const nlohmann::json& value : axis) values.push_back(std::log10(value.get<double>()));
  if (values.size() < 2 || !(values.front() < values.back())) {
    throw std::runtime_error("an axis does not rise");
  }
  return values;
}

}  // namespace

CsfTable CsfTable::load(const std::filesystem::path& file) {
  const auto fail = [&](const std::string& what) {
    throw std::runtime_error(file.string() + ": " + what);
  };
  std::ifstream stream(file);
  if (!stream) fail("cannot be read");
  CsfTable table;
  try {
    const nlohmann::json json = nlohmann::json::parse(stream);
    table.log_luminance_ = logOfAxis(json.at("L_bkg"));
    table.log_frequency_ = logOfAxis(json.at("rho"));
    const char* const keys[kVdpChannels] = {"o0_c1", "o0_c2", "o0_c3", "o5_c1"};
    for (size_t c = 0; c < kVdpChannels; ++c) {
      table.log_s_[c] = json.at(keys[c]).get<std::vector<std::vector<double>>>();
      bool whole = table.log_s_[c].size() == table.log_luminance_.size();
      for (const auto& row : table.log_s_[c]) {
        whole = whole && row.size() == table.log_frequency_.size();
      }
      if (!whole) throw std::runtime_error(std::string(keys[c]) + " does not fit its axes");
    }
  } catch (const std::exception& error) {
    fail(std::string("is no table of ColorVideoVDP: ") + error.what());
  }
  return table;
}

CsfTable::Curve CsfTable::at(double cycles_per_degree) const {
  const auto last = static_cast<double>(log_frequency_.size() - 1);
  const double at = std::clamp((std::log10(cycles_per_degree) - log_frequency_.front()) /
                                   (log_frequency_.back() - log_frequency_.front()) * last,
                               0.0, last);
  const size_t left = std::min(static_cast<size_t>(at), log_frequency_.size() - 2);
  const double fraction = at - static_cast<double>(left);
  Curve curve;
  curve.first_log_luminance_ = static_cast<float>(log_luminance_.front());
  curve.steps_per_decade_ = static_cast<float>(static_cast<double>(log_luminance_.size() - 1) /
                                               (log_luminance_.back() - log_luminance_.front()));
  curve.log_sensitivity_.resize(log_luminance_.size());
  for (size_t l = 0; l < log_luminance_.size(); ++l) {
    for (size_t c = 0; c < kVdpChannels; ++c) {
      const std::vector<double>& row = log_s_[c][l];
      curve.log_sensitivity_[l][c] =
          static_cast<float>(row[left] + fraction * (row[left + 1] - row[left]));
    }
  }
  return curve;
}

std::array<float, kVdpChannels> CsfTable::Curve::sensitivity(float luminance) const {
  constexpr float kLogOf10 = 2.302585093f;
  const auto last = static_cast<float>(log_sensitivity_.size() - 1);
  const float at =
      std::clamp((std::log10(luminance) - first_log_luminance_) * steps_per_decade_, 0.0f, last);
  const size_t below = std::min(static_cast<size_t>(at), log_sensitivity_.size() - 2);
  const float fraction = at - static_cast<float>(below);
  std::array<float, kVdpChannels> s{};
  for (size_t c = 0; c < kVdpChannels; ++c) {
    const float a = log_sensitivity_[below][c];
    const float b = log_sensitivity_[below + 1][c];
    s[c] = std::exp(kLogOf10 * (a + fraction * (b - a)));
  }
  return s;
}

}  // namespace reprise::lab
