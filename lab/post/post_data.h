// SPDX-License-Identifier: MIT
//
// What the post chain's passes share, in GLSL and C++.
#ifndef REPRISE_LAB_POST_DATA_H
#define REPRISE_LAB_POST_DATA_H

#include "equations/language.h"

#ifdef __cplusplus
namespace reprise::lab {
using eq::uint;
#endif

// What the eye has become used to; one a chain, written by adapt.comp.
struct Adaptation {
  float luminance;  // scene units; see adaptedLuminance
  float exposure;   // exposureFor it
};

struct AdaptConstants {
  uint groups;  // sums that meter.comp has written
  uint pixels;  // that they are of
  float frame_time_s;
  float constant_s;
  uint reset;  // 1: the eye has looked at this picture for long
};

struct BloomConstants {
  float spread;  // share that the coarser levels have in a level
};

struct ShowConstants {
  float bloom;  // share of the blurred picture
};

#ifdef __cplusplus
}  // namespace reprise::lab
#endif

#endif
