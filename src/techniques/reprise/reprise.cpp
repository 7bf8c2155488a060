// SPDX-License-Identifier: MIT
#include <cmath>

#include "reprise/reprise.h"
// reprise.h first: the shared header is GLSL too and includes no Vulkan header.
#include "core/context.h"
#include "equations/filters.h"
#include "equations/jitter_sequence.h"
#include "techniques/reprise/reprise_shared.h"

namespace reprise::reprise_technique {
namespace {

constexpr uint32_t kResidualShader[] = {
#include "residual.comp.inc"
};
constexpr uint32_t kTileShader[] = {
#include "tile.comp.inc"
};
constexpr uint32_t kLightShader[] = {
#include "light.comp.inc"
};
constexpr uint32_t kAccumulateShader[] = {
#include "accumulate.comp.inc"
};

enum Setting : uint32_t {
  kJitterLength,
  kSampleWidth,
  kHistoryLimit,
  kStillLimit,
  kBoundWide,
  kBoundTight,
  kDepthTolerance,
  kSharpness,
  kMemory,
  kDoubtNow,
  kDoubtMean,
  kEvidenceCount,
  kForget,
  kX0,
  kX1,
  kX2,
  kTileCount,
  kDoubtTile,
  kX3,
  kX4,
  kSettingCount
};

constexpr auto kSettings = settingTable({
    integerSetting(kJitterLength, "jitter_length", 16, 1, 1024, "frames", "", "", 0),
    numberSetting(kSampleWidth, "sample_width", 0.3, 0.05, 1.0, "px", "", "", 0),
    numberSetting(kHistoryLimit, "history_limit", 4.0, 0.0, 64.0, "samples", "", "", 0),
    numberSetting(kStillLimit, "still_limit", 256.0, 0.0, 1024.0, "samples", "", "", 0),
    numberSetting(kBoundWide, "bound_wide", 3.0, 0.0, 64.0, "", "", "", 0),
    numberSetting(kBoundTight, "bound_tight", 1.0, 0.0, 64.0, "", "", "", 0),
    numberSetting(kDepthTolerance, "depth_tolerance", 0.02, 0.0, 1.0, "", "", "", 0),
    numberSetting(kSharpness, "sharpness", 0.5, 0.0, 1.0, "", "", "", 0),
    numberSetting(kMemory, "memory", 0.3, 0.0, 1.0, "", "", "", 0),
    numberSetting(kDoubtNow, "doubt_now", 3.0, 0.0, 1e6, "", "", "", 0),
    numberSetting(kDoubtMean, "doubt_mean", 2.0, 0.0, 1e6, "", "", "", 0),
    numberSetting(kEvidenceCount, "evidence_count", 3.0, 0.1, 16, "", "", "", 0),
    numberSetting(kForget, "forget", 0.75, 0.0, 1, "", "", "", 0),
    numberSetting(kX0, "x0", 8.0, 0.0, 1e6, "", "", "", 0),
    numberSetting(kX1, "x1", 1.0, 0.0, 1e6, "", "", "", 0),
    numberSetting(kX2, "x2", 0.01, -1e6, 1e6, "", "", "", 0),
    numberSetting(kTileCount, "tile_count", 8.0, 0.1, 1e3, "", "", "", 0),
    numberSetting(kDoubtTile, "doubt_tile", 2.0, 0.0, 1e6, "", "", "", 0),
    numberSetting(kX3, "x3", 0.0, 0.0, 1e6, "", "", "", 0),
    numberSetting(kX4, "x4", 4.0, 0.0, 1e6, "", "", "", 0),
});
static_assert(kSettings.size() == kSettingCount);

// History texels a pixel and axis.
constexpr uint32_t kTexels = 2;

VkExtent2D tileExtent(VkExtent2D pixels) {
  return {(pixels.width + kTileSize_px - 1) / kTileSize_px,
          (pixels.height + kTileSize_px - 1) / kTileSize_px};
}

RepriseConstants repriseConstants(const FrameState& state, VkExtent2D pixel_extent) {
  const Settings& s = state.settings;
  RepriseConstants constants{};
  constants.frame = frameConstants(state, pixel_extent);
  float* weights[] = {&constants.texel_weights.x, &constants.texel_weights.y,
                      &constants.texel_weights.z, &constants.texel_weights.w};
  for (int i = 0; i < 4; ++i) {
    // The sample lies at -jitter from the pixel's centre, texels at a quarter pixel from it.
    const float dx_px = (i & 1 ? 0.25f : -0.25f) + state.jitter_px.x;
    const float dy_px = (i >> 1 ? 0.25f : -0.25f) + state.jitter_px.y;
    *weights[i] = eq::gaussianFilter(std::sqrt(dx_px * dx_px + dy_px * dy_px), s.real(kSampleWidth));
    *weights[i] = std::max(*weights[i], 1.0e-3f);
  }
  const VkExtent2D tiles = tileExtent(pixel_extent);
  constants.tile_uv = eq::vec2(1.0f / static_cast<float>(tiles.width * kTileSize_px),
                               1.0f / static_cast<float>(tiles.height * kTileSize_px));
  constants.history_limit = s.real(kHistoryLimit);
  constants.still_limit = s.real(kStillLimit);
  constants.bound_wide = s.real(kBoundWide);
  constants.bound_tight = s.real(kBoundTight);
  constants.depth_tolerance = s.real(kDepthTolerance);
  constants.sharpness = s.real(kSharpness);
  constants.memory = s.real(kMemory);
  constants.doubt_now = s.real(kDoubtNow);
  constants.doubt_mean = s.real(kDoubtMean);
  constants.evidence_count = s.real(kEvidenceCount);
  constants.forget = s.real(kForget);
  constants.x0 = s.real(kX0);
  constants.x1 = s.real(kX1);
  constants.x2 = s.real(kX2);
  constants.tile_count = s.real(kTileCount);
  constants.doubt_tile = s.real(kDoubtTile);
  constants.x3 = s.real(kX3);
  constants.x4 = s.real(kX4);
  return constants;
}

class RepriseTechnique final : public Technique {
 public:
  void plan(const PlanRequest& request, RepriseSamplePlan& plan) const override {
    const auto length = request.settings.choice(kJitterLength);
    const eq::vec2 sample_px = eq::sequenceOffset(eq::kSequenceR2, request.frame_index, length) -
                               eq::sequenceMean(eq::kSequenceR2, length);
    plan.period = length;
    plan.jitter_px[0] = -sample_px.x;
    plan.jitter_px[1] = -sample_px.y;
  }

