// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

#include "reprise/reprise.h"
// reprise.h first: shared headers are GLSL too and include no Vulkan header.
#include "core/context.h"
#include "equations/reprojection.h"
#include "techniques/amortized/amortized_settings.h"
#include "techniques/amortized/amortized_shared.h"
#include "techniques/amortized/blur_table.h"
#include "techniques/amortized/buffer_layout.h"

namespace reprise::amortized {
namespace {

constexpr uint32_t kResolveShader[] = {
#include "amortized_resolve.comp.inc"
};
constexpr uint32_t kResidualShader[] = {
#include "amortized_residual.comp.inc"
};
constexpr uint32_t kRequestShader[] = {
#include "amortized_request.comp.inc"
};

// A normal deviate for a whole frame, for samples=frame.
constexpr uint32_t kFrameJitterSeed = 0x9e3779b9u;
// A jitter farther out than this would leave the range of a plan.
constexpr float kFarthestJitter_px = 1.0f;

uint32_t floatBits(float value) {
  uint32_t bits;
  std::memcpy(&bits, &value, sizeof(bits));
  return bits;
}

uint32_t bufferOf(const Settings& settings, uint64_t frame_index) {
  const uint32_t count = bufferCount(settings);
  if (settings.choice(kOrder) == kOrderRoundRobin) {
    return static_cast<uint32_t>(frame_index % count);
  }
  return bufferOfFrame(count, frame_index);
}

// What is known of the frame that wrote a buffer.
struct WrittenFrame {
  uint64_t record;
  float pre_exposure;
  std::optional<RepriseCamera> camera;
};

class Amortized final : public Technique {
 public:
  void plan(const PlanRequest& request, RepriseSamplePlan& plan) const override {
    const BufferLayout layout = bufferLayout(bufferCount(request.settings));
    const uint32_t buffer = bufferOf(request.settings, request.frame_index);
    const uint32_t quadrant = layout.quadrants[buffer];
    if (request.settings.choice(kSamples) == kSamplesFrame) {
      const auto frame = static_cast<uint32_t>(request.frame_index);
      const eq::vec2 place =
          eq::shadingOffset(frame, 0, kFrameJitterSeed, layout.sigma_px, quadrant);
      plan.jitter_px[0] = std::clamp(-place.x, -kFarthestJitter_px, kFarthestJitter_px);
      plan.jitter_px[1] = std::clamp(-place.y, -kFarthestJitter_px, kFarthestJitter_px);
    } else {
      plan.shading_offset = REPRISE_SHADING_OFFSET_HASH_GAUSSIAN;
      plan.shading_offset_sigma_px = layout.sigma_px;
      plan.shading_offset_seed = static_cast<uint32_t>(request.frame_index);
      plan.shading_offset_quadrant = quadrant;
    }
    if (request.settings.choice(kMotion) == kMotionExact) fillAges(request, plan);
  }

