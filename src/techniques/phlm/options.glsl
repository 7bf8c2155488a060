// SPDX-License-Identifier: MIT
// Specialization constants of the passes of `phlm`, in the order in which phlm.cpp fills them.
#ifndef REPRISE_TECHNIQUES_PHLM_OPTIONS_GLSL
#define REPRISE_TECHNIQUES_PHLM_OPTIONS_GLSL

layout(constant_id = 0) const uint kStorage = 0u;
layout(constant_id = 1) const uint kHardwareBilinear = 1u;  // 0: the models' format has none
layout(constant_id = 2) const uint kHistoryFilter = 0u;
layout(constant_id = 3) const uint kClip = 0u;
layout(constant_id = 4) const uint kBox = 0u;
layout(constant_id = 5) const uint kBoxYCoCg = 0u;
layout(constant_id = 6) const uint kLowPass = 0u;
layout(constant_id = 7) const uint kFeatureWeight = 0u;
layout(constant_id = 8) const uint kCompressed = 0u;  // models of c / (1 + luma), not of light
layout(constant_id = 9) const uint kDilation = 0u;
layout(constant_id = 10) const uint kStill = 0u;
layout(constant_id = 11) const uint kUpdate = 0u;
layout(constant_id = 12) const uint kFused = 0u;  // the filter makes the feature as well
layout(constant_id = 13) const uint kBoxFeature = 0u;
layout(constant_id = 14) const uint kAboutZero = 0u;  // stored models; else about the feature
layout(constant_id = 15) const uint kForget = 0u;

#endif
