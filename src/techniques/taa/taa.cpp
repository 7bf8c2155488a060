// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "reprise/reprise.h"
// reprise.h first: shared headers are GLSL too and include no Vulkan header.
#include "core/context.h"
#include "core/sample_weights.h"
#include "equations/filters.h"
#include "techniques/taa/taa_settings.h"
#include "techniques/taa/taa_shared.h"

namespace reprise::taa {
namespace {

constexpr uint32_t kResolveShader[] = {
#include "resolve.comp.inc"
};
constexpr uint32_t kAverageShader[] = {
#include "average.comp.inc"
};
constexpr uint32_t kSharpenShader[] = {
#include "sharpen.comp.inc"
};

// Raw frames that average.comp binds beside the current one.
constexpr uint32_t kAverageHistory = 5;

float filterWeight(uint32_t filter, float width, float dx_px, float dy_px) {
  const float distance_px = std::sqrt(dx_px * dx_px + dy_px * dy_px);
  switch (filter) {
    case kInputBox:
      return eq::boxFilter(dx_px, 0.5f * width) * eq::boxFilter(dy_px, 0.5f * width);
    case kInputTent:
      return eq::tentFilter(dx_px, width) * eq::tentFilter(dy_px, width);
    case kInputMitchell:
      return eq::mitchellFilter(dx_px / width) * eq::mitchellFilter(dy_px / width);
    case kInputBlackmanHarris:
      return eq::blackmanHarrisFilter(distance_px / width);
    case kInputGaussian:
      return eq::gaussianFilter(distance_px, width);
    default:
      return 0.0f;
  }
}

// Weights of the nine samples for the value at the pixel centre (eq. 1).
void fillFilterWeights(const FrameState& state, TaaConstants& constants) {
  const uint32_t filter = state.settings.choice(kInputFilter);
  const float width = state.settings.real(kInputWidth);
  const std::array<float, 9> weights = sampleWeights(
      state.jitter_px,
      [=](float dx_px, float dy_px) { return filterWeight(filter, width, dx_px, dy_px); });
  constants.filter_weights_0_3 = eq::vec4(weights[0], weights[1], weights[2], weights[3]);
  constants.filter_weights_4_7 = eq::vec4(weights[4], weights[5], weights[6], weights[7]);
  constants.filter_weight_8 = weights[8];
}

TaaConstants taaConstants(const FrameState& state, VkExtent2D history_extent) {
  const Settings& s = state.settings;
  TaaConstants constants{};
  constants.frame = frameConstants(state, history_extent);
  fillFilterWeights(state, constants);
  constants.alpha = s.real(kAlpha);
  constants.gamma = std::max(s.real(kGamma), 1.0e-3f);
  constants.gamma_still = s.real(kGammaStill);
  constants.depth_tolerance = s.real(kDepthTolerance);
  constants.motion_tolerance_px = s.real(kMotionTolerance);
  constants.speed_alpha = s.real(kSpeedAlpha);
  constants.speed_px = s.real(kSpeedPx);
  constants.clip_forget = s.real(kClipForget);
  constants.still_frames = s.real(kStillFrames);
  constants.spatial_frames = s.real(kSpatialFrames);
  constants.history_sharpness = s.real(kHistorySharpness);
  constants.anti_flicker = s.real(kAntiFlickerStrength);
  constants.sharpen = s.real(kSharpen);
  constants.average_frames = s.real(kAverage);
  return constants;
}

class Taa final : public Technique {
 public:
  void plan(const PlanRequest& request, RepriseSamplePlan& plan) const override {
    planJitter(request.settings, request.frame_index, plan);
  }

  void declare(Declaration& declaration) override {
    const Settings& s = declaration.settings;
    sharpen_on_ = s.number(kSharpen) > 0.0;
    average_on_ = s.number(kAverage) >= 2.0;
    if (average_on_) {
      declareAverage(declaration);
    } else {
      declareResolve(declaration);
    }
    if (sharpen_on_) {
      sharpen_ =
          declaration.pass({.name = "sharpen",
                            .spirv = kSharpenShader,
                            .bindings = {Binding::kTexel, Binding::kStorage, Binding::kConstants},
                            .constant_bytes = sizeof(TaaConstants),
                            .specialization = {}});
    }
  }

