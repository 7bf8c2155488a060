// SPDX-License-Identifier: MIT
#ifndef REPRISE_TECHNIQUES_AMORTIZED_SHARED_H
#define REPRISE_TECHNIQUES_AMORTIZED_SHARED_H

#include "core/frame_constants.h"

#ifdef __cplusplus
namespace reprise::amortized {
using eq::uint;
using eq::vec2;
using eq::vec4;
#endif

// Levels of need (eq. evaluationsGain) times 2^8 places in the order of pixels: the bins that the
// evaluations of a frame are counted in.
EQ_CONST uint kRequestLevels = 4u;
EQ_CONST uint kRequestPlaces = 256u;
EQ_CONST uint kRequestBins = kRequestLevels * kRequestPlaces;

// Of one subpixel buffer, as a frame finds it.
struct SlotState {
  vec4 place_age;           // xy: its place in the pixel (px), z: age in frames, w: 1 if readable
  vec4 depth_coefficients;  // eq. expectedPreviousDepth, to the frame that wrote it
  float exposure_ratio;     // its colour * ratio has this frame's exposure
  uint quadrants;           // to be asked for where reprojection to it fails, as bits
  vec2 jitter_px;           // of the frame that wrote it: its depths lie at the centre minus this
};

struct AmortizedConstants {
  FrameConstants frame;
  SlotState slots[4];
  vec4 writes[8];         // element n of 32: how often the buffer to be written was in n frames
  vec4 target_px;         // xy: place of the buffer to be written, z: radius of its tent
  float writes_a_period;  // of one buffer in 32 frames
  float max_samples;
  float depth_tolerance;     // relative
  float residual_tolerance;  // tau_eps; 0: off
  float fixed_alpha;         // 0: by (26)
  float extra_given;         // 1: the frame came with served requests
  float buffer_count;        // K
  float shutter;             // share of a frame that it is open; 0: no motion blur
  float quality;             // samples that a pixel is brought to; 0: not held
  float previous_slot;       // of the buffer that the previous frame wrote; -1: none is readable
  float padding_0;
  float padding_1;
  // Slice of alpha_tau_b, bytes, [vy * 64 + vx]: four to a word, four words to a vector.
#ifdef __cplusplus
  uint blur_slice[1024];
#else
  uvec4 blur_slice[256];
#endif
};

struct RequestConstants {
  FrameConstants frame;
  uint budget;    // evaluations that may be asked for
  uint capacity;  // entries of the list; the bins lie behind
  uint padding_0;
  uint padding_1;
};

struct ResidualConstants {
  FrameConstants frame;
};

struct CoverageConstants {
  FrameConstants frame;
  float depth_tolerance;  // relative
  float padding_0;
  float padding_1;
  float padding_2;
};

#ifdef __cplusplus
static_assert(sizeof(CoverageConstants) == 128);
static_assert(sizeof(AmortizedConstants) == 112 + 4 * 48 + 128 + 16 + 48 + 4096);
static_assert(sizeof(RequestConstants) == 128);
}  // namespace reprise::amortized
#endif

#endif
