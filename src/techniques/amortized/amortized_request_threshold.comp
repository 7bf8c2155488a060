// SPDX-License-Identifier: MIT
//
// How many bins, the worst first, the budget reaches: one workgroup sums them up. A whole number of
// bins, so that the budget holds exactly and the choice depends on no order of invocations.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/workgroup.h"
#include "techniques/amortized/amortized_shared.h"

const uint kInvocations = REPRISE_WORKGROUP_SIZE * REPRISE_WORKGROUP_SIZE;
layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

layout(binding = 0, std430) buffer Requests {
  uint header[4];
  uint entries[];
};
layout(binding = 1, std140) uniform Constants {
  RequestConstants k;
};

const uint kBinsEach = kRequestBins / kInvocations;
shared uint sums[kInvocations];
shared uint reached;

void main() {
  uint own = gl_LocalInvocationIndex;
  uint first = k.capacity + own * kBinsEach;
  uint sum = 0u;
  for (uint i = 0u; i < kBinsEach; ++i) sum += entries[first + i];
  sums[own] = sum;
  if (own == 0u) reached = 0u;
  barrier();
  uint before = 0u;
  for (uint other = 0u; other < own; ++other) before += sums[other];
  uint within = 0u;
  for (uint i = 0u; i < kBinsEach; ++i) {
    before += entries[first + i];
    if (before <= k.budget) within = own * kBinsEach + i + 1u;
  }
  atomicMax(reached, within);
  barrier();
  if (own == 0u) entries[k.capacity + kRequestBins] = reached;
}
