// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <filesystem>
#include <vector>

namespace reprise::lab {

// Channels of ColorVideoVDP: achromatic, red-green and yellow-violet of what lasts, achromatic of
// what changes.
constexpr size_t kVdpChannels = 4;

// The contrast sensitivity of castleCSF as ColorVideoVDP tabulates it:
// csf_lut_weber_fixed_size.json, MIT licence, of github.com/gfxdisp/ColorVideoVDP. It is data, not
// part of this project: load() reads the file where there is one.
class CsfTable {
 public:
  static constexpr const char* kFileName = "csf_lut_weber_fixed_size.json";

  // Throws std::runtime_error with one line that names the file.
  static CsfTable load(const std::filesystem::path& file);

  // Sensitivity at one spatial frequency, for any luminance.
  class Curve {
   public:
    // `luminance` in cd/m2; beyond the table's ends its ends.
    std::array<float, kVdpChannels> sensitivity(float luminance) const;

   private:
    friend class CsfTable;
    float first_log_luminance_ = 0.0f;
    float steps_per_decade_ = 1.0f;
    std::vector<std::array<float, kVdpChannels>> log_sensitivity_;  // log10
  };
  Curve at(double cycles_per_degree) const;

 private:
  std::vector<double> log_luminance_, log_frequency_;                 // log10, evenly spaced
  std::array<std::vector<std::vector<double>>, kVdpChannels> log_s_;  // [luminance][frequency]
};

}  // namespace reprise::lab
