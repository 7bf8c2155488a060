// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "reprise/reprise.h"
// reprise.h first: shared headers are GLSL too and include no Vulkan header.
#include "core/context.h"
#include "equations/coarse.h"
#include "equations/coarse_jitter.h"
#include "equations/filters.h"
#include "equations/jitter.h"
#include "techniques/cpst/cpst_shared.h"

namespace reprise::cpst {
namespace {

constexpr uint32_t kMomentsShader[] = {
#include "cpst_moments.comp.inc"
};
constexpr uint32_t kChangeShader[] = {
#include "cpst_change.comp.inc"
};
constexpr uint32_t kSilhouettesShader[] = {
#include "cpst_silhouettes.comp.inc"
};
constexpr uint32_t kResolveShader[] = {
#include "cpst_resolve.comp.inc"
};

constexpr uint32_t kCoarseSize = 2;
// Derivatives span coarse pixels (section 4 of the paper).
constexpr float kMipBias = -1.0f;

enum Setting : uint32_t {
  kJitter,
  kJitterLength,
  kShadeAt,
  kAlpha,
  kShadingFilter,
  kShadingSigma,
  kVariance,
  kClipAbout,
  kGamma,
  kSilhouette,
  kDisocclusion,
  kDepthTolerance,
  kUncoverMotion,
  kReconstruct,
  kHistorySharpness,
  kHistoryClamp,
  kStillFrames,
  kGammaStill,
  kChange,
  kChangeErrors,
  kSettingCount
};

constexpr uint32_t kJitterBlueNoise = 0;
constexpr uint32_t kJitterHalton = 1;
constexpr const char* kJitterNames[] = {"void-and-cluster", "halton", "halton-2x", nullptr};
constexpr uint32_t kShadeAtCovered = 1;
constexpr const char* kShadeAtNames[] = {"centre", "covered", nullptr};
constexpr const char* kVarianceNames[] = {"none", "fine", "coarse", "dynamic", nullptr};
constexpr const char* kAboutNames[] = {"own", "mean", nullptr};
constexpr const char* kReconstructNames[] = {"none", "fresh", "always", nullptr};
constexpr const char* kDisocclusionNames[] = {"none", "scale", "taps", nullptr};

constexpr auto kSettings = settingTable({
    choiceSetting(kJitter, "jitter", 2, kJitterNames,
                  "where a frame's coarse pixels shade: spread for shading and visibility at once, "
                  "Halton(2,3) over a pixel, or over two pixels",
                  "Xiao et al. 2018, section 3.1 and figure 2; experiment: README.md", 0),
    integerSetting(kJitterLength, "jitter_length", 32, 1, 128, "frames",
                   "length of the cycle; longer ones converge further at rest",
                   "experiment: README.md; the paper gives none"),
    choiceSetting(kShadeAt, "shade_at", kShadeAtCovered, kShadeAtNames,
                  "where a surface that covers a part of a coarse pixel is shaded: at the centre, "
                  "or amid the pixels that it covers",
                  "Xiao et al. 2018 (centre); ours, named as future work there; experiment: "
                  "README.md"),
    numberSetting(kAlpha, "alpha", 0.2, 0.001, 1.0, "",
                  "lowest mean weight of a new sample in motion",
                  "Xiao et al. 2018: 0.1; experiment: README.md"),
    switchSetting(kShadingFilter, "shading_filter", true,
                  "weighs a sample by its distance from the pixel's centre",
                  "Xiao et al. 2018, equation (3), figure 6"),
    numberSetting(kShadingSigma, "shading_sigma", 0.7, 0.1, 4.0, "px",
                  "standard deviation of that filter; narrower is sharper and keeps fewer samples",
                  "Xiao et al. 2018: 0.7"),
    choiceSetting(kVariance, "variance", 3, kVarianceNames,
                  "scale of the moments that bound history: none, 3x3 pixels, LoD 2, or LoD 2 with "
                  "3x3 at silhouettes and disocclusions",
                  "Xiao et al. 2018, section 3.2, figure 5"),
    choiceSetting(kClipAbout, "clip_about", 1, kAboutNames,
                  "middle of the bound: the pixel's own sample, or the mean",
                  "Xiao et al. 2018 (own); Salvi 2016 (mean)"),
    numberSetting(kGamma, "gamma", 2.5, 0.0, 8.0, "standard deviations",
                  "half-size of the bound; wider flickers less and ghosts more",
                  "Xiao et al. 2018: n, not given; experiment: README.md"),
    numberSetting(kSilhouette, "silhouette", 0.3, 0.0, 2.0, "share of the longest motion",
                  "difference of motion that makes a silhouette", "Xiao et al. 2018: 30 %"),
    choiceSetting(kDisocclusion, "disocclusion", 2, kDisocclusionNames,
                  "history of nearer surfaces: kept, bounded by the fine moments where the nearest "
                  "of 3x3 lies behind the farthest of four taps, or rejected tap by tap",
                  "Xiao et al. 2018, section 4 (scale); taa (taps)"),
    numberSetting(kDepthTolerance, "depth_tolerance", 0.02, 0.0, 1.0, "relative",
                  "how much farther than the tap the current surface may be", "as taa"),
    numberSetting(
        kUncoverMotion, "uncover_motion", 0.5, 0.0, 64.0, "px",
        "taps: history of something nearer is left out where that is gone or moves by this "
        "much against the surface; 0: wherever it was nearer",
        "ours; experiment: README.md"),
    choiceSetting(kReconstruct, "reconstruct", 1, kReconstructNames,
                  "mixes the samples of one surface around a pixel by their distance: nowhere, "
                  "where history is missing, or everywhere",
                  "ours; named as future work by Xiao et al. 2018"),
    numberSetting(kHistorySharpness, "history_sharpness", 0.6, 0.0, 1.0, "",
                  "c of the cubic history filter of 5 fetches", "as taa"),
    switchSetting(kHistoryClamp, "history_clamp", true,
                  "keeps that filter within the four texels around: no fringes round lamps",
                  "ours; experiment: README.md"),
    integerSetting(kStillFrames, "still_frames", 512, 1, 2048, "samples",
                   "where nothing moves the mean goes on to this many samples", "as taa"),
    numberSetting(kGammaStill, "gamma_still", 8.0, 0.0, 16.0, "standard deviations",
                  "half-size of the bound where nothing moves", "as taa"),
    switchSetting(
        kChange, "change", true,
        "follows shading that changes: where means at LoD 2 are off history's, history is "
        "scaled to them and weighs less",
        "ours, for the paper's figure 7; experiment: README.md"),
    numberSetting(
        kChangeErrors, "change_errors", 1.25, 0.0, 16.0, "standard errors",
        "difference of means from which on shading is held to have changed; lower follows "
        "faster and takes more noise for change",
        "experiment: README.md"),
});
static_assert(kSettings.size() == kSettingCount);

// The paper gives no n for the bound. About the pixel's own sample, which is a deviation off
// itself, n = 1 cuts a right history as often as not: 3 dB less on brick/pan (README.md).
constexpr RepriseSettingValue kPaper[] = {
    {"jitter", 0.0, "void-and-cluster"},
    {"shade_at", 0.0, "centre"},
    {"alpha", 0.1, nullptr},
    {"clip_about", 0.0, "own"},
    {"gamma", 3.0, nullptr},
    {"disocclusion", 0.0, "scale"},
    {"depth_tolerance", 0.0, nullptr},
    {"reconstruct", 0.0, "none"},
    {"history_clamp", 0.0, "false"},
    {"change", 0.0, "false"},
};
constexpr ReprisePresetInfo kPresets[] = {
    {"paper", kPaper, static_cast<uint32_t>(std::size(kPaper)), "as Xiao et al. 2018 tell it"},
};

eq::vec2 shadingPosition(const Settings& settings, uint64_t frame) {
  const uint32_t length = settings.choice(kJitterLength);
  const auto index = static_cast<uint32_t>(frame % length);
  if (settings.choice(kJitter) == kJitterBlueNoise) return eq::coarseBlueNoise(length)[index];
  const float scale = settings.choice(kJitter) == kJitterHalton ? 1.0f : 2.0f;
  eq::vec2 mean;
  for (uint32_t i = 0; i < length; ++i) mean = mean + eq::haltonOffset(i);
  const eq::vec2 offset = eq::haltonOffset(index) - mean / static_cast<float>(length);
  // Centred; the torus takes what the mean's correction pushes out.
  const auto wrapped = [&](float v) { return std::fmod(1.0f + scale * v + 2.0f, 2.0f); };
  return {wrapped(offset.x), wrapped(offset.y)};
}

// Mean of the shading filter over a cycle and the four pixels of a coarse pixel.
float meanWeight(const Settings& settings) {
  if (!settings.on(kShadingFilter)) return 1.0f;
  const uint32_t length = settings.choice(kJitterLength);
  const float sigma_px = settings.real(kShadingSigma);
  double sum = 0.0;
  for (uint32_t i = 0; i < length; ++i) {
    const eq::CoarseOffset split = eq::splitOffset(shadingPosition(settings, i));
    for (int px = 0; px < 4; ++px) {
      const float x = eq::coarseCentre(px % 2, 2, split.origin_px[0]) - split.jitter_px.x -
                      static_cast<float>(px % 2) - 0.5f;
      const float y = eq::coarseCentre(px / 2, 2, split.origin_px[1]) - split.jitter_px.y -
                      static_cast<float>(px / 2) - 0.5f;
      sum += eq::gaussianFilter(std::hypot(x, y), sigma_px);
    }
  }
  return static_cast<float>(sum / (4.0 * length));
}

VkExtent2D momentTexels(VkExtent2D extent_px) {
  return {(extent_px.width + kMomentSize - 1) / kMomentSize,
          (extent_px.height + kMomentSize - 1) / kMomentSize};
}

// Two by two to 4 x 4 pixels (cpst_shared.h).
VkExtent2D toldTexels(VkExtent2D extent_px) {
  return {(extent_px.width + 3) / 4 * 2, (extent_px.height + 3) / 4 * 2};
}
// Each tells two texels, one below the other.
VkExtent2D silhouetteInvocations(VkExtent2D extent_px) {
  return {(extent_px.width + 3) / 4 * 2, (extent_px.height + 7) / 8 * 2};
}

class Cpst final : public Technique {
 public:
  void plan(const PlanRequest& request, RepriseSamplePlan& plan) const override {
    const eq::CoarseOffset split =
        eq::splitOffset(shadingPosition(request.settings, request.frame_index));
    plan.jitter_px[0] = split.jitter_px.x;
    plan.jitter_px[1] = split.jitter_px.y;
    plan.coarse_size = kCoarseSize;
    plan.coarse_origin_px[0] = split.origin_px[0];
    plan.coarse_origin_px[1] = split.origin_px[1];
    plan.coarse_covered = request.settings.choice(kShadeAt) == kShadeAtCovered ? 1 : 0;
    plan.mip_bias = kMipBias;
    plan.period = request.settings.choice(kJitterLength);
  }

