// SPDX-License-Identifier: MIT
#include "lab/run/technique_choice.h"

#include <gtest/gtest.h>

namespace reprise::lab {
namespace {

std::string messageOf(const std::string& text) {
  try {
    parseTechniques({text});
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

TEST(TechniqueChoice, CommasSeparateSettingsAndTechniques) {
  const auto list = parseTechniques({"none,taa:alpha=0.05,clip=variance,ss:n=4", "reprojection"});
  ASSERT_EQ(list.size(), 4u);
  EXPECT_EQ(list[0].label, "none");
  EXPECT_EQ(list[1].label, "taa:alpha=0.05,clip=variance");
  ASSERT_EQ(list[1].settings.size(), 2u);
  EXPECT_EQ(list[1].settings[1].second, "variance");
  EXPECT_EQ(list[2].grid, 4u);
  EXPECT_STREQ(list[2].library->name, "none");
  EXPECT_EQ(list[3].label, "reprojection");
  EXPECT_EQ(parseTechniques({"none taa ss"}).size(), 3u);
  EXPECT_EQ(parseTechnique("taa:preset=fast").preset, "fast");
}

TEST(TechniqueChoice, WrongInputIsOneClearLine) {
  EXPECT_EQ(messageOf("tae"), "there is no technique 'tae'; near: 'taa' (see 'reprise list')");
  EXPECT_EQ(messageOf("taa:alpa=1"),
            "technique 'taa' has no setting 'alpa'; near: 'alpha' (see 'reprise list')");
  EXPECT_EQ(messageOf("taa:alpha=2"),
            "setting 'alpha' of technique 'taa' must be a number in [0.001, 1], not '2'");
  EXPECT_EQ(messageOf("taa:clip=box"),
            "setting 'clip' of technique 'taa' must be one of none, "
            "minmax, rounded, variance, kdop, cross, not 'box'");
  EXPECT_EQ(messageOf("ss:n=0"),
            "setting 'n' of technique 'ss' must be a whole number in [1, 16], not '0'");
  EXPECT_EQ(messageOf("taa:alpha"), "technique 'taa': 'alpha' is not name=value");
  EXPECT_EQ(messageOf("taa:preset=slow"), "technique 'taa' has no preset 'slow'; it has: fast");
  EXPECT_EQ(messageOf("none,none"), "technique 'none' is named twice");
  EXPECT_EQ(messageOf(" "), "no technique is named");
}

// A label that one cannot tell from another would overwrite its files.
TEST(TechniqueChoice, EveryListedTechniqueParsesByItsName) {
  for (const RepriseTechniqueInfo* info : allTechniques()) {
    EXPECT_EQ(parseTechnique(info->name).name, info->name);
  }
}

}  // namespace
}  // namespace reprise::lab