  void record(Recorder& recorder, const FrameState& state) override {
    const TaaConstants constants =
        taaConstants(state, recorder.history(average_on_ ? raw_color_ : color_).extent());
    if (average_on_) {
      recordAverage(recorder, state, constants);
    } else {
      recordResolve(recorder, state, constants);
    }
    if (!sharpen_on_) return;
    const HistoryImage& resolved = recorder.history(average_on_ ? resolved_ : color_);
    recorder.pass(sharpen_)
        .read(resolved.current(state.record))
        .write(state.frame.output.view)
        .constants(constants)
        .dispatch(state.output_extent);
  }

 private:
  std::vector<uint32_t> specialization(const Settings& s) const {
    return {s.choice(kDilation),
            s.choice(kHistoryFilter),
            s.choice(kClip),
            s.choice(kClipToward),
            s.choice(kClipSpace),
            s.choice(kWeighting),
            s.choice(kAntiFlicker),
            s.choice(kDepthTest),
            s.number(kMotionTolerance) > 0.0 ? 1u : 0u,
            s.choice(kIdTest),
            s.choice(kReactive),
            s.choice(kRejectedBlur),
            s.number(kSpatialFrames) > 0.0 ? 1u : 0u,
            s.choice(kOffscreen),
            s.number(kStillFrames) > 0.0 ? 1u : 0u,
            s.choice(kDither),
            sharpen_on_ ? 0u : 1u,
            needsCorners(s) ? 1u : 0u};
  }

  // Whether anything reads the four diagonal neighbours: without, five fetches of colour suffice.
  static bool needsCorners(const Settings& s) {
    const uint32_t clip = s.choice(kClip);
    return (clip != kClipNone && clip != kClipCross) || s.choice(kInputFilter) != kInputNone ||
           s.on(kRejectedBlur) || s.number(kSpatialFrames) > 0.0;
  }

  void declareResolve(Declaration& d) {
    const Settings& s = d.settings;
    const VkExtent2D extent = d.max_output_extent;
    // Images of tests that are off shrink to one texel: their bindings must still hold something.
    const auto sized = [&](bool on) { return on ? extent : VkExtent2D{1, 1}; };
    color_ = d.history("history color", VK_FORMAT_R16G16B16A16_SFLOAT, extent, 2);
    depth_ = d.history("history depth", VK_FORMAT_R32_SFLOAT,
                       sized(s.choice(kDepthTest) != kDepthTestNone), 2);
    motion_ = d.history("history motion", VK_FORMAT_R32G32_SFLOAT,
                        sized(s.number(kMotionTolerance) > 0.0), 2);
    id_ = d.history("history id", VK_FORMAT_R32_UINT, sized(s.on(kIdTest)), 2);
    resolve_ = d.pass(
        {.name = "resolve",
         .spirv = kResolveShader,
         .bindings = {Binding::kTexel, Binding::kTexel, Binding::kTexel, Binding::kTexel,
                      Binding::kTexel, Binding::kLinear, Binding::kTexel, Binding::kTexel,
                      Binding::kTexel, Binding::kStorage, Binding::kStorage, Binding::kStorage,
                      Binding::kStorage, Binding::kStorage, Binding::kConstants},
         .constant_bytes = sizeof(TaaConstants),
         .specialization = specialization(s)});
  }

  void recordResolve(Recorder& recorder, const FrameState& state, const TaaConstants& constants) {
    const HistoryImage& color = recorder.history(color_);
    const HistoryImage& depth = recorder.history(depth_);
    const HistoryImage& motion = recorder.history(motion_);
    const HistoryImage& id = recorder.history(id_);
    const uint64_t n = state.record;
    recorder.pass(resolve_)
        .read(state.frame.color)
        .read(state.frame.depth)
        .read(state.frame.motion)
        .read(recorder.orFloatPlaceholder(state.frame.reactive))
        .read(recorder.orUintPlaceholder(state.frame.id))
        .read(color.previous(n))
        .read(depth.previous(n))
        .read(motion.previous(n))
        .read(id.previous(n))
        .write(color.current(n))
        .write(depth.current(n))
        .write(motion.current(n))
        .write(id.current(n))
        .write(state.frame.output.view)
        .constants(constants)
        .dispatch(state.output_extent);
  }

