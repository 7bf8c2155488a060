// SPDX-License-Identifier: MIT
#include "techniques/fxaa/fxaa_passes.h"

namespace reprise::fxaa {
namespace {

enum Setting : uint32_t {
  kQuality,
  kEdgeThreshold,
  kEdgeThresholdMin,
  kSubpixel,
  kBlend,
  kSettingCount
};

constexpr const char* kQualityChoices[] = {"10", "11", "12", "13", "14", "15", "20", "21", "22",
                                           "23", "24", "25", "26", "27", "28", "29", "39", nullptr};
static_assert(std::size(kQualityChoices) == std::size(kQualityNames));
constexpr const char* kBlendNames[] = {"linear", "display", nullptr};

constexpr auto kSettings = settingTable({
    choiceSetting(kQuality, "quality", 2, kQualityChoices,
                  "the published preset: how far and in which steps an edge's ends are sought; the "
                  "second digit is the effort, 10 to 15 in coarser steps than 20 to 29",
                  "Lottes 2011; 12 is its default", 0),
    numberSetting(kEdgeThreshold, "edge_threshold", 0.166, 0.031, 1.0, "relative",
                  "least contrast that is an edge, of the brightest neighbour's luma; lower "
                  "smooths fainter edges and costs more",
                  "Lottes 2011: 0.333 faster, 0.166 default, 0.125 high, 0.063 overkill"),
    numberSetting(kEdgeThresholdMin, "edge_threshold_min", 0.0833, 0.0, 1.0, "display luma",
                  "contrast below this is no edge however dark its surroundings",
                  "Lottes 2011: 0.0833 default, 0.0625 high, 0.0312 limit of the visible"),
    numberSetting(kSubpixel, "subpix", 0.75, 0.0, 1.0, "px",
                  "how far detail below a pixel is smoothed away: 0 not at all, 1 soft",
                  "Lottes 2011: 0.75"),
    choiceSetting(kBlend, "blend", kBlendLinear, kBlendNames,
                  "space in which two pixels mix: linear light, as a supersampled image does, or "
                  "the display's encoding, as FXAA does after tone mapping",
                  "experiment: README.md"),
});
static_assert(kSettings.size() == kSettingCount);

constexpr RepriseSettingValue kFast[] = {{"quality", 0.0, "10"},
                                         {"edge_threshold", 0.333, nullptr}};
constexpr RepriseSettingValue kHigh[] = {{"quality", 0.0, "29"},
                                         {"edge_threshold", 0.125, nullptr},
                                         {"edge_threshold_min", 0.0625, nullptr}};
constexpr RepriseSettingValue kOverkill[] = {{"quality", 0.0, "39"},
                                             {"edge_threshold", 0.063, nullptr},
                                             {"edge_threshold_min", 0.0312, nullptr}};
constexpr ReprisePresetInfo kPresets[] = {
    {"fast", kFast, std::size(kFast), "the published thresholds of low effort"},
    {"high", kHigh, std::size(kHigh), "the published thresholds of high quality"},
    {"overkill", kOverkill, std::size(kOverkill), "the longest search, edges at the limit"},
};

class Fxaa final : public Technique {
 public:
  void plan(const PlanRequest&, RepriseSamplePlan& plan) const override { plan.period = 1; }

  void declare(Declaration& declaration) override {
    passes_.declare(declaration, declaration.settings.choice(kBlend));
  }

  void record(Recorder& recorder, const FrameState& state) override {
    const Settings& s = state.settings;
    passes_.record(recorder, state,
                   {.quality = s.choice(kQuality),
                    .edge_threshold = s.real(kEdgeThreshold),
                    .edge_threshold_min = s.real(kEdgeThresholdMin),
                    .subpixel = s.real(kSubpixel)},
                   state.frame.color, state.frame.output.view);
  }

 private:
  Passes passes_;
};

constexpr RepriseTechniqueInfo kInfo = {
    .name = "fxaa",
    .summary = "FXAA 3.11 quality: antialiasing along edges of the one frame, no history",
    .source = "Lottes 2011",
    .flags = 0,
    .settings = kSettings.data(),
    .setting_count = kSettingCount,
    .presets = kPresets,
    .preset_count = std::size(kPresets),
};

}  // namespace
}  // namespace reprise::fxaa

namespace reprise {

extern const TechniqueEntry kFxaaEntry;
const TechniqueEntry kFxaaEntry = {
    &fxaa::kInfo, []() -> std::unique_ptr<Technique> { return std::make_unique<fxaa::Fxaa>(); }};

}  // namespace reprise
