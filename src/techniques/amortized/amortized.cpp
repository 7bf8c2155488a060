// SPDX-License-Identifier: MIT
#include <cstring>
#include <optional>

#include "reprise/reprise.h"
// reprise.h first: shared headers are GLSL too and include no Vulkan header.
#include "core/context.h"
#include "techniques/amortized/amortized_passes.h"
#include "techniques/amortized/amortized_settings.h"
#include "techniques/amortized/buffer_history.h"
#include "techniques/amortized/constants_builder.h"
#include "techniques/amortized/sampling.h"

namespace reprise::amortized {
namespace {

class Amortized final : public Technique {
 public:
  void plan(const PlanRequest& request, RepriseSamplePlan& plan) const override {
    planSampling(request, plan);
  }

  void declare(Declaration& declaration) override {
    const Settings& s = declaration.settings;
    const VkExtent2D extent = declaration.max_output_extent;
    const uint32_t slots = slotCount(s);
    // What was gathered lies in images that may not outlive this.
    gathered_for_.reset();
    past_.setSlots(slots);
    variant_ = {.slots = slots,
                .exact_motion = s.choice(kMotion) == kMotionExact,
                .silhouettes = s.choice(kSamples) == kSamplesFrame,
                .residuals = s.number(kResidual) > 0.0,
                .coverage = s.on(kCoverage),
                .shutter = s.number(kShutter) > 0.0};
    const VkFormat one =
        declaration.storable(VK_FORMAT_R16_SFLOAT) ? VK_FORMAT_R16_SFLOAT : VK_FORMAT_R32_SFLOAT;
    // One more than are read: a gather reads neighbours of the buffer that is written.
    buffers_ = declaration.history("subpixel buffers: color, view depth",
                                   VK_FORMAT_R16G16B16A16_SFLOAT, extent, slots + 1);
    samples_ = declaration.history("effective samples", one, extent, 2);
    if (!variant_.exact_motion) {
      motion_0_ =
          declaration.history("motion to buffers 0, 1", VK_FORMAT_R16G16B16A16_SFLOAT, extent, 2);
      if (slots > 2) {
        motion_1_ =
            declaration.history("motion to buffers 2, 3", VK_FORMAT_R16G16B16A16_SFLOAT, extent, 2);
      }
    }
    if (variant_.residuals) {
      residual_ = declaration.history("residuals", VK_FORMAT_R8G8B8A8_SNORM, extent, 2);
      row_means_ = declaration.history("residual row means", one, extent, 1);
      smoothed_ = declaration.history("smoothed residual", one, extent, 1);
    }
    if (s.on(kRequests)) {
      failed_ = declaration.history(
          "failed quadrants",
          declaration.storable(VK_FORMAT_R8_UNORM) ? VK_FORMAT_R8_UNORM : VK_FORMAT_R32_SFLOAT,
          extent, 1);
      gathered_ =
          declaration.history("gathered color, weight", VK_FORMAT_R16G16B16A16_SFLOAT, extent, 1);
      request_ = declareRequestPasses(declaration, variant_);
    }
    resolve_ = declareResolvePass(declaration, variant_);
    if (variant_.residuals) smooth_ = declareResidualPasses(declaration);
    if (variant_.coverage) {
      resolved_ = declaration.history("resolved color", VK_FORMAT_R16G16B16A16_SFLOAT, extent, 1);
      coverage_ = declareCoveragePass(declaration);
    }
  }

  void recordRequest(Recorder& recorder, const FrameState& state) override {
    beginFrame(state);
    const uint32_t target = targetOf(state);
    const VkImageView failed = recorder.history(failed_).current(0);
    const RequestConstants constants =
        requestConstants(state, recorder.history(buffers_).extent(), recorder.requestCapacity());
    const AmortizedConstants gathering = constantsOf(recorder, state, target);
    PassRecording gather = recorder.pass(request_.gather);
    bindReprojection(gather, recorder, state);
    gather.buffer(recorder.requests()).write(failed).constants(gathering);
    bindPrevious(gather, recorder, state);
    gather.write(recorder.history(gathered_).current(0));
    writeNext(gather, recorder, state);
    gather.write(changeBound(recorder)).dispatch(state.output_extent);
    gathered_for_ = gathering;
    recorder.pass(request_.threshold)
        .buffer(recorder.requests())
        .constants(constants)
        .dispatch({1, 1});
    recorder.pass(request_.list)
        .read(failed)
        .buffer(recorder.requests())
        .constants(constants)
        .dispatch(state.output_extent);
  }