  void declare(Declaration& d) override {
    const Settings& s = d.settings;
    const VkExtent2D extent = d.max_output_extent;
    coarse_moments_ = s.choice(kVariance) >= kVarianceCoarse;
    change_wanted_ = s.on(kChange);
    const VkExtent2D none = {1, 1};
    const bool wide = coarse_moments_ || change_wanted_;
    const VkExtent2D tiles = wide ? momentTexels(extent) : none;
    color_ = d.history("history color", VK_FORMAT_R16G16B16A16_SFLOAT, extent, 2);
    depth_ = d.history("history depth", VK_FORMAT_R32_SFLOAT, extent, 2);
    moment_texels_ = d.history("moments", VK_FORMAT_R32G32B32A32_UINT, tiles, 1);
    told_wanted_ =
        s.choice(kVariance) == kVarianceDynamic || s.choice(kDisocclusion) == kDisocclusionTaps;
    told_texels_ = d.history("silhouettes", VK_FORMAT_R32G32_UINT,
                             told_wanted_ ? toldTexels(extent) : none, 1);
    change_texels_ =
        d.history("change", VK_FORMAT_R32G32B32A32_UINT, change_wanted_ ? tiles : none, 1);
    if (wide) {
      moments_ = d.pass({.name = "moments",
                         .spirv = kMomentsShader,
                         .bindings = {Binding::kTexel, Binding::kTexel, Binding::kLinear,
                                      Binding::kStorage, Binding::kConstants},
                         .constant_bytes = sizeof(CpstConstants),
                         .specialization = {change_wanted_ ? 1u : 0u}});
    }
    if (change_wanted_) {
      change_ = d.pass({.name = "change",
                        .spirv = kChangeShader,
                        .bindings = {Binding::kTexel, Binding::kStorage, Binding::kConstants},
                        .constant_bytes = sizeof(CpstConstants),
                        .specialization = {}});
    }
    if (told_wanted_) {
      silhouettes_ = d.pass(
          {.name = "silhouettes",
           .spirv = kSilhouettesShader,
           .bindings = {Binding::kTexel, Binding::kTexel, Binding::kStorage, Binding::kConstants},
           .constant_bytes = sizeof(CpstConstants),
           .specialization = {}});
    }
    resolve_ = d.pass(
        {.name = "resolve",
         .spirv = kResolveShader,
         .bindings = {Binding::kTexel, Binding::kTexel, Binding::kTexel, Binding::kTexel,
                      Binding::kTexel, Binding::kLinear, Binding::kTexel, Binding::kStorage,
                      Binding::kStorage, Binding::kStorage, Binding::kConstants},
         .constant_bytes = sizeof(CpstConstants),
         .specialization = {s.choice(kVariance), s.choice(kClipAbout), s.choice(kDisocclusion),
                            s.choice(kShadingFilter), s.choice(kReconstruct),
                            s.on(kHistoryClamp) ? 1u : 0u, change_wanted_ ? 1u : 0u}});
    mean_weight_ = 0.0f;
  }