  void declare(Declaration& d) override {
    pixel_extent_ = d.max_output_extent;
    const VkExtent2D fine = {pixel_extent_.width * kTexels, pixel_extent_.height * kTexels};
    color_ = d.history("history color", VK_FORMAT_R16G16B16A16_SFLOAT, fine, 2);
    depth_ = d.history("history depth", VK_FORMAT_R32_SFLOAT, pixel_extent_, 2);
    change_ = d.history("history change", VK_FORMAT_R16G16B16A16_SFLOAT, pixel_extent_, 2);
    residual_ = d.history("predicted color", VK_FORMAT_R16G16B16A16_SFLOAT, pixel_extent_, 1);
    const VkExtent2D tiles = tileExtent(pixel_extent_);
    came_ = d.history("tile samples", VK_FORMAT_R16G16B16A16_SFLOAT, tiles, 1);
    told_ = d.history("tile predictions", VK_FORMAT_R16G16B16A16_SFLOAT, tiles, 1);
    residual_pass_ =
        d.pass({.name = "residual",
                .spirv = kResidualShader,
                .bindings = {Binding::kTexel, Binding::kTexel, Binding::kLinear, Binding::kTexel,
                             Binding::kStorage, Binding::kStorage, Binding::kConstants},
                .constant_bytes = sizeof(RepriseConstants),
                .specialization = {}});
    tile_pass_ = d.pass({.name = "tile",
                         .spirv = kTileShader,
                         .bindings = {Binding::kTexel, Binding::kTexel, Binding::kStorage,
                                      Binding::kStorage, Binding::kConstants},
                         .constant_bytes = sizeof(RepriseConstants),
                         .specialization = {}});
    gain_ = d.history("light gain", VK_FORMAT_R16G16B16A16_SFLOAT, tiles, 1);
    light_pass_ = d.pass({.name = "light",
                         .spirv = kLightShader,
                         .bindings = {Binding::kTexel, Binding::kTexel, Binding::kStorage,
                                      Binding::kConstants},
                         .constant_bytes = sizeof(RepriseConstants),
                         .specialization = {}});
    accumulate_pass_ =
        d.pass({.name = "accumulate",
                .spirv = kAccumulateShader,
                .bindings = {Binding::kTexel, Binding::kTexel, Binding::kTexel, Binding::kTexel,
                             Binding::kTexel, Binding::kTexel, Binding::kTexel, Binding::kLinear,
                             Binding::kLinear, Binding::kStorage, Binding::kStorage,
                             Binding::kStorage,
                             Binding::kConstants},
                .constant_bytes = sizeof(RepriseConstants),
                .specialization = {}});
  }

