// SPDX-License-Identifier: MIT
#include "techniques/amortized/amortized_settings.h"

#include "techniques/amortized/blur_table.h"

namespace reprise::amortized {
namespace {

constexpr const char* kYang = "Yang et al. 2009";
constexpr const char* kBufferNames[] = {"1", "2", "4", nullptr};
constexpr const char* kSampleNames[] = {"shading", "frame", nullptr};
constexpr const char* kMotionNames[] = {"chained", "exact", nullptr};
constexpr const char* kOrderNames[] = {"irregular", "round-robin", nullptr};

// tau_b of 1, 2, 4 buffers: the sweeps of effects.md, blur tolerance. With one buffer the samples
// alone have 0.224 px^2.
constexpr double kBlurOfBuffers_px2[] = {1.0, 0.3, 0.25};

// A new sample and one for each of four quadrants.
constexpr double kMostEvaluations = 5.0;
// Beyond the effective samples that a moving history reaches, every pixel would ask for ever.
constexpr double kHighestQuality = 64.0;

constexpr auto kSettings = settingTable({
    choiceSetting(kBufferCount, "buffers", kBuffersFour, kBufferNames,
                  "subpixel estimates a pixel; more blur less in motion and cost memory and time",
                  "Yang et al. 2009, section 5.1: 4; other numbers are its future work"),
    choiceSetting(kEffort, "effort", kBuffersFour, kBufferNames,
                  "how many of the buffers are in use; less is faster and blurs more in motion; "
                  "may change at any frame, and what was gathered is carried over",
                  "Yang et al. 2009, section 8, future work; repriseHoldFrameTime sets it", 0),
    choiceSetting(kSamples, "samples", kSamplesShading, kSampleNames,
                  "what the plan moves: shading alone, a pixel at a time, or the whole frame by a "
                  "jittered projection, which antialiases silhouettes too",
                  "Yang et al. 2009: shading; silhouettes are its future work"),
    choiceSetting(kMotion, "motion", kMotionChained, kMotionNames,
                  "motion to the frames of the buffers: chained from frame to frame, or the "
                  "host's own in RepriseFrame::motion_back",
                  "chained needs nothing of the host; the paper's is exact"),
    choiceSetting(kOrder, "order", kOrderIrregular, kOrderNames,
                  "order in which four buffers are written; round robin drifts",
                  "Yang et al. 2009, section 5.2 and Figure 6"),
    switchSetting(kRequests, "requests", true,
                  "repriseRecordRequest lists the quadrants whose reprojection fails, for the host "
                  "to shade; a host that does not call it loses nothing else",
                  "Yang et al. 2009, section 5.3"),
    numberSetting(
        kBudget, "budget", kMostEvaluations, 1.0, kMostEvaluations, "evaluations/px",
        "mean evaluations a pixel that a frame may ask for, its own included; less leaves "
        "out those that would gain least",
        "Yang et al. 2009, section 5.3: 1 to 5, without a limit on the mean"),
    numberSetting(kQuality, "quality", 0.0, 0.0, kHighestQuality, "samples",
                  "samples that every pixel is brought to, those that its history is worth and "
                  "the new one included, as far as five evaluations and the budget reach; asks "
                  "for what is missing and no more; 0: for every quadrant that failed",
                  "Yang et al. 2009, section 8, future work: a target quality"),
    numberSetting(kBlur, "blur", 0.0, 0.0, kWidestBlur_px2, "px^2",
                  "largest second moment that resampling may reach (tau_b); raising it averages "
                  "more frames and blurs more; below that of the samples every buffer starts anew "
                  "in motion; 0: that of the buffers in use, 0.25, 0.3, 1 for 4, 2, 1",
                  "Yang et al. 2009, section 5.2; default: effects.md, blur tolerance"),
    numberSetting(kResidual, "residual", 0.0, 0.0, 10.0, "luminance",
                  "residual above which history is let go (tau_eps); raising it trusts history "
                  "more; 0: never let go, and no residuals are kept",
                  "Yang et al. 2009, section 6", 1),
    numberSetting(kFixedAlpha, "fixed_alpha", 0.0, 0.0, 1.0, "",
                  "weight of a new sample in its buffer, whatever the bounds say; 0: by the bounds",
                  "Yang et al. 2009, Figures 3 and 6 hold it constant"),
    numberSetting(kMaxSamples, "max_samples", 1024.0, 1.0, 2048.0, "samples",
                  "largest effective number of samples; raising it converges further at rest",
                  "what a half counts exactly; the paper's 8 bits end at 255"),
    numberSetting(kShutter, "shutter", 0.0, 0.0, 1.0, "frames",
                  "motion blur: how long the shutter is open about the frame's instant; 0: none",
                  "Yang et al. 2009, section 8, future work", 1),
    switchSetting(kCoverage, "coverage", false,
                  "silhouettes by hardware multisampling: RepriseFrame::depth_samples says which "
                  "share of a pixel each neighbouring surface covers; costs 8 bytes a pixel",
                  "Yang et al. 2009, sections 1 and 8: framebuffer multisampling for silhouettes"),
    numberSetting(kDepthTolerance, "depth_tolerance", 0.001, 0.0005, 1.0, "relative",
                  "relative distance from the plane through the pixel that is still the same "
                  "surface",
                  "twice the 2^-11 of a depth in half precision; README.md, depth test"),
});
static_assert(kSettings.size() == kSettingCount);

// Evaluations are the dearer, so they go first; then buffers.
constexpr RepriseSettingValue kRungValues[][2] = {
    {{"effort", 0.0, "4"}, {"budget", 5.0, nullptr}},
    {{"effort", 0.0, "4"}, {"budget", 2.0, nullptr}},
    {{"effort", 0.0, "4"}, {"budget", 1.25, nullptr}},
    {{"effort", 0.0, "4"}, {"budget", 1.0, nullptr}},
    {{"effort", 0.0, "2"}, {"budget", 1.0, nullptr}},
    {{"effort", 0.0, "1"}, {"budget", 1.0, nullptr}},
};
constexpr EffortRung kRungArray[] = {kRungValues[0], kRungValues[1], kRungValues[2],
                                     kRungValues[3], kRungValues[4], kRungValues[5]};

}  // namespace

const std::span<const EffortRung> kRungs(kRungArray);

double blurTolerance(const Settings& settings) {
  if (const double blur = settings.number(kBlur); blur > 0.0) return blur;
  return kBlurOfBuffers_px2[std::min(settings.choice(kBufferCount), settings.choice(kEffort))];
}

const RepriseTechniqueInfo kInfo = {
    .name = "amortized",
    .summary = "Amortized supersampling: subpixel buffers, bounded blur, requests where it fails",
    .source = kYang,
    .flags = REPRISE_TECHNIQUE_USES_HISTORY | REPRISE_TECHNIQUE_REQUESTS,
    .settings = kSettings.data(),
    .setting_count = kSettingCount,
    .presets = nullptr,
    .preset_count = 0,
};

}  // namespace reprise::amortized
