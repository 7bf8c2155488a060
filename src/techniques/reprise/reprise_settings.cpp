// SPDX-License-Identifier: MIT
//
// The settings of `reprise`. Defaults come from the experiments in README.md.
#include "techniques/reprise/reprise_settings.h"

namespace reprise::reprise_technique {

constexpr std::array<RepriseSettingInfo, kSettingCount> kTable = settingTable({
    integerSetting(kJitterLength, "jitter_length", 16, 1, 1024, "frames",
                   "length of the R2 cycle of sample positions", "as taa"),
    numberSetting(kSampleWidth, "sample_width", 0.3, 0.05, 4.0, "px",
                  "how far a sample reaches over its pixel's four history texels (standard "
                  "deviation of a Gaussian); wider is steadier, narrower sharper",
                  "experiment: README.md"),
    numberSetting(kHistory, "history", 4.0, 0.0, 64.0, "samples",
                  "samples a texel's mean goes on to in motion; a frame brings about half a one",
                  "experiment: README.md"),
    numberSetting(kStillHistory, "still_history", 256.0, 0.0, 1024.0, "samples",
                  "the same where nothing moves", "Yang et al. 2009, stationary view"),
    numberSetting(kSharpness, "sharpness", 0.95, 0.0, 1.0, "",
                  "share of Lanczos with three lobes in what moves history; the rest is bilinear",
                  "Duchon 1979; experiment: README.md"),
    numberSetting(kDepthTolerance, "depth_tolerance", 0.06, 0.0001, 1.0, "relative",
                  "how much farther than a tap the current surface's plane may be there",
                  "experiment: README.md"),
    numberSetting(kBound, "bound", 3.0, 0.0, 1000.0, "standard deviations",
                  "half-size of the bound of history without evidence of change; wider keeps more "
                  "history and more ghosts",
                  "experiment: README.md"),
    numberSetting(kBoundFaint, "bound_faint", 40.0, 0.0, 1000.0, "standard deviations",
                  "the same where content is faint: texture of little contrast that aliases",
                  "experiment: README.md"),
    numberSetting(kBoundChanged, "bound_changed", 1.0, 0.0, 1000.0, "standard deviations",
                  "the same with full evidence", "Salvi 2016: 0.75 to 1.25"),
    numberSetting(kBoundStill, "bound_still", 8.0, 0.0, 1000.0, "standard deviations",
                  "the same at rest, without evidence", "as taa"),
    numberSetting(kHistoryUncovered, "history_uncovered", 1.0, 0.0, 1.0e6, "samples",
                  "what history counts for where it may be what a silhouette left, over the share "
                  "that may be",
                  "experiment: README.md"),
    numberSetting(
        kBoundApart, "bound_apart", 1.0, 0.0, 1000.0, "standard deviations",
        "the same where neighbours move apart by a pixel or two a frame: what a silhouette "
        "mixed is no more",
        "experiment: README.md"),
    numberSetting(kFlips, "flips", 4.0, 0.0, 1000.0, "",
                  "how many of the residuals that turn their sign from frame to frame the bound "
                  "lets pass: what aliases to one colour; 0: none",
                  "experiment: README.md"),
    integerSetting(kFarFrames, "far_frames", 12, 0, 15, "frames",
                   "how long what lay farthest at a pixel counts as seen there; keeps history "
                   "between leaves and wires",
                   "experiment: README.md"),
    numberSetting(kForgetClipped, "forget_clipped", 1.0, 0.0, 1.0, "",
                  "how much of its samples a fully clipped texel loses", "experiment: README.md"),
    numberSetting(kForgetChanged, "forget_changed", 1.0, 0.0, 1.0, "",
                  "how much of its samples a texel loses whose change is fully believed",
                  "experiment: README.md"),
    numberSetting(kTone, "tone", 0.1, 0.0, 16.0, "1 / luma",
                  "how much less bright samples weigh in motion; more flickers less and is darker",
                  "Karis 2014: 1; experiment: README.md"),
    numberSetting(
        kDoubtLight, "doubt_light", 1.0, 0.0, 1.0e6, "variances",
        "how strong light must change over tens of pixels to be followed; 1e6 follows nothing",
        "experiment: README.md"),
    numberSetting(kDoubtNow, "doubt_now", 3.0, 0.0, 1.0e6, "variances",
                  "how strong the residual of 3x3 must be in one frame to act at once",
                  "experiment: README.md"),
    numberSetting(kDoubtMean, "doubt_mean", 2.0, 0.0, 1.0e6, "variances",
                  "how strong the mean residual of the last frames must be to be followed",
                  "experiment: README.md"),
});
const std::array<RepriseSettingInfo, kSettingCount> kSettings = kTable;

}  // namespace reprise::reprise_technique
