// SPDX-License-Identifier: MIT
#ifndef REPRISE_TECHNIQUES_REPROJECTION_SHARED_H
#define REPRISE_TECHNIQUES_REPROJECTION_SHARED_H

#include "core/frame_constants.h"

#ifdef __cplusplus
namespace reprise {
#endif

struct ReprojectionConstants {
  FrameConstants frame;
  float alpha;            // weight of the current sample
  float depth_tolerance;  // relative
  vec2 padding;
};

#ifdef __cplusplus
static_assert(sizeof(ReprojectionConstants) == 128);
}  // namespace reprise
#endif

#endif
