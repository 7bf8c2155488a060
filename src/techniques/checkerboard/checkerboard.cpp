// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "reprise/reprise.h"
// reprise.h first: shared headers are GLSL too and include no Vulkan header.
#include "core/centred_jitter.h"
#include "core/context.h"
#include "equations/checkerboard.h"
#include "equations/filters.h"
#include "equations/jitter.h"
#include "techniques/checkerboard/checkerboard_shared.h"

namespace reprise::checkerboard {
namespace {

constexpr uint32_t kResolveShader[] = {
#include "checkerboard.comp.inc"
};

// Derivatives are those of half the resolution (Intel 2018; Xiao et al. 2018, section 4).
constexpr float kMipBias = -1.0f;

enum Setting : uint32_t {
  kHalves,
  kJitterLength,
  kAlpha,
  kSampleSigma,
  kClip,
  kGamma,
  kSpatial,
  kDepthTolerance,
  kHistorySharpness,
  kHistoryClamp,
  kStillFrames,
  kGammaStill,
  kSettingCount
};

constexpr uint32_t kHalvesPaired = 0;
constexpr const char* kHalvesNames[] = {"paired", "alternate", nullptr};
constexpr const char* kSpatialNames[] = {"mean", "differential", nullptr};

constexpr auto kSettings = settingTable({
    choiceSetting(kHalves, "halves", 0, kHalvesNames,
                  "order of the halves: 1 2 2 1, or 1 2 1 2, which locks to content that moves by "
                  "odd numbers of pixels",
                  "ours; El Mansouri 2016 (alternate); experiment: README.md", 0),
    integerSetting(
        kJitterLength, "jitter_length", 15, 1, 127, "frames",
        "length of the jitter; an even one is made odd, so that each half gets all of it",
        "MiniEngine's checkerboard: 7; experiment: README.md"),
    numberSetting(kAlpha, "alpha", 0.2, 0.001, 1.0, "",
                  "lowest mean weight of a new sample in motion", "experiment: README.md"),
    numberSetting(kSampleSigma, "sample_sigma", 0.5, 0.1, 4.0, "px",
                  "deviation of the filter that weighs a sample by its distance; narrower is "
                  "sharper and takes less from neighbours",
                  "as cpst; experiment: README.md"),
    switchSetting(kClip, "clip", true, "bounds history by the variance of the shaded half",
                  "Xiao et al. 2018: all their methods; Salvi 2016"),
    numberSetting(kGamma, "gamma", 1.5, 0.0, 8.0, "standard deviations",
                  "half-size of the bound; wider flickers less and ghosts more",
                  "Salvi 2016; experiment: README.md"),
    choiceSetting(kSpatial, "spatial", 0, kSpatialNames,
                  "what fills a pixel that was not shaded: the mean of its neighbours, or more of "
                  "the pair that agrees",
                  "Jimenez 2016, Wihlidal 2017; experiment: README.md"),
    numberSetting(kDepthTolerance, "depth_tolerance", 0.02, 0.0, 1.0, "relative",
                  "how much farther than the tap the current surface may be", "as taa"),
    numberSetting(kHistorySharpness, "history_sharpness", 0.6, 0.0, 1.0, "",
                  "c of the cubic history filter of 5 fetches", "as taa"),
    switchSetting(kHistoryClamp, "history_clamp", true,
                  "keeps that filter within the four texels around", "as cpst"),
    integerSetting(kStillFrames, "still_frames", 512, 1, 2048, "samples",
                   "where nothing moves the mean goes on to this many samples", "as taa"),
    numberSetting(kGammaStill, "gamma_still", 8.0, 0.0, 16.0, "standard deviations",
                  "half-size of the bound where nothing moves", "as taa"),
});
static_assert(kSettings.size() == kSettingCount);

uint32_t oddLength(const Settings& settings) {
  return settings.choice(kJitterLength) | 1u;
}

uint32_t halfOf(const Settings& settings, uint64_t frame) {
  if (settings.choice(kHalves) == kHalvesPaired) {
    return eq::pairedHalf(static_cast<uint32_t>(frame % 4));
  }
  return 1 + static_cast<uint32_t>(frame % 2);
}

// Mean weight of a sample: of the shaded half, and of the nearest neighbour's where there is none.
float meanWeight(const Settings& settings) {
  const float sigma_px = settings.real(kSampleSigma);
  const uint32_t length = oddLength(settings);
  double sum = 0.0;
  for (uint32_t i = 0; i < length; ++i) {
    RepriseSamplePlan plan{};
    planCentredJitter(eq::kSequenceHalton, i, length, plan);
    const float x = std::abs(plan.jitter_px[0]);
    const float y = std::abs(plan.jitter_px[1]);
    const float nearest = std::min(std::hypot(1.0f - x, y), std::hypot(x, 1.0f - y));
    sum += eq::gaussianFilter(std::hypot(x, y), sigma_px) + eq::gaussianFilter(nearest, sigma_px);
  }
  return static_cast<float>(sum / (2.0 * length));
}

class Checkerboard final : public Technique {
 public:
  void plan(const PlanRequest& request, RepriseSamplePlan& plan) const override {
    const uint32_t length = oddLength(request.settings);
    planCentredJitter(eq::kSequenceHalton, request.frame_index, length, plan);
    plan.mip_bias = kMipBias;
    plan.checkerboard = halfOf(request.settings, request.frame_index);
    plan.period = length * (request.settings.choice(kHalves) == kHalvesPaired ? 4 : 2);
    // A frame of one pixel has no other half.
    if (request.input_extent.width == 1 && request.input_extent.height == 1) {
      plan.checkerboard = 0;
      plan.mip_bias = 0.0f;
    }
  }

