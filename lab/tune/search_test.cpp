// SPDX-License-Identifier: MIT
//
// The search against functions whose best point is known.
#include "lab/tune/search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

namespace reprise::lab {
namespace {

const char* const kForms[] = {"round", "square", "oval", nullptr};
const RepriseSettingInfo kSettings[] = {
    {"width", REPRISE_SETTING_FLOAT, 0.01, 100.0, 1.0, nullptr, "", "", "", 0},
    {"frames", REPRISE_SETTING_INTEGER, 0.0, 64.0, 3.0, nullptr, "", "", "", 0},
    {"form", REPRISE_SETTING_CHOICE, 0.0, 2.0, 0.0, kForms, "", "", "", 0},
    {"even", REPRISE_SETTING_BOOLEAN, 0.0, 1.0, 0.0, nullptr, "", "", "", 0},
};
const RepriseTechniqueInfo kTechnique = {
    .name = "drawn",
    .summary = "",
    .source = "",
    .flags = 0,
    .settings = kSettings,
    .setting_count = 4,
    .presets = nullptr,
    .preset_count = 0,
};

std::vector<TunedSetting> all() {
  std::vector<TunedSetting> settings;
  for (const char* name : {"width", "frames", "form", "even"}) {
    settings.push_back(parseTunedSetting(kTechnique, name));
  }
  return settings;
}

// Best, 0, at width 9, 20 frames, "oval", even; width and frames do not act apart.
double score(const std::vector<double>& v) {
  const double width = std::log(v[0] / 9.0), frames = std::log((v[1] + 1.0) / 21.0);
  return -width * width - frames * frames - 0.8 * width * frames - (v[2] == 2.0 ? 0.0 : 0.3) -
         (v[3] == 1.0 ? 0.0 : 0.2);
}

TEST(Search, FindsTheBestOfEveryKindOfSetting) {
  std::vector<double> scores;
  const SearchResult found =
      searchSettings(all(), {1.0, 3.0, 0.0, 0.0}, score, {.least_gain = 1e-4},
                     [&](const SearchStep& step) { scores.push_back(step.score); });
  EXPECT_TRUE(found.ended);
  EXPECT_NEAR(found.best.values[0], 9.0, 1.0);
  EXPECT_NEAR(found.best.values[1], 20.0, 2.0);
  EXPECT_EQ(found.best.values[2], 2.0);
  EXPECT_EQ(found.best.values[3], 1.0);
  ASSERT_GE(scores.size(), 3u);
  EXPECT_EQ(scores.front(), found.start.score);
  EXPECT_EQ(scores.back(), found.best.score);
  for (size_t i = 1; i < scores.size(); ++i) EXPECT_GT(scores[i], scores[i - 1]);
}

TEST(Search, NeverScoresAPointTwiceNorBeyondItsEvaluations) {
  std::set<std::vector<double>> seen;
  const auto counted = [&](const std::vector<double>& values) {
    EXPECT_TRUE(seen.insert(values).second);
    return score(values);
  };
  const SearchResult found =
      searchSettings(all(), {1.0, 3.0, 0.0, 0.0}, counted, {.evaluations = 12}, nullptr);
  EXPECT_FALSE(found.ended);
  EXPECT_EQ(found.evaluations, 12u);
  EXPECT_EQ(seen.size(), 12u);
}

TEST(Search, StaysInsideTheRangeAndLeavesZero) {
  const std::vector<TunedSetting> settings = {parseTunedSetting(kTechnique, "width=0.5:4"),
                                              parseTunedSetting(kTechnique, "frames")};
  const auto inside = [&](const std::vector<double>& v) {
    EXPECT_GE(v[0], 0.5);
    EXPECT_LE(v[0], 4.0);
    return std::log(v[0]) + v[1] / 64.0;
  };
  const SearchResult found =
      searchSettings(settings, {1.0, 0.0}, inside, {.least_gain = 1e-4}, nullptr);
  EXPECT_EQ(found.best.values, (std::vector<double>{4.0, 64.0}));
}

TEST(Search, AScoreThatIsNoNumberLoses) {
  const auto holes = [](const std::vector<double>& v) {
    return v[0] < 1.5 ? std::numeric_limits<double>::quiet_NaN() : -std::abs(v[0] - 2.0);
  };
  const SearchResult found = searchSettings({parseTunedSetting(kTechnique, "width")}, {1.0}, holes,
                                            SearchOptions{}, nullptr);
  EXPECT_EQ(found.best.values[0], 2.0);
}

TEST(Search, GainsThatAreTooSmallAreLeft) {
  const auto slope = [](const std::vector<double>& v) { return 0.001 * std::log2(v[0]); };
  const std::vector<TunedSetting> settings = {parseTunedSetting(kTechnique, "width")};
  EXPECT_EQ(searchSettings(settings, {1.0}, slope, {.least_gain = 0.005}, nullptr).best.values[0],
            1.0);
  EXPECT_EQ(searchSettings(settings, {1.0}, slope, {.least_gain = 1e-6}, nullptr).best.values[0],
            100.0);
}

TEST(Search, WrongNamesAndRangesAreSaid) {
  for (const char* text : {"widht", "width=4", "width=4:2", "width=0:2", "width=1:1e9", "width=a:b",
                           "form=0:1", "", "width=1:nan"}) {
    EXPECT_THROW(parseTunedSetting(kTechnique, text), std::invalid_argument) << text;
  }
  try {
    parseTunedSetting(kTechnique, "widht");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("near: 'width'"), std::string::npos) << error.what();
  }
  EXPECT_EQ(parseTunedSetting(kTechnique, "width=:4").minimum, 0.01);
}

TEST(Search, SettingsReadAsTheyAreWritten) {
  EXPECT_EQ(settingText(kSettings[0], 0.125), "0.125");
  EXPECT_EQ(settingText(kSettings[1], 12.0), "12");
  EXPECT_EQ(settingText(kSettings[2], 1.0), "square");
  EXPECT_EQ(settingText(kSettings[3], 1.0), "true");
}

}  // namespace
}  // namespace reprise::lab
