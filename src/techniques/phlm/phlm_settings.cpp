// SPDX-License-Identifier: MIT
//
// The settings of `phlm`. Where a default is not the paper's, its source says so; preset `paper` is
// the method as published.
#include "techniques/phlm/phlm_settings.h"

namespace reprise::phlm {
namespace {

constexpr const char* kStorageNames[] = {"paper", "symmetric", "half", "packed", nullptr};
constexpr const char* kOriginNames[] = {"zero", "feature", nullptr};
constexpr const char* kJitterNames[] = {"none", "always", "still", nullptr};
constexpr const char* kInputNames[] = {"rendered", "fxaa", nullptr};
constexpr const char* kUpdateNames[] = {"all", "half", "quarter", nullptr};
constexpr const char* kPassesNames[] = {"split", "fused", nullptr};
constexpr const char* kSpaceNames[] = {"linear", "compressed", nullptr};
constexpr const char* kForgettingNames[] = {"constant", "contrast", nullptr};
constexpr const char* kClipNames[] = {"reset", "shift", nullptr};
constexpr const char* kBoxNames[] = {"square", "rounded", "variance", nullptr};
constexpr const char* kBoxSpaceNames[] = {"rgb", "ycocg", nullptr};
constexpr const char* kBoxFeatureNames[] = {"never", "still", "always", nullptr};
constexpr const char* kFilterNames[] = {"bilinear", "catmull-rom", nullptr};
constexpr const char* kDilationNames[] = {"none", "cross", nullptr};
constexpr const char* kWeightNames[] = {"new", "old", nullptr};
constexpr const char* kLowPassNames[] = {"none", "tent", "box", nullptr};
constexpr const char* kBilinearNames[] = {"shader", "hardware", nullptr};

constexpr const char* kPaper = "Iglesias-Guitian et al. 2016";
constexpr uint32_t kRebuild = 1;

}  // namespace

constexpr std::array<RepriseSettingInfo, kSettingCount> kTable = settingTable({
    choiceSetting(
        kStorageForm, "storage", 2, kStorageNames,
        "how a model is kept: 16 + 12 floats (112 bytes a pixel); the 22 distinct numbers "
        "as floats (88) or halves (44 to 48); or 256 bits (32)",
        "Iglesias-Guitian et al. 2016: paper; experiment: effects.md, storage"),
    choiceSetting(kModelOrigin, "origin", 1, kOriginNames,
                  "the feature at which a stored model's intercept is its colour: 0, or the "
                  "pixel's own, which mixes neighbours' predictions instead of their lines, and "
                  "needs fewer bits. Half and packed models are about the pixel's own",
                  "Iglesias-Guitian et al. 2016: zero; experiment: effects.md"),
    choiceSetting(kJitter, "jitter", 2, kJitterNames,
                  "when samples move about the pixel: never, in every frame, or only while the "
                  "camera of the last two frames rests (without cameras: always)",
                  "Iglesias-Guitian et al. 2016: still; experiment: effects.md", 0),
    integerSetting(kJitterLength, "jitter_length", 64, 1, 1024, "frames",
                   "length of the R2 cycle of sample positions over the pixel, centred",
                   "experiment: effects.md"),
    choiceSetting(kInput, "input", 0, kInputNames,
                  "what is filtered: the frame as rendered, or antialiased by FXAA first",
                  "Iglesias-Guitian et al. 2016, section 7.1"),
    numberSetting(
        kInputWidth, "input_width", 0.58, 0.0, 1.0, "px",
        "deviation of a Gaussian that reconstructs the frame at the pixel's centre from the "
        "nine samples around it, by their jittered places, where something moves; 0: the pixel's "
        "own sample",
        "Karis 2014; experiment: effects.md"),
    choiceSetting(kUpdateShare, "update", 0, kUpdateNames,
                  "the share of models that learn from a frame, in turn; the others predict. Fewer "
                  "adapt more slowly",
                  "Iglesias-Guitian et al. 2016, future work"),
    choiceSetting(kPasses, "passes", 1, kPassesNames,
                  "feature and filter as two passes, as published, or as one that reads the "
                  "neighbourhood once",
                  "experiment: effects.md, time"),
    choiceSetting(kSpace, "space", 1, kSpaceNames,
                  "what is modelled in motion: light, or c / (1 + luma), which bounds what one "
                  "bright sample can do and darkens thin highlights",
                  "Karis 2014; experiment: effects.md"),
    numberSetting(kLambda, "lambda", 0.9, 0.5, 1.0, "",
                  "weight of the past in each frame; lower follows change faster and averages less",
                  "Iglesias-Guitian et al. 2016: 0.998; experiment: effects.md"),
    choiceSetting(kForgetting, "forgetting", 1, kForgettingNames,
                  "whether 1 - lambda is the same everywhere, or half of that where sample and "
                  "prediction have one luma and up to twice where they differ",
                  "Pedersen 2016; Fortescue, Kershenbaum, Ydstie 1981; experiment: effects.md"),
    numberSetting(kInitialVariance, "initial_variance", 1.0, 0.01, 1000.0, "variances of a sample",
                  "of a fresh model's colour, before its first sample is counted: large leaves "
                  "about 1 of it, 1 counts that sample twice",
                  "Iglesias-Guitian et al. 2016: 1000; experiment: effects.md"),
    numberSetting(
        kSlopeVariance, "slope_variance", 1000.0, 0.0, 1000.0, "variances of a sample",
        "of a fresh model's slopes: large trusts the feature at once, 0 makes the model a "
        "running mean",
        "Iglesias-Guitian et al. 2016: 1000; experiment: effects.md"),
    numberSetting(kVarianceLimit, "variance_limit", 1000.0, 0.1, 10000.0, "variances of a sample",
                  "no variance winds up beyond this where the feature does not vary", kPaper),
    choiceSetting(
        kClipModel, "clip", 1, kClipNames,
        "a prediction outside the box: the model forgets all but the colour where the ray "
        "meets it, or keeps its slopes and only moves there",
        "Iglesias-Guitian et al. 2016: reset; experiment: effects.md"),
    numberSetting(kClipVariance, "clip_variance", 0.1, 0.0, 1000.0, "variances of a sample",
                  "of the colour at the box: v weighs the current sample v / (v + 1)",
                  "Iglesias-Guitian et al. 2016: 1000; experiment: effects.md"),
    choiceSetting(kBoxShape, "box", 0, kBoxNames,
                  "bound of believable predictions from the 3x3 neighbourhood: its extremes, the "
                  "mean of its and the cross's, or mean and standard deviations",
                  "Iglesias-Guitian et al. 2016: square"),
    choiceSetting(kBoxSpace, "box_space", 1, kBoxSpaceNames, "axes of the box",
                  "Iglesias-Guitian et al. 2016: either"),
    numberSetting(kBoxGamma, "box_gamma", 1.0, 0.0, 8.0, "standard deviations",
                  "half-size of the variance box", "Salvi 2016: 0.75 to 1.25"),
    numberSetting(kBoxStill, "box_still", 4.0, 0.0, 64.0, "",
                  "factor on the box's size where nothing moves; 0: no box there. A tight box ends "
                  "convergence, none lets what only shading moves ghost",
                  "experiment: effects.md"),
    choiceSetting(kBoxHolds, "box_feature", 2, kBoxFeatureNames,
                  "when the box also holds the temporal feature, which has seen lines thinner than "
                  "a pixel where the neighbourhood is flat, and forgets shadows that have gone",
                  "experiment: effects.md"),
    choiceSetting(
        kModelFilter, "history_filter", 1, kFilterNames,
        "how the colour of a model is read between pixels; slopes and their variances always "
        "bilinearly. With origin=zero bilinear",
        "Iglesias-Guitian et al. 2016: bilinear; experiment: effects.md"),
    choiceSetting(kDilate, "dilation", 1, kDilationNames,
                  "whose motion a pixel takes: its own, or the closest surface's in the cross",
                  "Karis 2014; experiment: effects.md"),
    numberSetting(
        kDepthTolerance, "depth_tolerance", 0.0, 0.0, 1.0, "relative",
        "largest difference of depths that still is the same surface; 0: no test, the box "
        "alone decides",
        "Nehab et al. 2007; experiment: effects.md"),
    numberSetting(kFeatureA, "feature_a", 0.125, 0.0, 16.0, "",
                  "adaptation of the temporal feature at rest", kPaper),
    numberSetting(kFeatureB, "feature_b", 0.25, 0.0, 16.0, "a px a frame",
                  "how much faster it adapts in motion", kPaper),
    numberSetting(kFeatureFloor, "feature_floor", 0.02, 0.0, 1.0, "",
                  "its least adaptation: without one it freezes where it lies on the range's end",
                  "experiment: effects.md"),
    choiceSetting(
        kFeatureWeighs, "feature_weighs", 0, kWeightNames,
        "whether the published alpha weighs the new low-passed colour or the old feature, "
        "which the text leaves open",
        "experiment: effects.md"),
    choiceSetting(kFeatureLowPass, "low_pass", 2, kLowPassNames,
                  "the feature's filter in space: none, 1 2 1 or 1 1 1 each way",
                  "Iglesias-Guitian et al. 2016 name none"),
    integerSetting(kStillFrames, "still_frames", 512, 0, 2048, "samples",
                   "where nothing moves the model is a running mean of up to this many; 0: it "
                   "learns as in motion",
                   "Iglesias-Guitian et al. 2016, section 5.2; Yang et al. 2009", kRebuild),
    choiceSetting(
        kBilinear, "bilinear", 1, kBilinearNames,
        "models between pixels: texel by texel with exact weights, or by the sampler where "
        "the device filters the format",
        "Iglesias-Guitian et al. 2016: hardware"),
});
const std::array<RepriseSettingInfo, kSettingCount> kSettings = kTable;

namespace {

constexpr RepriseSettingValue kPaperValues[] = {
    {"storage", 0.0, "paper"},
    {"origin", 0.0, "zero"},
    {"jitter", 0.0, "still"},
    {"input_width", 0.0, nullptr},
    {"passes", 0.0, "split"},
    {"space", 0.0, "linear"},
    {"lambda", 0.998, nullptr},
    {"forgetting", 0.0, "constant"},
    {"initial_variance", 1000.0, nullptr},
    {"slope_variance", 1000.0, nullptr},
    {"clip", 0.0, "reset"},
    {"clip_variance", 1000.0, nullptr},
    {"box", 0.0, "square"},
    {"box_space", 0.0, "rgb"},
    {"box_still", 0.0, nullptr},
    {"box_feature", 0.0, "never"},
    {"history_filter", 0.0, "bilinear"},
    {"dilation", 0.0, "cross"},
    {"feature_a", 0.125, nullptr},
    {"feature_b", 0.25, nullptr},
    {"feature_floor", 0.05, nullptr},
    {"low_pass", 0.0, "tent"},
};

constexpr RepriseSettingValue kSharpValues[] = {
    {"input_width", 0.4, nullptr},
};

}  // namespace

const ReprisePresetInfo kPresets[] = {
    {"paper", kPaperValues, static_cast<uint32_t>(std::size(kPaperValues)),
     "the method and the storage as published"},
    {"sharp", kSharpValues, static_cast<uint32_t>(std::size(kSharpValues)),
     "a narrower input filter: nearer to the reference and up to twice the flicker"},
};
const uint32_t kPresetCount = static_cast<uint32_t>(std::size(kPresets));

}  // namespace reprise::phlm