  void declare(Declaration& d) override {
    const Settings& s = d.settings;
    const VkExtent2D extent = d.max_output_extent;
    color_ = d.history("history color", VK_FORMAT_R16G16B16A16_SFLOAT, extent, 2);
    depth_ = d.history("history depth", VK_FORMAT_R32_SFLOAT, extent, 2);
    resolve_ = d.pass({.name = "resolve",
                       .spirv = kResolveShader,
                       .bindings = {Binding::kTexel, Binding::kTexel, Binding::kTexel,
                                    Binding::kLinear, Binding::kTexel, Binding::kStorage,
                                    Binding::kStorage, Binding::kStorage, Binding::kConstants},
                       .constant_bytes = sizeof(CheckerboardConstants),
                       .specialization = {s.on(kClip) ? 1u : 0u, s.choice(kSpatial),
                                          s.on(kHistoryClamp) ? 1u : 0u}});
  }

  void record(Recorder& recorder, const FrameState& state) override {
    const HistoryImage& color = recorder.history(color_);
    const HistoryImage& depth = recorder.history(depth_);
    const uint64_t n = state.record;
    recorder.pass(resolve_)
        .read(state.frame.color)
        .read(state.frame.depth)
        .read(state.frame.motion)
        .read(color.previous(n))
        .read(depth.previous(n))
        .write(color.current(n))
        .write(depth.current(n))
        .write(state.frame.output.view)
        .constants(constantsOf(state, color.extent()))
        .dispatch(state.output_extent);
  }

 private:
  static CheckerboardConstants constantsOf(const FrameState& state, VkExtent2D history_extent) {
    const Settings& s = state.settings;
    const float mean_weight = meanWeight(s);
    CheckerboardConstants constants{};
    constants.frame = frameConstants(state, history_extent);
    constants.half_shaded = static_cast<float>(state.frame.checkerboard);
    constants.sigma_px = s.real(kSampleSigma);
    constants.held_limit = (1.0f / s.real(kAlpha) - 1.0f) * mean_weight;
    constants.held_limit_still = std::max(s.real(kStillFrames) - 1.0f, 0.0f) * mean_weight;
    constants.gamma = s.real(kGamma);
    constants.gamma_still = s.real(kGammaStill);
    constants.depth_tolerance = s.real(kDepthTolerance);
    constants.history_sharpness = s.real(kHistorySharpness);
    return constants;
  }

  HistoryHandle color_ = 0;
  HistoryHandle depth_ = 0;
  PassHandle resolve_ = 0;
};

constexpr RepriseTechniqueInfo kInfo = {
    .name = "checkerboard",
    .summary = "Checkerboard rendering: every other pixel of a frame, resolved over time",
    .source = "El Mansouri 2016, Wihlidal 2017, de Carpentier 2017; the peer of cpst",
    .flags = REPRISE_TECHNIQUE_USES_HISTORY,
    .settings = kSettings.data(),
    .setting_count = kSettingCount,
    .presets = nullptr,
    .preset_count = 0,
};

}  // namespace
}  // namespace reprise::checkerboard

namespace reprise {

extern const TechniqueEntry kCheckerboardEntry;
const TechniqueEntry kCheckerboardEntry = {
    &checkerboard::kInfo,
    []() -> std::unique_ptr<Technique> { return std::make_unique<checkerboard::Checkerboard>(); }};

}  // namespace reprise
