// SPDX-License-Identifier: MIT
#include "techniques/amortized/sampling.h"

#include <algorithm>

namespace reprise::amortized {
namespace {

// A normal deviate for a whole frame, for samples=frame.
constexpr uint32_t kFrameJitterSeed = 0x9e3779b9u;
// A jitter farther out than this would leave the range of a plan.
constexpr float kFarthestJitter_px = 1.0f;

// What amortized_coverage.comp knows the positions of.
constexpr uint32_t kCoverageSamples = 4;

// The ages that a frame finds its buffers in.
void planMotionBack(const PlanRequest& request, RepriseSamplePlan& plan) {
  const uint32_t count = bufferCount(request.settings);
  for (uint32_t buffer = 0; buffer < count; ++buffer) {
    const uint64_t furthest = std::min<uint64_t>(request.frame_index, kPeriod);
    for (uint32_t age = 1; age <= furthest; ++age) {
      if (bufferOf(request.settings, request.frame_index - age) != buffer) continue;
      if (age <= REPRISE_MAX_MOTION_BACK) plan.motion_back |= 1u << (age - 1);
      break;
    }
  }
}

}  // namespace

uint32_t bufferOf(const Settings& settings, uint64_t frame_index) {
  const uint32_t count = bufferCount(settings);
  if (settings.choice(kOrder) == kOrderRoundRobin) {
    return static_cast<uint32_t>(frame_index % count);
  }
  return bufferOfFrame(count, frame_index);
}

void planSampling(const PlanRequest& request, RepriseSamplePlan& plan) {
  const Settings& settings = request.settings;
  const BufferLayout layout = bufferLayout(bufferCount(settings));
  const uint32_t quadrant = layout.quadrants[bufferOf(settings, request.frame_index)];
  const auto frame = static_cast<uint32_t>(request.frame_index);
  if (settings.choice(kSamples) == kSamplesFrame) {
    const eq::vec2 place = eq::shadingOffset(frame, 0, kFrameJitterSeed, layout.sigma_px, quadrant);
    plan.jitter_px[0] = std::clamp(-place.x, -kFarthestJitter_px, kFarthestJitter_px);
    plan.jitter_px[1] = std::clamp(-place.y, -kFarthestJitter_px, kFarthestJitter_px);
  } else {
    plan.shading_offset = REPRISE_SHADING_OFFSET_HASH_GAUSSIAN;
    plan.shading_offset_sigma_px = layout.sigma_px;
    plan.shading_offset_seed = frame;
    plan.shading_offset_quadrant = quadrant;
  }
  if (settings.on(kCoverage)) plan.depth_samples = kCoverageSamples;
  if (settings.choice(kMotion) == kMotionExact) planMotionBack(request, plan);
}

uint32_t bufferWrittenBy(const FrameState& state) {
  const uint32_t count = bufferCount(state.settings);
  const uint32_t planned = bufferOf(state.settings, state.frame.frame_index);
  if (count == 1) return 0;
  const eq::vec2 sample_px = eq::vec2(-state.jitter_px.x, -state.jitter_px.y);
  const bool shading = state.settings.choice(kSamples) == kSamplesShading;
  if (shading && sample_px.x == 0.0f && sample_px.y == 0.0f) return planned;
  // A Gaussian about the quadrant's centre may reach the next quadrant: the plan's own frames
  // stay with the plan.
  RepriseSamplePlan plan{};
  planSampling({state.frame.frame_index, state.input_extent, state.output_extent, state.settings},
               plan);
  if (plan.jitter_px[0] == state.jitter_px.x && plan.jitter_px[1] == state.jitter_px.y) {
    return planned;
  }
  if (count == 2) return sample_px.x + sample_px.y > 0.0f ? 1 : 0;
  return (sample_px.x > 0.0f ? 2u : 0u) + (sample_px.y > 0.0f ? 1u : 0u);
}

}  // namespace reprise::amortized
