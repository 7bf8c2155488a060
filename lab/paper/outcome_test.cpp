// SPDX-License-Identifier: MIT
#include "lab/paper/outcome.h"

#include <gtest/gtest.h>

#include <limits>

#include "lab/paper/crop.h"
#include "lab/paper/paper.h"
#include "lab/paper/paper_page.h"

namespace reprise::lab {
namespace {

Outcome sampleOutcome() {
  Outcome outcome;
  outcome.claim("brick moving", 31.96, 33.0, "dB", "above 4x4", true);
  outcome.report("brick none", std::nullopt, std::numeric_limits<double>::quiet_NaN(), "dB");
  outcome.linePlot({"title", "x", "y"}, {{"series", {0.0, 1.0}, {2.0, 3.0}, false}});
  outcome.gallery("pictures", {{"one", FloatImage(4, 3, 3)}, {"two", FloatImage(4, 3, 3)}});
  outcome.table("table", {"a", "b"}, {{"</script><script>", "2"}});
  return outcome;
}

TEST(Outcome, RowsHaveTheDocumentedShape) {
  const Outcome outcome = sampleOutcome();
  const OrderedJson row = rowJson("figure 14", outcome.rows()[0]);
  EXPECT_EQ(row.dump(),
            R"({"item":"figure 14","row":"brick moving","published":31.96,"measured":33.0,)"
            R"("unit":"dB","claim":"above 4x4","holds":true})");
  const OrderedJson open = rowJson("figure 14", outcome.rows()[1]);
  EXPECT_TRUE(open["published"].is_null());
  EXPECT_TRUE(open["measured"].is_null());  // no NaN in JSON
  EXPECT_TRUE(open["holds"].is_null());
}

TEST(Outcome, ComesBackFromDisk) {
  Outcome outcome = sampleOutcome();
  const OrderedJson json = outcome.json();
  EXPECT_EQ(Outcome::pictureLabels(json), (std::vector<std::string>{"one", "two"}));
  const Outcome back = Outcome::fromJson(json, outcome.pictures());
  EXPECT_EQ(back.json(), json);
  EXPECT_TRUE(back.complete());
  outcome.lacks("scene horse");
  const Outcome lacking = Outcome::fromJson(outcome.json(), outcome.pictures());
  EXPECT_FALSE(lacking.complete());
  EXPECT_EQ(lacking.notes().back(), "scene horse is not here");
}

TEST(PaperPage, HoldsItsDataAndCannotBeBrokenOutOf) {
  const Paper& paper = paperList().front();
  PaperItem item;
  item.experiment = &paper.experiments.front();
  item.outcome = sampleOutcome();
  const std::string page = paperPage(paper, paper.scale, "reprise paper", {item});
  EXPECT_EQ(page.find("</script><script>\""), std::string::npos);
  EXPECT_NE(page.find("data:image/png;base64,"), std::string::npos);
  for (const char* mark : {"@CSS@", "@OWN_CSS@", "@DATA@", "@D3@", "@TITLE@", "@PLOTS@"}) {
    EXPECT_EQ(page.find(mark), std::string::npos) << mark;
  }
}

TEST(PaperList, ItemsHaveFoldersOfTheirOwn) {
  for (const Paper& paper : paperList()) {
    std::vector<std::string> folders;
    for (const Experiment& experiment : paper.experiments) {
      const std::string folder = itemFolder(experiment.item);
      EXPECT_EQ(folder.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-"),
                std::string::npos)
          << folder;
      EXPECT_EQ(std::count(folders.begin(), folders.end(), folder), 0) << folder;
      folders.push_back(folder);
    }
  }
}

TEST(Crop, FindsTheWorstSquare) {
  FloatImage reference(40, 30, 3);
  FloatImage test = reference;
  for (uint32_t y = 20; y < 24; ++y) {
    for (uint32_t x = 30; x < 34; ++x) test.at(x, y)[1] = 1.0f;
  }
  const CropBox box = worstSquare(reference, test, 10);
  EXPECT_EQ(box.width, 10u);
  EXPECT_LE(box.x, 30u);
  EXPECT_GE(box.x + box.width, 34u);
  EXPECT_LE(box.y, 20u);
  EXPECT_GE(box.y + box.height, 24u);
  const FloatImage part = crop(test, box);
  EXPECT_EQ(part.at(30 - box.x, 20 - box.y)[1], 1.0f);
  EXPECT_EQ(differenceImage(part, crop(reference, box), 0.5f).at(30 - box.x, 20 - box.y)[1], 0.5f);
  // Larger than the image: the image.
  EXPECT_EQ(worstSquare(reference, test, 100).width, 40u);
}

}  // namespace
}  // namespace reprise::lab
