// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bitset>
#include <string>
#include <string_view>

namespace reprise::lab {

// docs/metrics.md defines each. PSNR and its split into still and moving frames are always
// measured.
enum class Metric {
  kSsim,
  kFlip,
  kFlip30,
  kTemporalPsnr,
  kFlicker,
  kDisocclusion,
  kSharpness,
  kConvergence,
  kResidue,
  kColorVideoVdp,
  kCount
};
constexpr size_t kMetricCount = static_cast<size_t>(Metric::kCount);

// As --metrics and results.json name them.
constexpr std::array<const char*, kMetricCount> kMetricNames = {
    "ssim",         "flip",      "flip30",      "tpsnr",   "flicker",
    "disocclusion", "sharpness", "convergence", "residue", "cvvdp"};

class MetricSet {
 public:
  // All but ColorVideoVDP: its table comes apart from this project, and what is measured by default
  // does not depend on what a machine has.
  static MetricSet usual();
  // Names separated by commas; "default" and "all" stand for sets. Throws std::invalid_argument
  // naming the one that does not exist.
  static MetricSet parse(std::string_view names);

  bool has(Metric metric) const { return bits_[static_cast<size_t>(metric)]; }
  MetricSet& add(Metric metric) {
    bits_.set(static_cast<size_t>(metric));
    return *this;
  }
  MetricSet& remove(Metric metric) {
    bits_.reset(static_cast<size_t>(metric));
    return *this;
  }

 private:
  std::bitset<kMetricCount> bits_;
};

}  // namespace reprise::lab