  void record(Recorder& recorder, const FrameState& state) override {
    const HistoryImage& color = recorder.history(color_);
    const HistoryImage& depth = recorder.history(depth_);
    const HistoryImage& moment_texels = recorder.history(moment_texels_);
    const HistoryImage& told = recorder.history(told_texels_);
    const HistoryImage& change = recorder.history(change_texels_);
    const CpstConstants constants = constantsOf(state, color.extent());
    const uint64_t n = state.record;
    const VkExtent2D texels = momentTexels(state.output_extent);
    if (coarse_moments_ || change_wanted_) {
      recorder.pass(moments_)
          .read(state.frame.color)
          .read(state.frame.motion)
          .read(color.previous(n))
          .write(moment_texels.current(0))
          .constants(constants)
          .dispatch(texels);
    }
    if (change_wanted_) {
      recorder.pass(change_)
          .read(moment_texels.current(0))
          .write(change.current(0))
          .constants(constants)
          .dispatch(texels);
    }
    if (told_wanted_) {
      recorder.pass(silhouettes_)
          .read(state.frame.depth)
          .read(state.frame.motion)
          .write(told.current(0))
          .constants(constants)
          .dispatch(silhouetteInvocations(state.output_extent));
    }
    recorder.pass(resolve_)
        .read(state.frame.color)
        .read(state.frame.depth)
        .read(state.frame.motion)
        .read(change_wanted_ ? change.current(0) : moment_texels.current(0))
        .read(told.current(0))
        .read(color.previous(n))
        .read(depth.previous(n))
        .write(color.current(n))
        .write(depth.current(n))
        .write(state.frame.output.view)
        .constants(constants)
        .dispatch(state.output_extent);
  }