  void declareAverage(Declaration& d) {
    const VkExtent2D extent = d.max_output_extent;
    const auto frames = static_cast<uint32_t>(d.settings.number(kAverage));
    raw_color_ = d.history("raw color", VK_FORMAT_R16G16B16A16_SFLOAT, extent, frames);
    raw_surface_ = d.history("raw motion and depth", VK_FORMAT_R32G32_UINT, extent, frames);
    resolved_ = d.history("resolved color", VK_FORMAT_R16G16B16A16_SFLOAT,
                          sharpen_on_ ? extent : VkExtent2D{1, 1}, 1);
    resolve_ =
        d.pass({.name = "average",
                .spirv = kAverageShader,
                .bindings = {Binding::kTexel, Binding::kTexel, Binding::kTexel, Binding::kLinear,
                             Binding::kLinear, Binding::kLinear, Binding::kLinear, Binding::kLinear,
                             Binding::kTexel, Binding::kTexel, Binding::kTexel, Binding::kTexel,
                             Binding::kTexel, Binding::kStorage, Binding::kStorage,
                             Binding::kStorage, Binding::kStorage, Binding::kConstants},
                .constant_bytes = sizeof(TaaConstants),
                .specialization = specialization(d.settings)});
  }

  void recordAverage(Recorder& recorder, const FrameState& state, TaaConstants constants) {
    const HistoryImage& color = recorder.history(raw_color_);
    const HistoryImage& surface = recorder.history(raw_surface_);
    const uint64_t n = state.record;
    // Frames since the last reset bound how far back the ring holds this sequence.
    // Another extent breaks the chain too: raw frames are of their own size.
    const bool same_extent = state.previous_output_extent.width == state.output_extent.width &&
                             state.previous_output_extent.height == state.output_extent.height;
    since_reset_ = state.has_history && same_extent ? since_reset_ + 1 : 0;
    const auto held = static_cast<float>(std::min<uint64_t>(since_reset_ + 1, color.copies()));
    constants.average_frames = std::min(constants.average_frames, held);
    PassRecording pass = recorder.pass(resolve_);
    pass.read(state.frame.color).read(state.frame.depth).read(state.frame.motion);
    for (uint32_t age = 1; age <= kAverageHistory; ++age) {
      pass.read(color.previous(n, std::min(age, color.copies() - 1)));
    }
    for (uint32_t age = 1; age <= kAverageHistory; ++age) {
      pass.read(surface.previous(n, std::min(age, surface.copies() - 1)));
    }
    pass.write(color.current(n))
        .write(surface.current(n))
        .write(recorder.history(resolved_).current(0))
        .write(state.frame.output.view)
        .constants(constants)
        .dispatch(state.output_extent);
  }

  bool sharpen_on_ = false;
  bool average_on_ = false;
  uint64_t since_reset_ = 0;
  HistoryHandle color_ = 0;
  HistoryHandle depth_ = 0;
  HistoryHandle motion_ = 0;
  HistoryHandle id_ = 0;
  HistoryHandle raw_color_ = 0;
  HistoryHandle raw_surface_ = 0;
  HistoryHandle resolved_ = 0;
  PassHandle resolve_ = 0;
  PassHandle sharpen_ = 0;
};

const RepriseTechniqueInfo kInfo = {
    .name = "taa",
    .summary = "Temporal antialiasing with every choice a setting",
    .source = "Karis 2014; Salvi 2016; Yang, Liu, Salvi 2020; Lopez 2022",
    .flags = REPRISE_TECHNIQUE_USES_HISTORY | REPRISE_TECHNIQUE_USES_REACTIVE |
             REPRISE_TECHNIQUE_USES_ID,
    .settings = kSettings.data(),
    .setting_count = kSettingCount,
    .presets = kPresets,
    .preset_count = 1,
};

}  // namespace

std::unique_ptr<Technique> createTaa() {
  return std::make_unique<Taa>();
}

}  // namespace reprise::taa

namespace reprise {

extern const TechniqueEntry kTaaEntry;
const TechniqueEntry kTaaEntry = {&taa::kInfo,
                                  []() -> std::unique_ptr<Technique> { return taa::createTaa(); }};

}  // namespace reprise