  void record(Recorder& recorder, const FrameState& state) override {
    beginFrame(state);
    const uint32_t target = targetOf(state);
    const AmortizedConstants constants = constantsOf(recorder, state, target);
    const bool gathered = gathered_for_.has_value() && gatheredAlike(*gathered_for_, constants);
    gathered_for_.reset();
    if (gathered) {
      recordBlend(recorder, state, constants);
    } else {
      recordResolve(recorder, state, constants);
    }
    if (variant_.coverage) recordCoverage(recorder, state);
    if (variant_.residuals) recordResiduals(recorder, state);
    BufferHistory::Written written{
        .record = state.record,
        .quadrant = bufferLayout(bufferCount(state.settings)).quadrants[bufferWrittenBy(state)],
        .pre_exposure = state.frame.pre_exposure,
        .jitter_px = state.jitter_px,
        .camera = {}};
    if (state.frame.camera != nullptr) written.camera = *state.frame.camera;
    past_.wrote(target, written);
  }

 private:
  // Request and record of one frame both come here; the second finds nothing to do.
  void beginFrame(const FrameState& state) {
    past_.forgetIfBroken(state.has_history, state.output_extent, state.record);
    const uint32_t count = bufferCount(state.settings);
    past_.use(count, [&](uint32_t n) {
      // Frame indices may begin anywhere; the order has a period.
      const uint64_t index = state.frame.frame_index + kPeriod - 1 - n;
      return slotOfBuffer(past_.slots(), count, bufferOf(state.settings, index));
    });
  }

  uint32_t targetOf(const FrameState& state) const {
    return slotOfBuffer(past_.slots(), bufferCount(state.settings), bufferWrittenBy(state));
  }

  // What `gathered` says holds for a frame of `now` as well, but for what was shaded since.
  static bool gatheredAlike(AmortizedConstants gathered, const AmortizedConstants& now) {
    gathered.extra_given = now.extra_given;
    return std::memcmp(&gathered, &now, sizeof now) == 0;
  }

  void recordBlend(Recorder& recorder, const FrameState& state,
                   const AmortizedConstants& constants) {
    const VkImageView none = recorder.orFloatPlaceholder({}).view;
    const VkImageView buffer = recorder.history(buffers_).copy(past_.spareCopy());
    const VkImageView samples = recorder.history(samples_).current(state.record);
    const VkImageView residual =
        variant_.residuals ? recorder.history(residual_).current(state.record) : none;
    PassRecording pass = recorder.pass(request_.blend);
    pass.read(state.frame.depth).read(state.frame.motion);
    pass.read(state.frame.color).read(recorder.orFloatPlaceholder(state.frame.extra));
    pass.read(recorder.history(gathered_).current(0)).read(buffer).read(samples).read(residual);
    pass.read(changeBound(recorder));
    pass.write(buffer).write(samples).write(residual).write(shownImage(recorder, state));
    pass.constants(constants).dispatch(state.output_extent);
    recorder.pass(resolve_).skip();
  }

  void recordResolve(Recorder& recorder, const FrameState& state,
                     const AmortizedConstants& constants) {
    if (state.settings.on(kRequests)) recorder.pass(request_.blend).skip();
    PassRecording pass = recorder.pass(resolve_);
    bindReprojection(pass, recorder, state);
    pass.read(state.frame.color);
    pass.read(recorder.orFloatPlaceholder(state.frame.extra));
    bindPrevious(pass, recorder, state);
    writeNext(pass, recorder, state);
    pass.write(shownImage(recorder, state)).constants(constants).dispatch(state.output_extent);
  }

  // N, the buffer that the previous frame wrote, residuals.
  void bindPrevious(PassRecording& pass, Recorder& recorder, const FrameState& state) const {
    const RepriseImage none = recorder.orFloatPlaceholder({});
    pass.read(recorder.history(samples_).previous(state.record));
    pass.read(newestBuffer(recorder, state));
    if (variant_.residuals) {
      pass.read(recorder.history(residual_).previous(state.record));
      pass.read(recorder.history(smoothed_).current(0));
    } else {
      pass.read(none).read(none);
    }
  }

  void writeNext(PassRecording& pass, Recorder& recorder, const FrameState& state) const {
    const VkImageView none = recorder.orFloatPlaceholder({}).view;
    const auto currentOr = [&](bool there, HistoryHandle handle) {
      return there ? recorder.history(handle).current(state.record) : none;
    };
    pass.write(recorder.history(buffers_).copy(past_.spareCopy()));
    pass.write(recorder.history(samples_).current(state.record));
    pass.write(currentOr(!variant_.exact_motion, motion_0_));
    pass.write(currentOr(!variant_.exact_motion && variant_.slots > 2, motion_1_));
    pass.write(currentOr(variant_.residuals, residual_));
  }

