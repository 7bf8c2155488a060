// SPDX-License-Identifier: MIT
// Specialization constants of resolve.comp, in the order in which taa.cpp fills them.
#ifndef REPRISE_TECHNIQUES_TAA_OPTIONS_GLSL
#define REPRISE_TECHNIQUES_TAA_OPTIONS_GLSL

layout(constant_id = 0) const uint kDilation = 0u;
layout(constant_id = 1) const uint kHistoryFilter = 0u;
layout(constant_id = 2) const uint kClip = 0u;
layout(constant_id = 3) const uint kClipToward = 0u;
layout(constant_id = 4) const uint kClipYCoCg = 0u;
layout(constant_id = 5) const uint kWeighting = 0u;
layout(constant_id = 6) const uint kAntiFlicker = 0u;
layout(constant_id = 7) const uint kDepthTest = 0u;
layout(constant_id = 8) const uint kMotionTest = 0u;
layout(constant_id = 9) const uint kIdTest = 0u;
layout(constant_id = 10) const uint kReactive = 0u;
layout(constant_id = 11) const uint kRejectedBlur = 0u;
layout(constant_id = 12) const uint kSpatial = 0u;
layout(constant_id = 13) const uint kExtendOffscreen = 0u;
layout(constant_id = 14) const uint kStill = 0u;
layout(constant_id = 15) const uint kDither = 0u;
layout(constant_id = 16) const uint kWriteOutput = 1u;  // 0: the sharpening pass writes it
layout(constant_id = 17) const uint kCorners = 1u;      // 0: nothing reads the corners of the 3x3

#endif
