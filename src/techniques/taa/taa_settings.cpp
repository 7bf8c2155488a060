// SPDX-License-Identifier: MIT
//
// The settings of `taa`. Defaults come from the sweeps in README.md.
#include "techniques/taa/taa_settings.h"

namespace reprise::taa {
namespace {

constexpr const char* kJitterNames[] = {"none",         "halton", "r2",    "sobol",      "n-rooks",
                                        "rotated-grid", "msaa8",  "helix", "blue-noise", nullptr};
constexpr const char* kInputFilterNames[] = {
    "none", "box", "tent", "mitchell", "blackman-harris", "gaussian", nullptr};
constexpr const char* kDilationNames[] = {"none", "closest", "cross", "longest", nullptr};
constexpr const char* kHistoryFilterNames[] = {"bilinear", "catmull-rom-5", "catmull-rom-9",
                                               "lanczos", nullptr};
constexpr const char* kClipNames[] = {"none", "minmax", "rounded", "variance",
                                      "kdop", "cross",  nullptr};
constexpr const char* kTowardNames[] = {"clamp", "centre", "sample", nullptr};
constexpr const char* kSpaceNames[] = {"rgb", "ycocg", nullptr};
constexpr const char* kWeightingNames[] = {"none", "luminance", "log", nullptr};
constexpr const char* kAntiFlickerNames[] = {"none", "bounds", "contrast", nullptr};
constexpr const char* kDepthTestNames[] = {"none", "pixel", "taps", nullptr};
constexpr const char* kOffscreenNames[] = {"reject", "extend", nullptr};

constexpr uint32_t kRebuild = 1;

}  // namespace

constexpr std::array<RepriseSettingInfo, kSettingCount> kTable = settingTable({
    choiceSetting(
        kJitter, "jitter", 2, kJitterNames,
        "sequence of sample positions over the pixel, repeated after jitter_length frames",
        "Yang, Liu, Salvi 2020, section on sampling; Karis 2014", 0),
    integerSetting(kJitterLength, "jitter_length", 16, 1, 1024, "frames",
                   "longer cycles converge further at rest; shorter ones repeat sooner, which "
                   "flickers less under strong clipping. Fixed patterns (rotated-grid 4, msaa8 8, "
                   "helix 4) keep their own length",
                   "INSIDE uses 16, UE4 8"),
    switchSetting(kJitterCentred, "jitter_centred", true,
                  "subtracts the cycle's mean so that the converged image is not shifted",
                  "the prefix of Halton(2,3) has a non-zero mean"),
    numberSetting(kMipBias, "mip_bias", 0.0, -4.0, 4.0, "levels",
                  "asked of the host's texture fetches; negative is sharper and aliases more",
                  "Yang, Liu, Salvi 2020: at most -log2(effective samples) / 2"),
    choiceSetting(kInputFilter, "input_filter", 0, kInputFilterNames,
                  "reconstruction of the current frame at the pixel centre from the nine samples "
                  "around it, by their distance to it; none takes the pixel's own sample",
                  "Karis 2014", 0),
    numberSetting(
        kInputWidth, "input_width", 0.4, 0.1, 2.0, "px",
        "standard deviation of the gaussian; for the others a scale of their width, 1 being "
        "the published one. Wider is steadier and blurs",
        "experiment: README.md, input filter"),
    choiceSetting(
        kDilation, "dilation", 2, kDilationNames,
        "whose motion, depth and id a pixel takes: its own, the closest surface's in 3x3 or "
        "in the cross, or the longest motion in 3x3",
        "Karis 2014; INSIDE"),
    choiceSetting(
        kHistoryFilter, "history_filter", 1, kHistoryFilterNames,
        "how history is read between texels, from soft to sharp: bilinear, bicubic in 5 or "
        "9 fetches, Lanczos-2 in 16",
        "Jimenez 2016 (5 fetches); Karis 2014 (9)"),
    numberSetting(kHistorySharpness, "history_sharpness", 0.6, 0.0, 1.0, "",
                  "c of the cubic: 0.5 is Catmull-Rom, more overshoots", "Jimenez 2016"),
    choiceSetting(
        kClip, "clip", 3, kClipNames,
        "bound of believable history, from the 3x3 neighbourhood: its extremes, the mean of "
        "its and the cross's extremes, mean and standard deviations, slabs along 16 axes, or the "
        "extremes of the cross alone",
        "Lottes 2011; Karis 2014; Salvi 2016; Ikkala et al. 2024"),
    choiceSetting(
        kClipToward, "clip_toward", 1, kTowardNames,
        "how history comes into the bound: each channel by itself, or along the line to the "
        "bound's centre or to the current sample (kdop: always to the sample)",
        "Lottes 2011; INSIDE; Karis 2014"),
    choiceSetting(kClipSpace, "clip_space", 1, kSpaceNames,
                  "axes of the bound; YCoCg follows natural colours more tightly", "Karis 2014"),
    numberSetting(kGamma, "gamma", 1.0, 0.0, 8.0, "standard deviations",
                  "half-size of the variance bound; wider keeps more history and more ghosts",
                  "Salvi 2016: 0.75 to 1.25"),
    numberSetting(kClipForget, "clip_forget", 0.5, 0.0, 1.0, "",
                  "how much of its sample count a fully clipped history loses",
                  "experiment: README.md, clipped history"),
    choiceSetting(
        kWeighting, "weighting", 0, kWeightingNames,
        "space in which samples are bounded and blended: linear, c / (1 + luma), or log(c)",
        "Karis 2014; Lopez 2022"),
    numberSetting(kAlpha, "alpha", 0.2, 0.001, 1.0, "",
                  "lowest weight of the current sample while something moves; (2 - alpha) / alpha "
                  "samples in steady state",
                  "Karis 2014: 0.04; INSIDE: 0.03 to 0.12"),
    choiceSetting(
        kAntiFlicker, "anti_flicker", 0, kAntiFlickerNames,
        "lowers the current sample's weight where history lies near the bound, or changes "
        "it by the contrast of current and history",
        "Karis 2014; INSIDE (after Lottes)"),
    numberSetting(kAntiFlickerStrength, "anti_flicker_strength", 0.5, 0.0, 1.0, "",
                  "0: no effect; 1: the published one", "Karis 2014; INSIDE"),
    numberSetting(kSpeedAlpha, "speed_alpha", 0.0, 0.0, 1.0, "",
                  "weight of the current sample at speed_px and above; between, linear",
                  "Lopez 2022; MiniEngine"),
    numberSetting(kSpeedPx, "speed_px", 20.0, 0.1, 1000.0, "px a frame",
                  "speed at which speed_alpha is reached", "MiniEngine uses 64"),
    choiceSetting(
        kDepthTest, "depth_test", 2, kDepthTestNames,
        "rejects history of nearer surfaces: by the farthest of four taps, or tap by tap, so "
        "that no mixture passes",
        "MiniEngine (pixel); experiment: README.md (taps)"),
    numberSetting(kDepthTolerance, "depth_tolerance", 0.02, 0.0001, 1.0, "relative",
                  "how much farther than the tap the current surface may be",
                  "experiment: README.md, depth test"),
    numberSetting(kMotionTolerance, "motion_tolerance_px", 0.0, 0.0, 100.0, "px a frame",
                  "rejects history whose motion differed by more than this; full rejection at "
                  "ten times it. 0: off, and no image for it",
                  "Lopez 2022, trick 1", kRebuild),
    switchSetting(kIdTest, "id_test", false,
                  "rejects history whose id differs; needs RepriseFrame::id", "Lopez 2022"),
    switchSetting(kReactive, "reactive", true,
                  "raises the current sample's weight by RepriseFrame::reactive", "Karis 2014"),
    switchSetting(kRejectedBlur, "rejected_blur", false,
                  "where history is rejected, shows the 3x3 mean instead of the bare sample",
                  "Lopez 2022"),
    integerSetting(kSpatialFrames, "spatial_frames", 2, 0, 16, "samples",
                   "antialiases along edges of the current frame until this many samples are in",
                   "Lopez 2022 (camera cuts); experiment: README.md", kRebuild),
    choiceSetting(kOffscreen, "offscreen", 0, kOffscreenNames,
                  "history that lies outside the frame: none, or the border's, still bounded",
                  "Yang, Liu, Salvi 2020"),
    integerSetting(kStillFrames, "still_frames", 512, 0, 2048, "samples",
                   "where nothing moves the running mean goes on to this many samples; 0: alpha "
                   "bounds it there as well",
                   "Yang et al. 2009, stationary view", kRebuild),
    numberSetting(kGammaStill, "gamma_still", 8.0, 0.0, 16.0, "standard deviations",
                  "half-size of the bound where nothing moves; tight bounds stop convergence",
                  "experiment: README.md, still views"),
    integerSetting(
        kAverage, "average", 0, 0, 6, "frames",
        "0: exponential history. n >= 2: the mean of the last n raw frames, reprojected, "
        "without feedback; clip, clip_space, gamma, input_filter and depth settings apply",
        "Valient 2014 (Guerrilla); Jimenez 2016", kRebuild),
    numberSetting(kSharpen, "sharpen", 0.0, 0.0, 1.0, "",
                  "contrast-adaptive sharpening of the output (not of history); 0 is off, 1 the "
                  "strongest that does not clip",
                  "AMD RCAS 2021", kRebuild),
    switchSetting(
        kDither, "dither", true,
        "stores history with stochastic rounding, so that small steps of long means are not "
        "lost to half precision",
        "experiment: README.md, still views"),
});
const std::array<RepriseSettingInfo, kSettingCount> kSettings = kTable;

namespace {

constexpr RepriseSettingValue kFast[] = {
    {"clip", 0.0, "cross"},      {"clip_toward", 0.0, "clamp"},    {"clip_space", 0.0, "rgb"},
    {"depth_test", 0.0, "none"}, {"spatial_frames", 0.0, nullptr}, {"dither", 0.0, "false"},
};

}  // namespace

const ReprisePresetInfo kPresets[] = {
    {"fast", kFast, static_cast<uint32_t>(std::size(kFast)), "half the cost of the defaults"},
};
const uint32_t kPresetCount = static_cast<uint32_t>(std::size(kPresets));

}  // namespace reprise::taa
