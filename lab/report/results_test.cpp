// SPDX-License-Identifier: MIT
#include "lab/report/results.h"

#include <gtest/gtest.h>

#include <limits>

#include "lab/capture/capture_error.h"
#include "lab/report/results_table.h"

namespace reprise::lab {
namespace {

Results sampleResults() {
  Results results;
  results.command = "reprise compare";
  results.device = "device";
  for (const auto& [technique, psnr] :
       {std::pair{"none", 20.0}, {"taa:alpha=0.1,clip=none", 30.0}}) {
    RunResult run;
    run.source = "brick/pan";
    run.technique = technique;
    run.settings = {{"alpha", 0.1}, {"clip", "none"}};
    run.reference_samples = 64;
    run.reference_filter = "box";
    FrameFigures frame;
    frame.psnr = psnr;
    frame.tpsnr = std::numeric_limits<double>::quiet_NaN();
    run.figures.frames = {frame};
    MeanFigures mean;
    mean.frames = 1;
    mean.psnr = psnr;
    mean.flip = 1.0 / psnr;
    run.figures.mean = mean;
    run.cost.passes_ms = {{"resolve", 1.5}};
    run.cost.median_ms = 1.5;
    run.cost.history_bytes = 1 << 20;
    results.runs.push_back(run);
  }
  return results;
}

TEST(Results, JsonHasTheDocumentedShape) {
  const OrderedJson json = resultsJson(sampleResults());
  EXPECT_EQ(json["version"], 1);
  const auto& run = json["runs"][1];
  EXPECT_EQ(run["settings"]["clip"], "none");
  EXPECT_EQ(run["reference"]["filter"], "box");
  EXPECT_EQ(run["mean"]["psnr"], 30.0);
  EXPECT_TRUE(run["still"].is_null());
  EXPECT_TRUE(run["frames"][0]["tpsnr"].is_null());  // no NaN in JSON
  EXPECT_EQ(run["cost"]["gpu_ms"]["passes"]["resolve"], 1.5);
  EXPECT_EQ(run["cost"]["history_bytes"], 1 << 20);
  EXPECT_TRUE(nlohmann::json::accept(json.dump()));
}

TEST(Results, CsvQuotesNamesAndLeavesUndefinedCellsEmpty) {
  const std::string csv = resultsCsv(sampleResults());
  EXPECT_NE(csv.find("\"brick/pan\",\"taa:alpha=0.1,clip=none\",0,0,0,30,,,,,,,,\n"),
            std::string::npos)
      << csv;
}

TEST(Results, TableStarsTheBest) {
  const std::string table = resultsTable(sampleResults());
  EXPECT_NE(table.find("30.00*"), std::string::npos) << table;
  EXPECT_EQ(table.find("20.00*"), std::string::npos);
  EXPECT_NE(table.find("0.0333*"), std::string::npos);  // FLIP: less is better
}

TEST(Baseline, FallsAreFailuresAndRisesAreNot) {
  const Results now = sampleResults();
  OrderedJson before = resultsJson(now);
  EXPECT_TRUE(checkBaseline(now, before.dump(), "b.json", 0.0).failures.empty());
  before["runs"][0]["mean"]["psnr"] = 20.05;
  before["runs"][1]["mean"]["psnr"] = 25.0;
  EXPECT_TRUE(checkBaseline(now, before.dump(), "b.json", 0.1).failures.empty());
  EXPECT_EQ(checkBaseline(now, before.dump(), "b.json", 0.01).failures.size(), 1u);
  before["runs"][0]["technique"] = "gone";
  EXPECT_EQ(checkBaseline(now, before.dump(), "b.json", 0.1).failures.size(), 1u);
  for (const char* text : {"{", "[]", "{}", R"({"runs":[3]})", R"({"runs":[{"source":"a"}]})",
                           R"({"runs":[{"source":"a","technique":"b"}]})"}) {
    EXPECT_THROW(checkBaseline(now, text, "b.json", 0.1), CaptureError) << text;
  }
}

}  // namespace
}  // namespace reprise::lab
