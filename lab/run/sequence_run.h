// SPDX-License-Identifier: MIT
//
// One technique over one sequence: plan, render, resolve. Measuring is apart, so that timings are
// not disturbed by it.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "lab/frame_inputs.h"
#include "lab/run/pass_times.h"
#include "lab/run/resolver.h"

namespace reprise::lab {

struct SequenceRun {
  std::vector<FloatImage> images;      // RGBA linear, a frame each
  PassTimes render_times;              // the source's passes
  PassTimes resolve_times;             // the technique's
  double evaluations_per_pixel = 0.0;  // mean over frames; 0 where not known
};

struct FrameDone {
  uint32_t index;
  const FrameInputs& inputs;
  const FloatImage& image;
};

// Runs frames [0, frames) of `source`. `done` is called after each frame, while its inputs are
// still on the device; null is allowed. With `keep_images` false, images stay empty.
SequenceRun runSequence(Device& device, FrameSource& source, Resolver& resolver, uint32_t frames,
                        bool keep_images, const std::function<void(const FrameDone&)>& done);
// These frames alone, in this order: for techniques without history.
SequenceRun runFrames(Device& device, FrameSource& source, Resolver& resolver,
                      std::span<const uint32_t> frames, bool keep_images,
                      const std::function<void(const FrameDone&)>& done);

// These frames by several techniques. Those whose plans for a frame agree share one rendering of
// it, whose times and evaluations are each one's: resolving costs little beside it. `done` is
// called with the resolver's number. Images are not kept.
std::vector<SequenceRun> runShared(Device& device, FrameSource& source,
                                   std::span<const std::unique_ptr<Resolver>> resolvers,
                                   std::span<const uint32_t> frames,
                                   const std::function<void(size_t, const FrameDone&)>& done);

// Frames [0, frames) by each resolver in turn, frame by frame, so that what disturbs a busy machine
// for seconds disturbs all alike: ratios of times are taken from this. Images are not kept.
std::vector<SequenceRun> runTogether(Device& device, FrameSource& source,
                                     std::span<const std::unique_ptr<Resolver>> resolvers,
                                     uint32_t frames, const std::function<void()>& done);

}  // namespace reprise::lab