  // Between request and resolve the first of the residual passes' images is free.
  VkImageView changeBound(Recorder& recorder) const {
    return variant_.residuals ? recorder.history(row_means_).current(0)
                              : recorder.orFloatPlaceholder({}).view;
  }

  VkImageView shownImage(Recorder& recorder, const FrameState& state) const {
    return composesCoverage(state) ? recorder.history(resolved_).current(0)
                                   : state.frame.output.view;
  }

  // What the previous frame wrote, with its depths; any buffer where it wrote none.
  VkImageView newestBuffer(Recorder& recorder, const FrameState& state) const {
    uint32_t newest = 0;
    for (uint32_t slot = 0; slot < past_.slots(); ++slot) {
      if (past_.slot(slot).has_value() && past_.ageOf(slot, state.record) == 1) newest = slot;
    }
    return recorder.history(buffers_).copy(past_.copyOf(newest));
  }

  bool composesCoverage(const FrameState& state) const {
    return variant_.coverage && state.frame.depth_samples.view != VK_NULL_HANDLE;
  }

  void recordCoverage(Recorder& recorder, const FrameState& state) {
    PassRecording pass = recorder.pass(coverage_);
    if (!composesCoverage(state)) {
      pass.skip();
      return;
    }
    CoverageConstants constants{};
    constants.frame = frameConstants(state, recorder.history(buffers_).extent());
    constants.depth_tolerance = state.settings.real(kDepthTolerance);
    pass.read(recorder.history(resolved_).current(0))
        .read(state.frame.depth)
        .read(state.frame.depth_samples)
        .write(state.frame.output.view)
        .constants(constants)
        .dispatch(state.output_extent);
  }

  void recordResiduals(Recorder& recorder, const FrameState& state) {
    const ResidualConstants constants{frameConstants(state, recorder.history(buffers_).extent())};
    const VkImageView rows = recorder.history(row_means_).current(0);
    recorder.pass(smooth_.rows)
        .read(recorder.history(residual_).current(state.record))
        .write(rows)
        .constants(constants)
        .dispatch(state.output_extent);
    recorder.pass(smooth_.columns)
        .read(rows)
        .write(recorder.history(smoothed_).current(0))
        .constants(constants)
        .dispatch(state.output_extent);
  }

  void bindReprojection(PassRecording& pass, Recorder& recorder, const FrameState& state) const {
    const RepriseImage none = recorder.orFloatPlaceholder({});
    pass.read(state.frame.depth).read(state.frame.motion);
    if (variant_.exact_motion) {
      for (uint32_t slot = 0; slot < kMaxBuffers; ++slot) {
        pass.read(hasMotionTo(past_, state, true, slot)
                      ? state.frame.motion_back[past_.ageOf(slot, state.record) - 1]
                      : none);
      }
    } else {
      pass.read(recorder.history(motion_0_).previous(state.record));
      if (variant_.slots > 2) {
        pass.read(recorder.history(motion_1_).previous(state.record));
      } else {
        pass.read(none);
      }
      pass.read(none).read(none);
    }
    const HistoryImage& buffers = recorder.history(buffers_);
    for (uint32_t slot = 0; slot < kMaxBuffers; ++slot) {
      pass.read(buffers.copy(past_.copyOf(slot)));
    }
  }

  AmortizedConstants constantsOf(const Recorder& recorder, const FrameState& state,
                                 uint32_t target) {
    return constants_.of(past_, state, recorder.history(buffers_).extent(), variant_.exact_motion,
                         target);
  }

  Variant variant_;
  BufferHistory past_;
  ConstantsBuilder constants_;
  std::optional<AmortizedConstants> gathered_for_;  // the request of a frame not yet resolved
  HistoryHandle buffers_ = 0;
  HistoryHandle samples_ = 0;
  HistoryHandle motion_0_ = 0;
  HistoryHandle motion_1_ = 0;
  HistoryHandle residual_ = 0;
  HistoryHandle row_means_ = 0;
  HistoryHandle smoothed_ = 0;
  HistoryHandle failed_ = 0;
  HistoryHandle gathered_ = 0;
  HistoryHandle resolved_ = 0;
  RequestPasses request_;
  PassHandle resolve_ = 0;
  PassHandle coverage_ = 0;
  ResidualPasses smooth_;
};

}  // namespace
}  // namespace reprise::amortized

namespace reprise {

extern const TechniqueEntry kAmortizedEntry;
const TechniqueEntry kAmortizedEntry = {
    &amortized::kInfo,
    []() -> std::unique_ptr<Technique> { return std::make_unique<amortized::Amortized>(); },
    amortized::kRungs};

}  // namespace reprise