  void record(Recorder& recorder, const FrameState& state) override {
    const HistoryImage& color = recorder.history(color_);
    const HistoryImage& depth = recorder.history(depth_);
    const HistoryImage& change = recorder.history(change_);
    const HistoryImage& residual = recorder.history(residual_);
    const HistoryImage& came = recorder.history(came_);
    const HistoryImage& gain = recorder.history(gain_);
    const HistoryImage& told = recorder.history(told_);
    const RepriseConstants constants = repriseConstants(state, pixel_extent_);
    const uint64_t n = state.record;
    recorder.pass(residual_pass_)
        .read(state.frame.depth)
        .read(state.frame.motion)
        .read(color.previous(n))
        .read(depth.previous(n))
        .write(depth.current(n))
        .write(residual.current(0))
        .constants(constants)
        .dispatch(state.input_extent);
    recorder.pass(tile_pass_)
        .read(state.frame.color)
        .read(residual.current(0))
        .write(came.current(0))
        .write(told.current(0))
        .constants(constants)
        .dispatch(tileExtent(state.input_extent));
    recorder.pass(light_pass_)
        .read(came.current(0))
        .read(told.current(0))
        .write(gain.current(0))
        .constants(constants)
        .dispatch(tileExtent(state.input_extent));
    recorder.pass(accumulate_pass_)
        .read(state.frame.color)
        .read(state.frame.motion)
        .read(recorder.orFloatPlaceholder(state.frame.reactive))
        .read(residual.current(0))
        .read(depth.current(n))
        .read(color.previous(n))
        .read(depth.previous(n))
        .read(change.previous(n))
        .read(gain.current(0))
        .write(color.current(n))
        .write(change.current(n))
        .write(state.frame.output.view)
        .constants(constants)
        .dispatch(state.output_extent);
  }

 private:
  VkExtent2D pixel_extent_{};
  HistoryHandle color_ = 0;
  HistoryHandle depth_ = 0;
  HistoryHandle change_ = 0;
  HistoryHandle residual_ = 0;
  HistoryHandle came_ = 0;
  HistoryHandle told_ = 0;
  HistoryHandle gain_ = 0;
  PassHandle residual_pass_ = 0;
  PassHandle tile_pass_ = 0;
  PassHandle light_pass_ = 0;
  PassHandle accumulate_pass_ = 0;
};

constexpr RepriseTechniqueInfo kInfo = {
    .name = "reprise",
    .summary = "Ours: history at twice the resolution, kept until evidence speaks against it",
    .source = "this project",
    .flags = REPRISE_TECHNIQUE_USES_HISTORY | REPRISE_TECHNIQUE_USES_REACTIVE,
    .settings = kSettings.data(),
    .setting_count = kSettingCount,
    .presets = nullptr,
    .preset_count = 0,
};

}  // namespace
}  // namespace reprise::reprise_technique

namespace reprise {

extern const TechniqueEntry kRepriseEntry;
const TechniqueEntry kRepriseEntry = {
    &reprise_technique::kInfo, []() -> std::unique_ptr<Technique> {
      return std::make_unique<reprise_technique::RepriseTechnique>();
    }};

}  // namespace reprise
