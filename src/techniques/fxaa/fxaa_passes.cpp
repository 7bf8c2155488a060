// SPDX-License-Identifier: MIT
#include "techniques/fxaa/fxaa_passes.h"

#include <iterator>

namespace reprise::fxaa {
namespace {

constexpr uint32_t kLumaShader[] = {
#include "fxaa_luma.comp.inc"
};
constexpr uint32_t kFilterShader[] = {
#include "fxaa.comp.inc"
};

// Steps of the published presets, in px (Lottes 2011, FXAA 3.11): 10 to 15 coarse, 20 to 29 finer,
// 39 the longest search. 0 ends a list.
constexpr float kSteps_px[][kMaxSteps] = {
    {1.5f, 3, 12},
    {1, 1.5f, 3, 12},
    {1, 1.5f, 2, 4, 12},
    {1, 1.5f, 2, 2, 4, 12},
    {1, 1.5f, 2, 2, 2, 4, 12},
    {1, 1.5f, 2, 2, 2, 2, 4, 12},
    {1.5f, 2, 8},
    {1, 1.5f, 2, 8},
    {1, 1.5f, 2, 2, 8},
    {1, 1.5f, 2, 2, 2, 8},
    {1, 1.5f, 2, 2, 2, 3, 8},
    {1, 1.5f, 2, 2, 2, 2, 4, 8},
    {1, 1.5f, 2, 2, 2, 2, 2, 4, 8},
    {1, 1.5f, 2, 2, 2, 2, 2, 2, 4, 8},
    {1, 1.5f, 2, 2, 2, 2, 2, 2, 2, 4, 8},
    {1, 1.5f, 2, 2, 2, 2, 2, 2, 2, 2, 4, 8},
    {1, 1, 1, 1, 1, 1.5f, 2, 2, 2, 2, 4, 8},
};
static_assert(std::size(kSteps_px) + 1 == std::size(kQualityNames));

FxaaConstants fxaaConstants(const FrameState& state, VkExtent2D luma_extent,
                            const Options& options) {
  FxaaConstants constants{};
  constants.frame = frameConstants(state, luma_extent);
  const float* steps_px = kSteps_px[options.quality];
  eq::vec4* const fours[] = {&constants.steps_0_3_px, &constants.steps_4_7_px,
                             &constants.steps_8_11_px};
  for (uint32_t i = 0; i < kMaxSteps; ++i) {
    (*fours[i / 4])[static_cast<int>(i % 4)] = steps_px[i];
    if (steps_px[i] > 0.0f) constants.step_count = static_cast<float>(i + 1);
  }
  constants.edge_threshold = options.edge_threshold;
  constants.edge_threshold_min = options.edge_threshold_min;
  constants.subpixel = options.subpixel;
  return constants;
}

}  // namespace

const char* const kQualityNames[18] = {"10", "11", "12", "13", "14", "15", "20", "21", "22",
                                       "23", "24", "25", "26", "27", "28", "29", "39", nullptr};

void Passes::declare(Declaration& declaration, uint32_t blend) {
  // One half is enough for thresholds of 1/32 and more; not every device can store it.
  const VkFormat format = declaration.storable(VK_FORMAT_R16_SFLOAT)
                              ? VK_FORMAT_R16_SFLOAT
                              : VK_FORMAT_R16G16B16A16_SFLOAT;
  luma_ = declaration.history("fxaa luma", format, declaration.max_input_extent, 1);
  luma_pass_ =
      declaration.pass({.name = "fxaa luma",
                        .spirv = kLumaShader,
                        .bindings = {Binding::kTexel, Binding::kStorage, Binding::kConstants},
                        .constant_bytes = sizeof(FxaaConstants),
                        .specialization = {}});
  filter_pass_ = declaration.pass(
      {.name = "fxaa",
       .spirv = kFilterShader,
       .bindings = {Binding::kTexel, Binding::kLinear, Binding::kStorage, Binding::kConstants},
       .constant_bytes = sizeof(FxaaConstants),
       .specialization = {blend}});
}

void Passes::record(Recorder& recorder, const FrameState& state, const Options& options,
                    const RepriseImage& color, VkImageView output) const {
  const HistoryImage& luma = recorder.history(luma_);
  const FxaaConstants constants = fxaaConstants(state, luma.extent(), options);
  recorder.pass(luma_pass_)
      .read(color)
      .write(luma.current(0))
      .constants(constants)
      .dispatch(state.input_extent);
  recorder.pass(filter_pass_)
      .read(color)
      .read(luma.current(0))
      .write(output)
      .constants(constants)
      .dispatch(state.input_extent);
}

}  // namespace reprise::fxaa