 private:
  CpstConstants constantsOf(const FrameState& state, VkExtent2D history_extent) {
    const Settings& s = state.settings;
    // Settings that it depends on may change without a prepare.
    const double key =
        s.number(kJitter) + 8.0 * s.number(kJitterLength) + 4096.0 * s.number(kShadingSigma);
    if (mean_weight_ == 0.0f || key != mean_weight_key_) mean_weight_ = meanWeight(s);
    mean_weight_key_ = key;
    CpstConstants constants{};
    constants.frame = frameConstants(state, history_extent);
    constants.coarse_origin_px = eq::vec2(static_cast<float>(state.frame.coarse_origin_px[0]),
                                          static_cast<float>(state.frame.coarse_origin_px[1]));
    constants.coarse_size = static_cast<float>(std::max(state.frame.coarse_size, 1u));
    constants.sigma_px = s.real(kShadingSigma);
    constants.held_limit = (1.0f / s.real(kAlpha) - 1.0f) * mean_weight_;
    constants.held_limit_still = std::max(s.real(kStillFrames) - 1.0f, 0.0f) * mean_weight_;
    constants.gamma = s.real(kGamma);
    constants.gamma_still = s.real(kGammaStill);
    constants.silhouette_share = s.real(kSilhouette);
    constants.depth_tolerance = s.real(kDepthTolerance);
    constants.uncover_motion_px = s.real(kUncoverMotion);
    constants.history_sharpness = s.real(kHistorySharpness);
    constants.mean_weight = mean_weight_;
    constants.change_errors = s.real(kChangeErrors);
    return constants;
  }

  bool coarse_moments_ = false;
  bool told_wanted_ = false;
  bool change_wanted_ = false;
  float mean_weight_ = 0.0f;
  double mean_weight_key_ = 0.0;
  HistoryHandle color_ = 0;
  HistoryHandle depth_ = 0;
  HistoryHandle moment_texels_ = 0;
  HistoryHandle told_texels_ = 0;
  HistoryHandle change_texels_ = 0;
  PassHandle moments_ = 0;
  PassHandle silhouettes_ = 0;
  PassHandle change_ = 0;
  PassHandle resolve_ = 0;
};

constexpr RepriseTechniqueInfo kInfo = {
    .name = "cpst",
    .summary = "Coarse pixel shading with temporal supersampling: a quarter of the shading",
    .source = "Xiao, Liktor, Vaidyanathan 2018",
    .flags = REPRISE_TECHNIQUE_USES_HISTORY,
    .settings = kSettings.data(),
    .setting_count = kSettingCount,
    .presets = kPresets,
    .preset_count = static_cast<uint32_t>(std::size(kPresets)),
};

}  // namespace
}  // namespace reprise::cpst

namespace reprise {

extern const TechniqueEntry kCpstEntry;
const TechniqueEntry kCpstEntry = {
    &cpst::kInfo, []() -> std::unique_ptr<Technique> { return std::make_unique<cpst::Cpst>(); }};

}  // namespace reprise
