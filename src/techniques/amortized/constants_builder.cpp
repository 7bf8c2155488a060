// SPDX-License-Identifier: MIT
#include "techniques/amortized/constants_builder.h"

#include <cmath>
#include <cstring>

#include "equations/reprojection.h"
#include "techniques/amortized/sampling.h"

namespace reprise::amortized {

bool hasMotionTo(const BufferHistory& past, const FrameState& state, bool exact, uint32_t slot) {
  if (slot >= past.slots() || !past.slot(slot).has_value()) return false;
  if (!exact) return true;
  const uint32_t age = past.ageOf(slot, state.record);
  return age >= 1 && age <= state.frame.motion_back_count &&
         state.frame.motion_back[age - 1].view != VK_NULL_HANDLE;
}

AmortizedConstants ConstantsBuilder::of(const BufferHistory& past, const FrameState& state,
                                        VkExtent2D history_extent, bool exact_motion,
                                        uint32_t target_slot) {
  const Settings& s = state.settings;
  const uint32_t count = bufferCount(s);
  const BufferLayout layout = bufferLayout(count);
  AmortizedConstants constants{};
  constants.previous_slot = -1.0f;
  constants.frame = frameConstants(state, history_extent);
  for (uint32_t slot = 0; slot < kMaxBuffers; ++slot) {
    SlotState& to = constants.slots[slot];
    to.place_age = eq::vec4(0.0f, 0.0f, 1.0f, 0.0f);
    to.depth_coefficients = eq::vec4(0.0f, 0.0f, 1.0f, 0.0f);
    to.exposure_ratio = 1.0f;
    to.quadrants = slot < past.slots() ? past.quadrantsOf(slot) : 0;
    if (!hasMotionTo(past, state, exact_motion, slot)) continue;
    const BufferHistory::Written& written = *past.slot(slot);
    const eq::vec2 place = eq::quadrantOffset(written.quadrant);
    to.place_age =
        eq::vec4(place.x, place.y, static_cast<float>(past.ageOf(slot, state.record)), 1.0f);
    if (past.ageOf(slot, state.record) == 1) constants.previous_slot = static_cast<float>(slot);
    to.jitter_px = written.jitter_px;
    to.exposure_ratio = state.frame.pre_exposure / written.pre_exposure;
    if (state.frame.camera != nullptr && written.camera.has_value()) {
      to.depth_coefficients = eq::previousDepthCoefficients(
          state.frame.camera->view, state.frame.camera->projection, written.camera->view,
          static_cast<float>(state.input_extent.width),
          static_cast<float>(state.input_extent.height));
    }
  }
  const std::array<float, kPeriod> writes = past.writesAmongLast(target_slot);
  for (uint32_t n = 0; n < kPeriod; ++n)
    constants.writes[n / 4][static_cast<int>(n % 4)] = writes[n];
  constants.writes_a_period = static_cast<float>(kPeriod / count);
  const eq::vec2 place = eq::quadrantOffset(layout.quadrants[bufferWrittenBy(state)]);
  constants.target_px = eq::vec4(place.x, place.y, layout.tent_radius_px, 0.0f);
  constants.buffer_count = static_cast<float>(count);
  constants.max_samples = s.real(kMaxSamples);
  constants.depth_tolerance = s.real(kDepthTolerance);
  constants.residual_tolerance = s.real(kResidual);
  constants.fixed_alpha = s.real(kFixedAlpha);
  constants.quality = s.real(kQuality);
  constants.shutter = s.real(kShutter);
  constants.extra_given = state.frame.extra.view != VK_NULL_HANDLE ? 1.0f : 0.0f;
  const double threshold_px2 = blurTolerance(s);
  if (slice_buffers_ != count || slice_threshold_px2_ != threshold_px2) {
    slice_ = blurSlice(count, threshold_px2);
    slice_buffers_ = count;
    slice_threshold_px2_ = threshold_px2;
  }
  static_assert(sizeof(constants.blur_slice) == sizeof(BlurSlice));
  std::memcpy(constants.blur_slice, slice_.data(), slice_.size());
  return constants;
}

RequestConstants requestConstants(const FrameState& state, VkExtent2D history_extent,
                                  uint32_t capacity) {
  RequestConstants constants{};
  constants.frame = frameConstants(state, history_extent);
  const double pixels = static_cast<double>(state.output_extent.width) * state.output_extent.height;
  constants.budget =
      static_cast<uint32_t>(std::floor((state.settings.number(kBudget) - 1.0) * pixels));
  constants.capacity = capacity;
  return constants;
}

}  // namespace reprise::amortized
