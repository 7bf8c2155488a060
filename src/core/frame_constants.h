// SPDX-License-Identifier: MIT
//
// What every resolve needs to know of a frame; GLSL and C++. First member of a technique's uniform
// block. Vectors first, a multiple of 16 bytes, so that std140 and C++ agree.
#ifndef REPRISE_CORE_FRAME_CONSTANTS_H
#define REPRISE_CORE_FRAME_CONSTANTS_H

#include "equations/language.h"

#ifdef __cplusplus
namespace reprise {
using eq::vec2;
using eq::vec4;
#endif

struct FrameConstants {
  vec4 view_depth_coefficients;      // view_depth = (x * depth + y) / (z * depth + w)
  vec4 previous_depth_coefficients;  // see eq. expectedPreviousDepth
  vec2 motion_scale;                 // motion texel -> px
  vec2 motion_offset_px;             // added to it
  vec2 jitter_px;
  vec2 previous_jitter_px;
  vec2 extent_px;           // of this frame's input
  vec2 previous_extent_px;  // likewise, of the frame that wrote the history
  vec2 history_texel_uv;    // 1 / extent of the history images
  float exposure_ratio;     // history colour * exposure_ratio has this frame's exposure
  float has_history;        // 0 or 1
  float depth_order;        // +1: depth grows with distance, -1: reversed
  float reactive_given;     // 0 or 1: the frame came with a reactive mask
  float id_given;           // 0 or 1: the frame came with ids
  float frame_number;       // record count modulo 2^20, for noise that differs from frame to frame
};

#ifdef __cplusplus
static_assert(sizeof(FrameConstants) == 112);

struct FrameState;
FrameConstants frameConstants(const FrameState& state, VkExtent2D history_extent);
}  // namespace reprise
#endif

#endif
