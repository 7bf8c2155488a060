// SPDX-License-Identifier: MIT
#ifndef REPRISE_TECHNIQUES_AMORTIZED_SHARED_H
#define REPRISE_TECHNIQUES_AMORTIZED_SHARED_H

#include "core/frame_constants.h"

#ifdef __cplusplus
namespace reprise::amortized {
using eq::vec4;
using uint = uint32_t;
#endif

// Of one subpixel buffer, as a frame finds it.
struct BufferState {
  vec4 place_age;           // xy: its place in the pixel (px), z: age in frames, w: 1 if written
  vec4 depth_coefficients;  // eq. expectedPreviousDepth, to the frame that wrote it
};

struct AmortizedConstants {
  FrameConstants frame;
  BufferState buffers[4];
  vec4 exposure_ratios;   // of each buffer: colour * ratio has this frame's exposure
  vec4 writes[8];         // element n of 32: how often the buffer to be written was in n frames
  vec4 target_px;         // xy: place of the buffer to be written
  float writes_a_period;  // of one buffer in 32 frames
  float max_samples;
  float depth_tolerance;     // relative
  float residual_tolerance;  // tau_eps; 0: off
  float fixed_alpha;         // 0: by (26)
  float extra_given;         // 1: the frame came with served requests
  float sequence_break;      // 1: no buffer holds anything
  float blur_scale;          // 1; 0 switches the blur bound off
  // Slice of alpha_tau_b, bytes, [vy * 64 + vx]: four to a word, four words to a vector.
#ifdef __cplusplus
  uint blur_slice[1024];
#else
  uvec4 blur_slice[256];
#endif
};

struct ResidualConstants {
  FrameConstants frame;
};

#ifdef __cplusplus
static_assert(sizeof(AmortizedConstants) == 112 + 4 * 32 + 16 + 128 + 16 + 32 + 4096);
}  // namespace reprise::amortized
#endif

#endif
