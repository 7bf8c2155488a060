// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "reprise/reprise.h"
// reprise.h first: shared headers are GLSL too and include no Vulkan header.
#include "core/centred_jitter.h"
#include "core/context.h"
#include "core/sample_weights.h"
#include "equations/filters.h"
#include "techniques/fxaa/fxaa_passes.h"
#include "techniques/phlm/phlm_settings.h"
#include "techniques/phlm/phlm_shared.h"

namespace reprise::phlm {
namespace {

constexpr uint32_t kFeatureShader[] = {
#include "phlm_feature.comp.inc"
};
constexpr uint32_t kFilterShader[] = {
#include "phlm_filter.comp.inc"
};
constexpr uint32_t kPackedShader[] = {
#include "phlm_filter_packed.comp.inc"
};

constexpr uint32_t kFloatImages = 7;   // that phlm_filter.comp binds
constexpr uint32_t kPackedImages = 2;  // that phlm_filter_packed.comp binds

// Static storage: memory reports hand the names to the host.
constexpr const char* kImageNames[kFloatImages] = {"model 0", "model 1", "model 2", "model 3",
                                                   "model 4", "model 5", "model 6"};

PhlmConstants phlmConstants(const FrameState& state, VkExtent2D history_extent) {
  const Settings& s = state.settings;
  PhlmConstants constants{};
  constants.frame = frameConstants(state, history_extent);
  const float width_px = s.real(kInputWidth);
  const std::array<float, 9> w = sampleWeights(state.jitter_px, [=](float dx_px, float dy_px) {
    if (!(width_px > 0.0f)) return 0.0f;
    return eq::gaussianFilter(std::sqrt(dx_px * dx_px + dy_px * dy_px), width_px);
  });
  constants.filter_weights_0_3 = eq::vec4(w[0], w[1], w[2], w[3]);
  constants.filter_weights_4_7 = eq::vec4(w[4], w[5], w[6], w[7]);
  constants.filter_weight_8 = eq::vec4(w[8], 0.0f, 0.0f, 0.0f);
  constants.lambda = s.real(kLambda);
  constants.level_variance = s.real(kInitialVariance);
  constants.spread_variance = s.real(kSlopeVariance);
  constants.clip_variance = s.real(kClipVariance);
  constants.variance_limit = s.real(kVarianceLimit);
  constants.still_variance = 1.0f / std::max(s.real(kStillFrames), 1.0f);
  constants.box_gamma = s.real(kBoxGamma);
  constants.box_still = s.real(kBoxStill);
  constants.feature_a = s.real(kFeatureA);
  constants.feature_b = s.real(kFeatureB);
  constants.feature_floor = s.real(kFeatureFloor);
  constants.depth_tolerance = s.real(kDepthTolerance);
  return constants;
}

// Half precision has no room for it.
bool aboutZero(const Settings& s) {
  const uint32_t storage = s.choice(kStorageForm);
  return s.choice(kModelOrigin) == 0 && (storage == kStoragePaper || storage == kStorageSymmetric);
}

class Phlm final : public Technique {
 public:
  void plan(const PlanRequest& request, RepriseSamplePlan& plan) const override {
    const Settings& s = request.settings;
    const uint32_t length = s.choice(kJitterLength);
    const uint32_t jitter = s.choice(kJitter);
    plan.period = jitter == kJitterNone ? 1 : length;
    if (jitter == kJitterNone || (jitter == kJitterStill && request.camera_moves)) return;
    planCentredJitter(eq::kSequenceR2, request.frame_index, length, plan);
  }

  void declare(Declaration& d) override {
    const Settings& s = d.settings;
    packed_ = s.choice(kStorageForm) == kStoragePacked;
    split_ = s.choice(kPasses) == 0;
    fxaa_on_ = s.choice(kInput) == 1;
    if (fxaa_on_) {
      antialiased_ =
          d.history("antialiased input", VK_FORMAT_R16G16B16A16_SFLOAT, d.max_input_extent, 1);
      fxaa_.declare(d, fxaa::kBlendLinear);
    }
    feature_ = d.history("temporal feature and depth", VK_FORMAT_R16G16B16A16_SFLOAT,
                         d.max_output_extent, 2);
    const bool hardware = declareModels(d);
    const std::vector<uint32_t> specialization = {s.choice(kStorageForm),
                                                  hardware ? 1u : 0u,
                                                  s.choice(kModelFilter),
                                                  s.choice(kClipModel),
                                                  s.choice(kBoxShape),
                                                  s.choice(kBoxSpace),
                                                  s.choice(kFeatureLowPass),
                                                  s.choice(kFeatureWeighs),
                                                  s.choice(kSpace),
                                                  s.choice(kDilate),
                                                  s.number(kStillFrames) > 0.0 ? 1u : 0u,
                                                  s.choice(kUpdateShare),
                                                  split_ ? 0u : 1u,
                                                  s.choice(kBoxHolds),
                                                  aboutZero(s) ? 1u : 0u,
                                                  s.choice(kForgetting)};
    if (split_) {
      feature_pass_ =
          d.pass({.name = "feature",
                  .spirv = kFeatureShader,
                  .bindings = {Binding::kTexel, Binding::kTexel, Binding::kTexel, Binding::kLinear,
                               Binding::kStorage, Binding::kConstants},
                  .constant_bytes = sizeof(PhlmConstants),
                  .specialization = specialization});
    }
    declareFilter(d, hardware, specialization);
  }

