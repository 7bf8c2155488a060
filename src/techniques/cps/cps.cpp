// SPDX-License-Identifier: MIT
//
// `taa` over frames that are shaded once for 2 x 2 pixels: what a renderer gets that turns coarse
// shading on and changes nothing else.
#include "core/context.h"
#include "reprise/reprise.h"
#include "techniques/taa/taa_settings.h"

namespace reprise {
namespace {

constexpr uint32_t kCoarseSize = 2;
// Derivatives span coarse pixels: one level too coarse (Xiao et al. 2018, section 4).
constexpr float kMipBias = -1.0f;

class Cps final : public Technique {
 public:
  void plan(const PlanRequest& request, RepriseSamplePlan& plan) const override {
    taa_->plan(request, plan);
    plan.mip_bias += kMipBias;
    plan.coarse_size = kCoarseSize;
  }
  void declare(Declaration& declaration) override { taa_->declare(declaration); }
  void record(Recorder& recorder, const FrameState& state) override {
    taa_->record(recorder, state);
  }

 private:
  std::unique_ptr<Technique> taa_ = taa::createTaa();
};

const RepriseTechniqueInfo kInfo = {
    .name = "cps",
    .summary = "Coarse pixel shading, 2 x 2, under the temporal antialiasing of taa",
    .source = "Vaidyanathan et al. 2014; the baseline of Xiao, Liktor, Vaidyanathan 2018",
    .flags = REPRISE_TECHNIQUE_USES_HISTORY | REPRISE_TECHNIQUE_USES_REACTIVE |
             REPRISE_TECHNIQUE_USES_ID,
    .settings = taa::kSettings.data(),
    .setting_count = taa::kSettingCount,
    .presets = nullptr,
    .preset_count = 0,
};

}  // namespace

extern const TechniqueEntry kCpsEntry;
const TechniqueEntry kCpsEntry = {
    &kInfo, []() -> std::unique_ptr<Technique> { return std::make_unique<Cps>(); }};

}  // namespace reprise
