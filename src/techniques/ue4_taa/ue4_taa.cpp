// SPDX-License-Identifier: MIT
#include <cmath>

#include "reprise/reprise.h"
// reprise.h first: the shared header is GLSL too and includes no Vulkan header.
#include "core/centred_jitter.h"
#include "core/context.h"
#include "core/sample_weights.h"
#include "equations/filters.h"
#include "techniques/ue4_taa/ue4_taa_shared.h"

namespace reprise::ue4_taa {
namespace {

constexpr uint32_t kShader[] = {
#include "ue4_taa.comp.inc"
};

enum Setting : uint32_t { kAntiFlicker, kJitterLength, kSettingCount };

constexpr const char* kAntiFlickerNames[] = {"none", "bounds", "contrast", nullptr};

constexpr auto kSettings = settingTable({
    choiceSetting(kAntiFlicker, "anti_flicker", kAntiFlickerContrast, kAntiFlickerNames,
                  "lowers the current frame's weight where history lies near the bound, or where "
                  "its luma is like the current one",
                  "Karis 2014; experiment: README.md"),
    integerSetting(kJitterLength, "jitter_length", 8, 1, 1024, "frames",
                   "length of the Halton(2,3) cycle of sample positions; 1: the centre",
                   "Karis 2014: 8", 0),
});
static_assert(kSettings.size() == kSettingCount);

Ue4TaaConstants ue4TaaConstants(const FrameState& state, VkExtent2D history_extent) {
  Ue4TaaConstants constants{};
  constants.frame = frameConstants(state, history_extent);
  const std::array<float, 9> w = sampleWeights(state.jitter_px, [](float dx_px, float dy_px) {
    return eq::blackmanHarrisFilter(std::sqrt(dx_px * dx_px + dy_px * dy_px));
  });
  constants.filter_weights_0_3 = eq::vec4(w[0], w[1], w[2], w[3]);
  constants.filter_weights_4_7 = eq::vec4(w[4], w[5], w[6], w[7]);
  constants.filter_weight_8 = eq::vec4(w[8], 0.0f, 0.0f, 0.0f);
  return constants;
}

class Ue4Taa final : public Technique {
 public:
  void plan(const PlanRequest& request, RepriseSamplePlan& plan) const override {
    planCentredJitter(eq::kSequenceHalton, request.frame_index,
                      request.settings.choice(kJitterLength), plan);
  }

  void declare(Declaration& declaration) override {
    history_ = declaration.history("history color", VK_FORMAT_R16G16B16A16_SFLOAT,
                                   declaration.max_output_extent, 2);
    resolve_ = declaration.pass(
        {.name = "resolve",
         .spirv = kShader,
         .bindings = {Binding::kTexel, Binding::kTexel, Binding::kTexel, Binding::kTexel,
                      Binding::kLinear, Binding::kStorage, Binding::kStorage, Binding::kConstants},
         .constant_bytes = sizeof(Ue4TaaConstants),
         .specialization = {declaration.settings.choice(kAntiFlicker)}});
  }

  void record(Recorder& recorder, const FrameState& state) override {
    const HistoryImage& history = recorder.history(history_);
    recorder.pass(resolve_)
        .read(state.frame.color)
        .read(state.frame.depth)
        .read(state.frame.motion)
        .read(recorder.orFloatPlaceholder(state.frame.reactive))
        .read(history.previous(state.record))
        .write(history.current(state.record))
        .write(state.frame.output.view)
        .constants(ue4TaaConstants(state, history.extent()))
        .dispatch(state.output_extent);
  }

 private:
  HistoryHandle history_ = 0;
  PassHandle resolve_ = 0;
};

constexpr RepriseTechniqueInfo kInfo = {
    .name = "ue4-taa",
    .summary = "Temporal antialiasing as Unreal Engine 4 introduced it: the baseline of 2016",
    .source = "Karis 2014",
    .flags = REPRISE_TECHNIQUE_USES_HISTORY | REPRISE_TECHNIQUE_USES_REACTIVE,
    .settings = kSettings.data(),
    .setting_count = kSettingCount,
    .presets = nullptr,
    .preset_count = 0,
};

}  // namespace
}  // namespace reprise::ue4_taa

namespace reprise {

extern const TechniqueEntry kUe4TaaEntry;
const TechniqueEntry kUe4TaaEntry = {&ue4_taa::kInfo, []() -> std::unique_ptr<Technique> {
                                       return std::make_unique<ue4_taa::Ue4Taa>();
                                     }};

}  // namespace reprise
