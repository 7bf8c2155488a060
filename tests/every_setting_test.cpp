// SPDX-License-Identifier: MIT
//
// Every choice and both ends of every range of every setting: prepares, runs under validation, and
// keeps a constant image constant. Whether a setting does what it says is for its technique's own
// tests.
#include <gtest/gtest.h>

#include <cmath>

#include "formula_source.h"
#include "test_device.h"

namespace reprise::lab {
namespace {

std::vector<std::string> values(const RepriseSettingInfo& setting) {
  std::vector<std::string> all;
  if (setting.type == REPRISE_SETTING_CHOICE) {
    for (uint32_t i = 0; setting.choices[i] != nullptr; ++i) all.emplace_back(setting.choices[i]);
  } else if (setting.type == REPRISE_SETTING_BOOLEAN) {
    all = {"false", "true"};
  } else {
    char text[64];
    for (const double value : {setting.minimum, setting.maximum}) {
      std::snprintf(text, sizeof(text), "%.9g", value);
      all.emplace_back(text);
    }
  }
  return all;
}

class EverySetting : public testing::TestWithParam<std::string> {};

TEST_P(EverySetting, RunsAtEveryChoiceAndBothEnds) {
  const RepriseTechniqueInfo& info = *repriseFindTechnique(GetParam().c_str());
  Formula formula;
  formula.color = [](float, float) { return Rgb{0.3f, 0.6f, 0.1f}; };
  formula.velocity_px[0] = 0.4f;
  FormulaSource source(testDevice(), {19, 13}, formula);
  for (uint32_t i = 0; i < info.setting_count; ++i) {
    for (const std::string& value : values(info.settings[i])) {
      const std::string choice = GetParam() + ":" + info.settings[i].name + "=" + value;
      SCOPED_TRACE(choice);
      Resolver r(testDevice(), parseTechnique(choice), source.info());
      const FloatImage image = resolveFrames(r, source, 4);
      for (size_t k = 0; k < image.texelCount(); ++k) {
        ASSERT_NEAR(image.texels[4 * k], 0.3f, 0.002f);
        ASSERT_NEAR(image.texels[4 * k + 1], 0.6f, 0.003f);
      }
      expectNoValidationMessages();
    }
  }
}

std::vector<std::string> libraryTechniques() {
  std::vector<std::string> names;
  for (uint32_t i = 0; i < repriseGetTechniqueCount(); ++i)
    names.emplace_back(repriseGetTechnique(i)->name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(All, EverySetting, testing::ValuesIn(libraryTechniques()),
                         [](const auto& test) {
                           std::string name = test.param;
                           for (char& c : name) {
                             if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
                           }
                           return name;
                         });

}  // namespace
}  // namespace reprise::lab