  void record(Recorder& recorder, const FrameState& state) override {
    const HistoryImage& feature = recorder.history(feature_);
    const uint64_t n = state.record;
    const PhlmConstants constants = phlmConstants(state, feature.extent());
    RepriseImage color = state.frame.color;
    if (fxaa_on_) {
      const HistoryImage& antialiased = recorder.history(antialiased_);
      fxaa_.record(recorder, state, {}, color, antialiased.current(0));
      color = {antialiased.current(0), antialiased.extent(), VK_IMAGE_LAYOUT_GENERAL};
    }
    if (split_) {
      recorder.pass(feature_pass_)
          .read(color)
          .read(state.frame.depth)
          .read(state.frame.motion)
          .read(feature.previous(n))
          .write(feature.current(n))
          .constants(constants)
          .dispatch(state.output_extent);
    }
    // The images that this form of storage has; the bindings beyond hold a texel that nobody reads.
    const auto model = [&](uint32_t i, bool write) {
      const HistoryImage& image = recorder.history(models_[std::min(i, model_count_ - 1)]);
      if (i < model_count_) return write ? image.current(n) : image.previous(n);
      return recorder.history(unused_).copy(write ? 1 : 0);
    };
    PassRecording pass = recorder.pass(filter_pass_);
    pass.read(color)
        .read(state.frame.depth)
        .read(state.frame.motion)
        .read(split_ ? feature.current(n) : recorder.history(unused_).copy(0))
        .read(feature.previous(n));
    const uint32_t bound = packed_ ? kPackedImages : kFloatImages;
    for (uint32_t i = 0; i < bound; ++i) pass.read(model(i, false));
    pass.write(split_ ? recorder.history(unused_).copy(1) : feature.current(n));
    for (uint32_t i = 0; i < bound; ++i) pass.write(model(i, true));
    pass.write(state.frame.output.view).constants(constants).dispatch(state.output_extent);
  }

 private:
  // Whether the sampler filters them.
  bool declareModels(Declaration& d) {
    const uint32_t storage = d.settings.choice(kStorageForm);
    const VkExtent2D extent = d.max_output_extent;
    model_count_ = storage == kStoragePaper ? kFloatImages : packed_ ? kPackedImages : 6;
    for (uint32_t i = 0; i < model_count_; ++i) {
      const bool pair = storage != kStoragePaper && i == 5;  // holds two numbers, not four
      VkFormat format = pair ? VK_FORMAT_R32G32_SFLOAT : VK_FORMAT_R32G32B32A32_SFLOAT;
      if (packed_) format = VK_FORMAT_R32G32B32A32_UINT;
      if (storage == kStorageHalf) {
        format = pair && d.storable(VK_FORMAT_R16G16_SFLOAT) ? VK_FORMAT_R16G16_SFLOAT
                                                             : VK_FORMAT_R16G16B16A16_SFLOAT;
      }
      models_[i] = d.history(kImageNames[i], format, extent, 2);
    }
    unused_ = d.history("unused binding", VK_FORMAT_R16G16B16A16_SFLOAT, {1, 1}, 2);
    if (packed_ || d.settings.choice(kBilinear) == 0) return false;
    return storage == kStorageHalf ||
           (d.storable(VK_FORMAT_R32G32B32A32_SFLOAT) && d.storable(VK_FORMAT_R32G32_SFLOAT));
  }

  void declareFilter(Declaration& d, bool hardware, const std::vector<uint32_t>& specialization) {
    std::vector<Binding> bindings(4, Binding::kTexel);
    bindings.push_back(Binding::kLinear);
    const uint32_t bound = packed_ ? kPackedImages : kFloatImages;
    bindings.insert(bindings.end(), bound, hardware ? Binding::kLinear : Binding::kTexel);
    bindings.insert(bindings.end(), bound + 2, Binding::kStorage);
    bindings.push_back(Binding::kConstants);
    PassInfo info{.name = "filter",
                  .spirv = kFilterShader,
                  .bindings = bindings,
                  .constant_bytes = sizeof(PhlmConstants),
                  .specialization = specialization};
    if (packed_) info.spirv = kPackedShader;
    filter_pass_ = d.pass(info);
  }

  bool packed_ = false;
  bool split_ = false;
  bool fxaa_on_ = false;
  fxaa::Passes fxaa_;
  HistoryHandle antialiased_ = 0;
  HistoryHandle feature_ = 0;
  HistoryHandle models_[kFloatImages] = {};
  uint32_t model_count_ = 0;
  HistoryHandle unused_ = 0;
  PassHandle feature_pass_ = 0;
  PassHandle filter_pass_ = 0;
};

const RepriseTechniqueInfo kInfo = {
    .name = "phlm",
    .summary = "Pixel history linear models: each pixel's past as a regression on a steady feature",
    .source = "Iglesias-Guitian et al. 2016",
    .flags = REPRISE_TECHNIQUE_USES_HISTORY,
    .settings = kSettings.data(),
    .setting_count = kSettingCount,
    .presets = kPresets,
    .preset_count = 2,
};

}  // namespace
}  // namespace reprise::phlm

namespace reprise {

extern const TechniqueEntry kPhlmEntry;
const TechniqueEntry kPhlmEntry = {
    &phlm::kInfo, []() -> std::unique_ptr<Technique> { return std::make_unique<phlm::Phlm>(); }};

}  // namespace reprise
