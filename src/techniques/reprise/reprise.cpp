// SPDX-License-Identifier: MIT
#include "reprise/reprise.h"

#include <algorithm>
#include <cmath>
// reprise.h first: the shared header is GLSL too and includes no Vulkan header.
#include "core/centred_jitter.h"
#include "core/context.h"
#include "equations/filters.h"
#include "techniques/reprise/reprise_settings.h"
#include "techniques/reprise/reprise_shared.h"

namespace reprise::reprise_technique {
namespace {

constexpr uint32_t kPredictShader[] = {
#include "predict.comp.inc"
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

// Fewer samples than this and the frame is antialiased along its edges; a frame brings half a one.
// Above the input it falls with the ratio: few samples of the very pixel are worth more than the
// frame's (2 at twice the extent: `chart/still` -0.8 dB, `teapot/orbit` -0.3, `horse/gallop` +0.1).
constexpr float kAloneSamples = 2.0f;
// In motion what silhouettes leave flips a little too: only flips beyond `kChanceFlips` count (2.3
// dB on `chart/pan`, 1.6 on highlights; without the threshold the capture loses). The threshold
// falls as the output's extent grows (0.1 dB on `horse/gallop` at twice the extent).
constexpr float kChanceFlips = 0.1f;
// Share of Lanczos less, each doubling of the output's extent (`sharpness`; 0.1 dB).
constexpr float kSofter = 0.05f;
// Of the jitter's cycle, whatever the ratio: as the setting's own limit.
constexpr double kMaxJitterLength = 1024.0;
// History texels a pixel and axis.
constexpr uint32_t kTexels = 2;
VkExtent2D tileExtent(VkExtent2D pixels) {
  return {(pixels.width + kTileSize_px - 1) / kTileSize_px,
          (pixels.height + kTileSize_px - 1) / kTileSize_px};
}

// Output pixels an input pixel.
double areaRatio(VkExtent2D input, VkExtent2D output) {
  return static_cast<double>(output.width) * output.height /
         (static_cast<double>(input.width) * input.height);
}

eq::vec2 toVec2(VkExtent2D extent) {
  return eq::vec2(static_cast<float>(extent.width), static_cast<float>(extent.height));
}

RepriseConstants repriseConstants(const FrameState& state, VkExtent2D pixel_extent,
                                  VkExtent2D output_extent) {
  const Settings& s = state.settings;
  RepriseConstants constants{};
  constants.frame = frameConstants(state, pixel_extent);
  const VkExtent2D tiles = tileExtent(pixel_extent);
  const VkExtent2D used = tileExtent(state.input_extent);
  constants.tile_uv = eq::vec2(1.0f / static_cast<float>(tiles.width * kTileSize_px),
                               1.0f / static_cast<float>(tiles.height * kTileSize_px));
  constants.last_tile_uv =
      eq::vec2((static_cast<float>(used.width) - 0.5f) / static_cast<float>(tiles.width),
               (static_cast<float>(used.height) - 0.5f) / static_cast<float>(tiles.height));
  constants.output_extent_px = toVec2(state.output_extent);
  constants.previous_output_extent_px = toVec2(state.previous_output_extent);
  constants.output_texel_uv = eq::vec2(1.0f / static_cast<float>(output_extent.width),
                                       1.0f / static_cast<float>(output_extent.height));
  constants.sample_width = s.real(kSampleWidth);
  // Fewer samples an output pixel: history errs for longer in one direction, and passes for
  // changed.
  const auto doubt =
      static_cast<float>(std::sqrt(areaRatio(state.input_extent, state.output_extent)));
  constants.history = s.real(kHistory);
  constants.still_history = s.real(kStillHistory);
  constants.bound = s.real(kBound) * doubt;
  constants.bound_faint = s.real(kBoundFaint) * doubt;
  constants.bound_changed = s.real(kBoundChanged);
  constants.bound_still = s.real(kBoundStill);
  constants.forget_clipped = s.real(kForgetClipped);
  constants.forget_changed = s.real(kForgetChanged);
  // What sharpens detail sharpens noise too.
  constants.sharpness =
      std::max(0.0f, s.real(kSharpness) - kSofter * std::max(0.0f, std::log2(doubt)));
  constants.depth_tolerance = s.real(kDepthTolerance);
  constants.history_uncovered = s.real(kHistoryUncovered);
  constants.bound_apart = s.real(kBoundApart);
  constants.flips = s.real(kFlips);
  constants.chance_flips = kChanceFlips * std::pow(doubt, -1.5f);
  constants.alone_samples = kAloneSamples / doubt;
  constants.tone = s.real(kTone);
  constants.far_frames = static_cast<float>(s.choice(kFarFrames));
  constants.doubt_light = s.real(kDoubtLight);
  constants.doubt_now = s.real(kDoubtNow) * doubt;
  constants.doubt_mean = s.real(kDoubtMean) * doubt;
  return constants;
}

class RepriseTechnique final : public Technique {
 public:
  void plan(const PlanRequest& request, RepriseSamplePlan& plan) const override {
    // As many samples for each output pixel whatever the ratio; textures as sharp as the output.
    const double ratio = areaRatio(request.input_extent, request.output_extent);
    const double length = std::round(request.settings.choice(kJitterLength) * ratio);
    // R2 spreads few samples best over one pixel, Halton over the quarters of one: above the input
    // R2 and a pan can go in step (0.6 dB on `brick/rotate`, 0.4 on `teapot/orbit`).
    const uint32_t sequence = ratio > 1.0 ? eq::kSequenceHalton : eq::kSequenceR2;
    planCentredJitter(sequence, request.frame_index,
                      static_cast<uint32_t>(std::clamp(length, 1.0, kMaxJitterLength)), plan);
    plan.mip_bias = static_cast<float>(-0.5 * std::log2(ratio));
  }

  void declare(Declaration& d) override {
    pixel_extent_ = d.max_input_extent;
    output_extent_ = d.max_output_extent;
    const VkExtent2D fine = {output_extent_.width * kTexels, output_extent_.height * kTexels};
    color_ = d.history("history color", VK_FORMAT_R16G16B16A16_SFLOAT, fine, 2);
    depth_ = d.history("history depth", VK_FORMAT_R32_UINT, pixel_extent_, 2);
    change_ = d.history("history change", VK_FORMAT_R16G16B16A16_SFLOAT, output_extent_, 2);
    predicted_ = d.history("predicted color", VK_FORMAT_R16G16B16A16_SFLOAT, pixel_extent_, 1);
    const VkExtent2D tiles = tileExtent(pixel_extent_);
    came_ = d.history("tile samples", VK_FORMAT_R16G16B16A16_SFLOAT, tiles, 1);
    told_ = d.history("tile predictions", VK_FORMAT_R16G16B16A16_SFLOAT, tiles, 1);
    predict_pass_ =
        d.pass({.name = "predict",
                .spirv = kPredictShader,
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
    light_ = d.history("light shift", VK_FORMAT_R16G16B16A16_SFLOAT, tiles, 2);
    gain_ = d.history("light gain", VK_FORMAT_R16G16B16A16_SFLOAT, tiles, 1);
    light_pass_ = d.pass({.name = "light",
                          .spirv = kLightShader,
                          .bindings = {Binding::kTexel, Binding::kTexel, Binding::kTexel,
                                       Binding::kStorage, Binding::kStorage, Binding::kConstants},
                          .constant_bytes = sizeof(RepriseConstants),
                          .specialization = {}});
    accumulate_pass_ =
        d.pass({.name = "accumulate",
                .spirv = kAccumulateShader,
                .bindings = {Binding::kTexel, Binding::kTexel, Binding::kTexel, Binding::kTexel,
                             Binding::kTexel, Binding::kTexel, Binding::kTexel, Binding::kLinear,
                             Binding::kLinear, Binding::kStorage, Binding::kStorage,
                             Binding::kStorage, Binding::kConstants},
                .constant_bytes = sizeof(RepriseConstants),
                .specialization = {}});
  }

  void record(Recorder& recorder, const FrameState& state) override {
    const HistoryImage& color = recorder.history(color_);
    const HistoryImage& depth = recorder.history(depth_);
    const HistoryImage& change = recorder.history(change_);
    const HistoryImage& predicted = recorder.history(predicted_);
    const HistoryImage& came = recorder.history(came_);
    const HistoryImage& gain = recorder.history(gain_);
    const HistoryImage& told = recorder.history(told_);
    const RepriseConstants constants = repriseConstants(state, pixel_extent_, output_extent_);
    const uint64_t n = state.record;
    recorder.pass(predict_pass_)
        .read(state.frame.depth)
        .read(state.frame.motion)
        .read(color.previous(n))
        .read(depth.previous(n))
        .write(depth.current(n))
        .write(predicted.current(0))
        .constants(constants)
        .dispatch(state.input_extent);
    recorder.pass(tile_pass_)
        .read(state.frame.color)
        .read(predicted.current(0))
        .write(came.current(0))
        .write(told.current(0))
        .constants(constants)
        .dispatch(tileExtent(state.input_extent));
    recorder.pass(light_pass_)
        .read(came.current(0))
        .read(told.current(0))
        .read(recorder.history(light_).previous(n))
        .write(recorder.history(light_).current(n))
        .write(gain.current(0))
        .constants(constants)
        .dispatch(tileExtent(state.input_extent));
    recorder.pass(accumulate_pass_)
        .read(state.frame.color)
        .read(state.frame.motion)
        .read(recorder.orFloatPlaceholder(state.frame.reactive))
        .read(predicted.current(0))
        .read(state.frame.depth)
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
  VkExtent2D output_extent_{};
  HistoryHandle color_ = 0;
  HistoryHandle depth_ = 0;
  HistoryHandle change_ = 0;
  HistoryHandle predicted_ = 0;
  HistoryHandle came_ = 0;
  HistoryHandle told_ = 0;
  HistoryHandle gain_ = 0;
  HistoryHandle light_ = 0;
  PassHandle predict_pass_ = 0;
  PassHandle tile_pass_ = 0;
  PassHandle light_pass_ = 0;
  PassHandle accumulate_pass_ = 0;
};

constexpr RepriseTechniqueInfo kInfo = {
    .name = "reprise",
    .summary = "Ours: history at twice the resolution, kept until evidence speaks against it",
    .source = "this project",
    .flags = REPRISE_TECHNIQUE_UPSAMPLES | REPRISE_TECHNIQUE_USES_HISTORY |
             REPRISE_TECHNIQUE_USES_REACTIVE,
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
