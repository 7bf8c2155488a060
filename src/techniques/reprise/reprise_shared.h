// SPDX-License-Identifier: MIT
//
// Shared by the host and the shaders of `reprise`.
#ifndef REPRISE_TECHNIQUES_REPRISE_SHARED_H
#define REPRISE_TECHNIQUES_REPRISE_SHARED_H

#include "core/frame_constants.h"

#ifdef __cplusplus
#define REPRISE_NUMBER constexpr
namespace reprise {
namespace reprise_technique {
#else
#define REPRISE_NUMBER const
#endif

REPRISE_NUMBER int kTileSize_px = 8;
// Changes are relative to luma; what is darker than this counts as this dark.
REPRISE_NUMBER float kDarkest = 0.02f;
// Square of a relative change that is not seen: 1/255.
REPRISE_NUMBER float kSmallestSquare = 1.0f / 65025.0f;

struct RepriseConstants {
  FrameConstants frame;
  vec2 output_extent_px;
  vec2 previous_output_extent_px;
  vec2 output_texel_uv;     // 1 / largest extent of the output
  vec2 tile_uv;             // pixel to coordinate of the tile images
  vec2 last_tile_uv;        // coordinate of the last tile's centre
  float sample_width;       // output px
  float history_uncovered;  // samples, over the share of taps
  float history;            // samples a texel's mean goes on to in motion
  float still_history;
  float bound;           // half-size of the bound in standard deviations, without evidence
  float bound_faint;     // where content is faint, without evidence
  float bound_changed;   // with full evidence
  float bound_still;     // at rest without evidence
  float forget_clipped;  // share of the count that a fully clipped texel loses
  float forget_changed;  // the same of a texel whose change is fully believed
  float sharpness;       // share of Lanczos, the rest is bilinear
  float depth_tolerance;
  float doubt_light;
  float doubt_now;
  float doubt_mean;
  float far_frames;     // that history's farthest depth is kept for after it was last seen
  float bound_apart;    // where neighbours' motions part
  float flips;          // least half-size of the bound in motion, in flips of a pixel
  float tone;           // how much less bright samples weigh, a unit of luma
  float chance_flips;   // flips below this count for nothing in motion
  float alone_samples;  // held, from which on history stands without the frame's own smoothing
  float unused_0;
};

#ifdef __cplusplus
static_assert(sizeof(RepriseConstants) == sizeof(FrameConstants) + 128);
}  // namespace reprise_technique
}  // namespace reprise
#endif

#endif
