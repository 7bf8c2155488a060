// SPDX-License-Identifier: MIT
#include "core/context.h"
#include "core/frame_constants.h"

namespace reprise {
namespace {

constexpr uint32_t kShader[] = {
#include "none.comp.inc"
};

class None final : public Technique {
 public:
  void plan(const PlanRequest&, RepriseSamplePlan& plan) const override { plan.period = 1; }

  void declare(Declaration& declaration) override {
    copy_ = declaration.pass({.name = "copy",
                              .spirv = kShader,
                              .bindings = {Binding::kTexel, Binding::kStorage, Binding::kConstants},
                              .constant_bytes = sizeof(FrameConstants),
                              .specialization = {}});
  }

  void record(Recorder& recorder, const FrameState& state) override {
    recorder.pass(copy_)
        .read(state.frame.color)
        .write(state.frame.output.view)
        .constants(frameConstants(state, state.output_extent))
        .dispatch(state.output_extent);
  }

 private:
  PassHandle copy_ = 0;
};

constexpr RepriseTechniqueInfo kInfo = {
    .name = "none",
    .summary = "The current frame as it is: one sample at the pixel centre",
    .source = "baseline",
    .flags = 0,
    .settings = nullptr,
    .setting_count = 0,
    .presets = nullptr,
    .preset_count = 0,
};

}  // namespace

extern const TechniqueEntry kNoneEntry;
const TechniqueEntry kNoneEntry = {
    &kInfo, []() -> std::unique_ptr<Technique> { return std::make_unique<None>(); }};

}  // namespace reprise
