// SPDX-License-Identifier: MIT
//
// Shared by the host and the shaders of `reprise`.
#ifndef REPRISE_TECHNIQUES_REPRISE_SHARED_H
#define REPRISE_TECHNIQUES_REPRISE_SHARED_H

#include "core/frame_constants.h"

#ifdef __cplusplus
namespace reprise {
namespace reprise_technique {
#endif

#ifdef __cplusplus
#define REPRISE_NUMBER(type, name, value) constexpr type name = value
#else
#define REPRISE_NUMBER(type, name, value) const type name = value
#endif
REPRISE_NUMBER(int, kTileSize_px, 8);
// Changes are relative to luma; what is darker than this counts as this dark.
REPRISE_NUMBER(float, kDarkest, 0.02f);
// A change below 1/255 is not seen.
REPRISE_NUMBER(float, kResponseFloor, 1.0f / 65025.0f);

struct RepriseConstants {
  FrameConstants frame;
  vec4 texel_weights;     // of this frame's sample for the four texels of its pixel
  vec2 tile_uv;           // pixels to the coordinate of the tile images
  float history_limit;    // samples a texel's mean goes on to in motion
  float still_limit;      // and at rest
  float bound_wide;       // half-size of the bound without evidence, standard deviations
  float bound_tight;      // with full evidence
  float depth_tolerance;
  float sharpness;        // c of the cubic
  float memory;           // weight of a new residual in its running mean
  float doubt_now;        // variances of a frame's residual that are no evidence
  float doubt_mean;       // the same of the running mean
  float evidence_count;   // residuals of 3x3 that count as independent
  float forget;
  float x0;
  float x1;
  float x2;
  float tile_count;
  float doubt_tile;
  float x3;
  float x4;
};

#ifdef __cplusplus
static_assert(sizeof(RepriseConstants) == sizeof(FrameConstants) + 96);
}  // namespace reprise_technique
}  // namespace reprise
#endif

#endif
