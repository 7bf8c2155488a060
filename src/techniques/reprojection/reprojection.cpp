// SPDX-License-Identifier: MIT
#include "reprise/reprise.h"
// reprise.h first: the shared header is GLSL too and includes no Vulkan header.
#include "core/centred_jitter.h"
#include "core/context.h"
#include "equations/hash.h"
#include "techniques/reprojection/reprojection_shared.h"

namespace reprise {
namespace {

constexpr uint32_t kShader[] = {
#include "reprojection.comp.inc"
};

enum Setting : uint32_t { kAlpha, kJitter, kJitterLength, kDepthTolerance, kSettingCount };
enum Jitter : uint32_t { kJitterHalton, kJitterUniform };

constexpr const char* kJitterNames[] = {"halton", "uniform", nullptr};
constexpr uint32_t kUniformSeed = 0x51ed270bu;

constexpr auto kSettings = settingTable({
    numberSetting(
        kAlpha, "alpha", 0.1, 0.001, 1.0, "",
        "weight of the current sample; raising it blurs less in motion and averages fewer "
        "samples: (2 - alpha) / alpha of them at rest",
        "Nehab et al. 2007; Yang et al. 2009 choose it for each scene by PSNR"),
    choiceSetting(kJitter, "jitter", kJitterHalton, kJitterNames,
                  "sample positions: Halton(2,3), which fill the pixel evenly, or independent "
                  "uniform ones, a new one for every frame",
                  "Scherzer et al. 2007, Yang et al. 2009, section 7: uniform; Halton does better"),
    integerSetting(kJitterLength, "jitter_length", 16, 1, 1024, "frames",
                   "length of the Halton(2,3) cycle; 1: the centre",
                   "Scherzer et al. 2007 jitter uniformly over the pixel"),
    numberSetting(
        kDepthTolerance, "depth_tolerance", 0.02, 0.001, 1.0, "relative",
        "largest relative difference of depths that still counts as the same surface; "
        "raising it keeps more history and more ghosts",
        "techniques named in Nehab et al. 2007 give no figure; 0.01 to 0.02 is customary"),
});
static_assert(kSettings.size() == kSettingCount);

class Reprojection final : public Technique {
 public:
  void plan(const PlanRequest& request, RepriseSamplePlan& plan) const override {
    if (request.settings.choice(kJitter) == kJitterUniform) {
      const auto frame = static_cast<uint32_t>(request.frame_index);
      const uint32_t bits = eq::hashPixel(frame, 0, kUniformSeed);
      plan.jitter_px[0] = 0.5f - eq::unitFloat(bits);
      plan.jitter_px[1] = 0.5f - eq::unitFloat(eq::hashPcg(bits));
      return;
    }
    planCentredJitter(eq::kSequenceHalton, request.frame_index,
                      request.settings.choice(kJitterLength), plan);
  }

  void declare(Declaration& declaration) override {
    history_ = declaration.history("history color and depth", VK_FORMAT_R16G16B16A16_SFLOAT,
                                   declaration.max_output_extent, 2);
    resolve_ = declaration.pass(
        {.name = "resolve",
         .spirv = kShader,
         .bindings = {Binding::kTexel, Binding::kTexel, Binding::kTexel, Binding::kLinear,
                      Binding::kStorage, Binding::kStorage, Binding::kConstants},
         .constant_bytes = sizeof(ReprojectionConstants),
         .specialization = {}});
  }

  void record(Recorder& recorder, const FrameState& state) override {
    const HistoryImage& history = recorder.history(history_);
    ReprojectionConstants constants{};
    constants.frame = frameConstants(state, history.extent());
    constants.alpha = state.settings.real(kAlpha);
    constants.depth_tolerance = state.settings.real(kDepthTolerance);
    recorder.pass(resolve_)
        .read(state.frame.color)
        .read(state.frame.depth)
        .read(state.frame.motion)
        .read(history.previous(state.record))
        .write(history.current(state.record))
        .write(state.frame.output.view)
        .constants(constants)
        .dispatch(state.output_extent);
  }

 private:
  HistoryHandle history_ = 0;
  PassHandle resolve_ = 0;
};

constexpr RepriseTechniqueInfo kInfo = {
    .name = "reprojection",
    .summary = "Jittered reverse reprojection: one buffer, bilinear history, depth test",
    .source = "Nehab et al. 2007; Scherzer et al. 2007",
    .flags = REPRISE_TECHNIQUE_USES_HISTORY,
    .settings = kSettings.data(),
    .setting_count = kSettingCount,
    .presets = nullptr,
    .preset_count = 0,
};

}  // namespace

extern const TechniqueEntry kReprojectionEntry;
const TechniqueEntry kReprojectionEntry = {
    &kInfo, []() -> std::unique_ptr<Technique> { return std::make_unique<Reprojection>(); }};

}  // namespace reprise
