// SPDX-License-Identifier: MIT
//
// The two passes of FXAA, for the technique and for others that antialias their input first.
#pragma once

#include "reprise/reprise.h"
// reprise.h first: the shared header is GLSL too and includes no Vulkan header.
#include "core/context.h"
#include "techniques/fxaa/fxaa_shared.h"

namespace reprise::fxaa {

struct Options {
  uint32_t quality = 2;  // place in kQualityNames
  float edge_threshold = 0.166f;
  float edge_threshold_min = 0.0833f;
  float subpixel = 0.75f;
  uint32_t blend = kBlendLinear;
};

// The published presets, by name; ends with nullptr.
extern const char* const kQualityNames[18];

class Passes {
 public:
  void declare(Declaration& declaration, uint32_t blend);
  // `color` of the frame's input extent -> `output` of the same.
  void record(Recorder& recorder, const FrameState& state, const Options& options,
              const RepriseImage& color, VkImageView output) const;

 private:
  HistoryHandle luma_ = 0;
  PassHandle luma_pass_ = 0;
  PassHandle filter_pass_ = 0;
};

}  // namespace reprise::fxaa
