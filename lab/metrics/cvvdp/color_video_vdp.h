// SPDX-License-Identifier: MIT
//
// ColorVideoVDP, Mantiuk et al., ACM TOG 43(4), 2024, version 0.5.6: how different two videos look.
// Checked against figures of the authors' implementation in color_video_vdp_test.cpp.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "lab/float_image.h"
#include "lab/metrics/cvvdp/csf_table.h"

namespace reprise::lab {

// Where the videos are seen.
struct VdpDisplay {
  const char* name;
  double peak_cd_m2;
  double contrast;
  double ambient_lux;
  double pixels_per_degree;
};
// The authors' displays: 30 inches, 3840 x 2160, seen from 0.7472 m; 24 inches, 1920 x 1080, 0.6 m.
constexpr VdpDisplay kVdpStandard4k{"standard_4k", 200.0, 1000.0, 250.0, 75.402449345};
constexpr VdpDisplay kVdpStandardFhd{"standard_fhd", 200.0, 1000.0, 250.0, 37.842503854};

// No side below this: no pyramid.
constexpr uint32_t kLeastVdpSide_px = 8;

class ColorVideoVdp {
 public:
  // Frame n as light of the display, linear RGB in [0, 1]. Called from any thread, in order within
  // a thread, some frames more than once.
  using Frames = std::function<FloatImage(size_t frame)>;

  ColorVideoVdp(CsfTable table, VdpDisplay display) : table_(std::move(table)), display_(display) {}

  const VdpDisplay& display() const { return display_; }

  // Quality loss Q of each frame of a video: 0 where no difference is seen. Works on all threads.
  std::vector<double> videoQuality(size_t frames, double frame_rate, const Frames& reference,
                                   const Frames& test) const;
  double imageQuality(const FloatImage& reference, const FloatImage& test) const;

 private:
  CsfTable table_;
  VdpDisplay display_;
};

// Of a video, from its frames' Q.
double pooledQuality(std::span<const double> quality);
// Just objectionable differences: 10 for equal videos; one less is preferred by a quarter of the
// viewers only.
double jodFromQuality(double quality);

// Taps of the filters over time at a frame rate, sustained Y, RG, YV and transient Y; odd in number
// and symmetric.
std::array<std::vector<float>, kVdpChannels> temporalTaps(double frame_rate);

// What an image of display light is to the opponent channels: 3 planes in one image of 3 channels.
FloatImage opponentImage(const FloatImage& light, const VdpDisplay& display);

}  // namespace reprise::lab
