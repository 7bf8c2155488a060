// SPDX-License-Identifier: MIT
// What the page holds; that it works in a browser is tested with the command line.
#include "lab/report/report_page.h"

#include <gtest/gtest.h>

namespace reprise::lab {
namespace {

TEST(ReportImages, DropsEverySecondFrameUntilItFitsAndKeepsTheLast) {
  ReportImages images(100);
  for (uint32_t frame = 0; frame < 16; ++frame) images.add("s", "taa", frame, std::string(20, 'x'));
  EXPECT_EQ(images.bytes(), 320u);
  images.fitBudget();
  EXPECT_LE(images.bytes(), 100u);
  const auto& frames = images.all().at("s").at("taa");
  EXPECT_EQ(frames.size(), 4u);
  EXPECT_TRUE(frames.contains(15));
  // One frame stays, whatever the budget.
  ReportImages large(1);
  large.add("s", "taa", 3, std::string(20, 'x'));
  large.fitBudget();
  EXPECT_EQ(large.all().at("s").at("taa").size(), 1u);
}

TEST(ReportPage, HoldsItsDataAndCannotBeBrokenOutOf) {
  Results results;
  results.command = "reprise compare </script><script>alert(1)</script>";
  RunResult run;
  run.source = "s";
  run.technique = "taa";
  results.runs.push_back(run);
  ReportImages images(1000);
  images.add("s", "taa", 0, "ab");
  const std::string page = reportPage("A <title>", results, images);
  EXPECT_NE(page.find("data:image/png;base64,YWI="), std::string::npos);
  EXPECT_EQ(page.find("</script><script>alert"), std::string::npos);
  EXPECT_NE(page.find("<title>A &lt;title></title>"), std::string::npos);
  for (const char* mark : {"@CSS@", "@DATA@", "@D3@", "@TITLE@"})
    EXPECT_EQ(page.find(mark), std::string::npos);
}

}  // namespace
}  // namespace reprise::lab
