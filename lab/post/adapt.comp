// SPDX-License-Identifier: MIT
//
// One group: the picture's luminance from meter.comp's sums, and the eye that follows it.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/workgroup.h"
#include "equations/exposure.h"
#include "lab/post/post_data.h"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

layout(binding = 0, std430) readonly buffer Sums {
  float sums[];
};
layout(binding = 1, std430) buffer Eye {
  Adaptation eye;
};
layout(push_constant) uniform Push {
  AdaptConstants push;
};

const uint kThreads = REPRISE_WORKGROUP_SIZE * REPRISE_WORKGROUP_SIZE;
shared float partial[kThreads];

void main() {
  uint thread = gl_LocalInvocationIndex;
  float sum = 0.0;
  for (uint i = thread; i < push.groups; i += kThreads) sum += sums[i];
  partial[thread] = sum;
  barrier();
  if (thread != 0u) return;
  float whole = 0.0;
  for (uint i = 0u; i < kThreads; ++i) whole += partial[i];
  float now = exp(whole / float(push.pixels));
  float before = push.reset != 0u ? now : eye.luminance;
  eye.luminance = adaptedLuminance(before, now, push.frame_time_s, push.constant_s);
  eye.exposure = exposureFor(eye.luminance);
}
