// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>

#include "reprise/reprise.h"

namespace reprise::lab {

struct FrameInputs;

// How a source should sample a frame: what the technique's library context asks for, and what only
// the lab can do.
struct SamplePlan {
  RepriseSamplePlan library{.size = sizeof(RepriseSamplePlan), .coarse_size = 1};
  // N x N stratified samples a pixel, each with its own visibility and shading, averaged with a box
  // of one pixel. 1: one sample at the jitter.
  uint32_t grid = 1;
  // Where set, a source that renders calls it once depth and motion are recorded, and shades what
  // the list then asks for, by indirect dispatch, into FrameInputs::extra.
  std::function<RepriseSampleRequests(VkCommandBuffer, const FrameInputs&)> request;
};

}  // namespace reprise::lab