  void declare(Declaration& declaration) override {
    const Settings& s = declaration.settings;
    const VkExtent2D extent = declaration.max_output_extent;
    count_ = bufferCount(s);
    layout_ = bufferLayout(count_);
    spare_ = count_;
    exact_ = s.choice(kMotion) == kMotionExact;
    residuals_ = s.number(kResidual) > 0.0;
    // One more than are read: a gather reads neighbours of the buffer that is written.
    buffers_ = declaration.history("subpixel buffers: color, view depth",
                                   VK_FORMAT_R16G16B16A16_SFLOAT, extent, count_ + 1);
    samples_ = declaration.history(
        "effective samples",
        declaration.storable(VK_FORMAT_R16_SFLOAT) ? VK_FORMAT_R16_SFLOAT : VK_FORMAT_R32_SFLOAT,
        extent, 2);
    if (!exact_) {
      motion_0_ =
          declaration.history("motion to buffers 0, 1", VK_FORMAT_R16G16B16A16_SFLOAT, extent, 2);
      if (count_ > 2) {
        motion_1_ =
            declaration.history("motion to buffers 2, 3", VK_FORMAT_R16G16B16A16_SFLOAT, extent, 2);
      }
    }
    if (residuals_) {
      residual_ = declaration.history("residuals", VK_FORMAT_R8G8B8A8_SNORM, extent, 2);
      const VkFormat one =
          declaration.storable(VK_FORMAT_R16_SFLOAT) ? VK_FORMAT_R16_SFLOAT : VK_FORMAT_R32_SFLOAT;
      row_means_ = declaration.history("residual row means", one, extent, 1);
      smoothed_ = declaration.history("smoothed residual", one, extent, 1);
    }
    const uint32_t silhouettes = s.choice(kSamples) == kSamplesFrame ? 1 : 0;
    std::vector<Binding> bindings(6, Binding::kTexel);
    bindings[2] = bindings[3] = Binding::kLinear;
    bindings.insert(bindings.end(), kMaxBuffers, Binding::kLinear);
    if (s.on(kRequests)) {
      std::vector<Binding> request_bindings = bindings;
      request_bindings.insert(request_bindings.end(), {Binding::kBuffer, Binding::kConstants});
      request_ = declaration.requestPass(
          {.name = "request",
           .spirv = kRequestShader,
           .bindings = request_bindings,
           .constant_bytes = sizeof(AmortizedConstants),
           .specialization = {count_, exact_ ? 1u : 0u, silhouettes, REPRISE_REQUEST_GROUP_SIZE}});
    }
    bindings.insert(bindings.end(),
                    {Binding::kTexel, Binding::kTexel, Binding::kLinear, Binding::kTexel,
                     Binding::kLinear, Binding::kStorage, Binding::kStorage, Binding::kStorage,
                     Binding::kStorage, Binding::kStorage, Binding::kStorage, Binding::kConstants});
    resolve_ = declaration.pass(
        {.name = "resolve",
         .spirv = kResolveShader,
         .bindings = bindings,
         .constant_bytes = sizeof(AmortizedConstants),
         .specialization = {count_, exact_ ? 1u : 0u, silhouettes, residuals_ ? 1u : 0u,
                            floatBits(layout_.tent_radius_px)}});
    if (residuals_) {
      for (uint32_t columns = 0; columns < 2; ++columns) {
        smooth_[columns] =
            declaration.pass({.name = columns == 0 ? "residual rows" : "residual columns",
                              .spirv = kResidualShader,
                              .bindings = {Binding::kTexel, Binding::kStorage, Binding::kConstants},
                              .constant_bytes = sizeof(ResidualConstants),
                              .specialization = {columns}});
      }
    }
  }

  void recordRequest(Recorder& recorder, const FrameState& state) override {
    forgetIfBroken(state);
    PassRecording pass = recorder.pass(request_);
    bindReprojection(pass, recorder, state);
    pass.buffer(recorder.requests()).constants(constantsOf(recorder, state, targetOf(state)));
    pass.dispatch(state.output_extent);
  }

  void record(Recorder& recorder, const FrameState& state) override {
    forgetIfBroken(state);
    const uint32_t target = targetOf(state);
    const HistoryImage& buffers = recorder.history(buffers_);
    const HistoryImage& samples = recorder.history(samples_);
    const RepriseImage none = recorder.orFloatPlaceholder({});
    PassRecording pass = recorder.pass(resolve_);
    bindReprojection(pass, recorder, state);
    pass.read(state.frame.color);
    pass.read(recorder.orFloatPlaceholder(state.frame.extra));
    pass.read(samples.previous(state.record));
    if (residuals_) {
      pass.read(recorder.history(residual_).previous(state.record));
      pass.read(recorder.history(smoothed_).current(0));
    } else {
      pass.read(none).read(none);
    }
    pass.write(buffers.copy(spare_));
    pass.write(samples.current(state.record));
    pass.write(exact_ ? none.view : recorder.history(motion_0_).current(state.record));
    pass.write(exact_ || count_ <= 2 ? none.view
                                     : recorder.history(motion_1_).current(state.record));
    pass.write(residuals_ ? recorder.history(residual_).current(state.record) : none.view);
    pass.write(state.frame.output.view);
    pass.constants(constantsOf(recorder, state, target));
    pass.dispatch(state.output_extent);

    if (residuals_) {
      const ResidualConstants constants{frameConstants(state, buffers.extent())};
      const VkImageView rows = recorder.history(row_means_).current(0);
      recorder.pass(smooth_[0])
          .read(recorder.history(residual_).current(state.record))
          .write(rows)
          .constants(constants)
          .dispatch(state.output_extent);
      recorder.pass(smooth_[1])
          .read(rows)
          .write(recorder.history(smoothed_).current(0))
          .constants(constants)
          .dispatch(state.output_extent);
    }

    std::swap(copy_of_[target], spare_);
    WrittenFrame frame{state.record, state.frame.pre_exposure, std::nullopt};
    if (state.frame.camera != nullptr) frame.camera = *state.frame.camera;
    written_[target] = frame;
    writes_.insert(writes_.begin(), target);
    writes_.resize(std::min<size_t>(writes_.size(), kPeriod));
    extent_ = state.output_extent;
    next_record_ = state.record + 1;
  }

 private:
  static void fillAges(const PlanRequest& request, RepriseSamplePlan& plan) {
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

  // Buffers hold nothing after a reset, in another extent, or when this object did not see the
  // record before (a new prepare).
  void forgetIfBroken(const FrameState& state) {
    const bool same_extent =
        state.output_extent.width == extent_.width && state.output_extent.height == extent_.height;
    if (state.has_history && same_extent && next_record_ == state.record) return;
    for (std::optional<WrittenFrame>& frame : written_) frame.reset();
    writes_.clear();
    next_record_ = state.record;
    extent_ = state.output_extent;
  }

  // The plan's buffer; for frames that were sampled otherwise, the one whose quadrant the frame's
  // own jitter lies in.
  uint32_t targetOf(const FrameState& state) const {
    const uint32_t planned = bufferOf(state.settings, state.frame.frame_index);
    if (count_ == 1) return 0;
    const eq::vec2 sample_px = eq::vec2(-state.jitter_px.x, -state.jitter_px.y);
    const bool shading = state.settings.choice(kSamples) == kSamplesShading;
    if (shading && sample_px.x == 0.0f && sample_px.y == 0.0f) return planned;
    // A Gaussian about the quadrant's centre may reach the next quadrant: the plan's own frames
    // stay with the plan.
    RepriseSamplePlan plan{};
    this->plan({state.frame.frame_index, state.input_extent, state.output_extent, state.settings},
               plan);
    if (plan.jitter_px[0] == state.jitter_px.x && plan.jitter_px[1] == state.jitter_px.y) {
      return planned;
    }
    if (count_ == 2) return sample_px.x + sample_px.y > 0.0f ? 1 : 0;
    return (sample_px.x > 0.0f ? 2u : 0u) + (sample_px.y > 0.0f ? 1u : 0u);
  }

  uint32_t ageOf(const FrameState& state, uint32_t buffer) const {
    return static_cast<uint32_t>(
        std::min<uint64_t>(state.record - written_[buffer]->record, 1u << 20));
  }

  void bindReprojection(PassRecording& pass, Recorder& recorder, const FrameState& state) const {
    const RepriseImage none = recorder.orFloatPlaceholder({});
    pass.read(state.frame.depth).read(state.frame.motion);
    if (exact_) {
      for (uint32_t k = 0; k < kMaxBuffers; ++k) pass.read(motionBack(state, k, none));
    } else {
      pass.read(recorder.history(motion_0_).previous(state.record));
      if (count_ > 2) {
        pass.read(recorder.history(motion_1_).previous(state.record));
      } else {
        pass.read(none);
      }
      pass.read(none).read(none);
    }
    const HistoryImage& buffers = recorder.history(buffers_);
    for (uint32_t k = 0; k < kMaxBuffers; ++k) {
      pass.read(buffers.copy(copy_of_[k < count_ ? k : 0]));
    }
  }

  const RepriseImage& motionBack(const FrameState& state, uint32_t buffer,
                                 const RepriseImage& none) const {
    if (!hasMotionTo(state, buffer)) return none;
    return state.frame.motion_back[ageOf(state, buffer) - 1];
  }

  bool hasMotionTo(const FrameState& state, uint32_t buffer) const {
    if (buffer >= count_ || !written_[buffer].has_value()) return false;
    if (!exact_) return true;
    const uint32_t age = ageOf(state, buffer);
    return age >= 1 && age <= state.frame.motion_back_count &&
           state.frame.motion_back[age - 1].view != VK_NULL_HANDLE;
  }

  AmortizedConstants constantsOf(const Recorder& recorder, const FrameState& state,
                                 uint32_t target) {
    const Settings& s = state.settings;
    AmortizedConstants constants{};
    constants.frame = frameConstants(state, recorder.history(buffers_).extent());
    float ratios[kMaxBuffers] = {1.0f, 1.0f, 1.0f, 1.0f};
    for (uint32_t k = 0; k < count_; ++k) {
      const eq::vec2 place = eq::quadrantOffset(layout_.quadrants[k]);
      const bool usable = hasMotionTo(state, k);
      const float age = usable ? static_cast<float>(ageOf(state, k)) : 1.0f;
      constants.buffers[k].place_age = eq::vec4(place.x, place.y, age, usable ? 1.0f : 0.0f);
      constants.buffers[k].depth_coefficients = eq::vec4(0.0f, 0.0f, 1.0f, 0.0f);
      if (!usable) continue;
      ratios[k] = state.frame.pre_exposure / written_[k]->pre_exposure;
      if (state.frame.camera != nullptr && written_[k]->camera.has_value()) {
        constants.buffers[k].depth_coefficients = eq::previousDepthCoefficients(
            state.frame.camera->view, state.frame.camera->projection, written_[k]->camera->view,
            static_cast<float>(state.input_extent.width),
            static_cast<float>(state.input_extent.height));
      }
    }
    constants.exposure_ratios = eq::vec4(ratios[0], ratios[1], ratios[2], ratios[3]);
    float writes = 0.0f;
    for (uint32_t n = 0; n < kPeriod; ++n) {
      constants.writes[n / 4][static_cast<int>(n % 4)] = writes;
      if (n < writes_.size() && writes_[n] == target) writes += 1.0f;
    }
    const eq::vec2 place = eq::quadrantOffset(layout_.quadrants[target]);
    constants.target_px = eq::vec4(place.x, place.y, 0.0f, 0.0f);
    constants.writes_a_period = static_cast<float>(kPeriod / count_);
    constants.max_samples = s.real(kMaxSamples);
    constants.depth_tolerance = s.real(kDepthTolerance);
    constants.residual_tolerance = s.real(kResidual);
    constants.fixed_alpha = s.real(kFixedAlpha);
    constants.extra_given = state.frame.extra.view != VK_NULL_HANDLE ? 1.0f : 0.0f;
    constants.blur_scale = 1.0f;
    if (slice_threshold_ != s.number(kBlur) || !slice_.has_value()) {
      slice_threshold_ = s.number(kBlur);
      slice_ = blurSlice(count_, slice_threshold_);
    }
    static_assert(sizeof(constants.blur_slice) == sizeof(BlurSlice));
    std::memcpy(constants.blur_slice, slice_->data(), slice_->size());
    return constants;
  }

  uint32_t count_ = kMaxBuffers;
  BufferLayout layout_ = bufferLayout(kMaxBuffers);
  bool exact_ = false;
  bool residuals_ = false;
  HistoryHandle buffers_ = 0;
  HistoryHandle samples_ = 0;
  HistoryHandle motion_0_ = 0;
  HistoryHandle motion_1_ = 0;
  HistoryHandle residual_ = 0;
  HistoryHandle row_means_ = 0;
  HistoryHandle smoothed_ = 0;
  PassHandle request_ = 0;
  PassHandle resolve_ = 0;
  PassHandle smooth_[2] = {};

  // Which copy of the image holds which buffer, and the copy to be written next.
  std::array<uint32_t, kMaxBuffers> copy_of_ = {0, 1, 2, 3};
  uint32_t spare_ = kMaxBuffers;
  std::array<std::optional<WrittenFrame>, kMaxBuffers> written_;
  std::vector<uint32_t> writes_;  // buffers written, the latest first, one period
  uint64_t next_record_ = ~uint64_t{0};
  VkExtent2D extent_{};
  double slice_threshold_ = -1.0;
  std::optional<BlurSlice> slice_;
};

}  // namespace
}  // namespace reprise::amortized

namespace reprise {

extern const TechniqueEntry kAmortizedEntry;
const TechniqueEntry kAmortizedEntry = {&amortized::kInfo, []() -> std::unique_ptr<Technique> {
                                          return std::make_unique<amortized::Amortized>();
                                        }};

}  // namespace reprise
