// SPDX-License-Identifier: MIT
//
// Table 2, its plot and its maps: time by the number of lights.
#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "lab/paper/cold_programs.h"
#include "lab/paper/cpst/experiments.h"
#include "lab/paper/cpst/subjects.h"

namespace reprise::lab::cpst {
namespace {

struct Column {
  uint32_t lamps;
  double ps_ms, cbr_ms, cpst_ms;
};
constexpr Column kPublished[] = {{32, 2.65, 2.56, 2.52},
                                 {64, 3.2, 2.91, 2.78},
                                 {128, 4.53, 3.86, 3.32},
                                 {256, 9.07, 7.16, 5.4},
                                 {512, 17.95, 13.66, 9.48}};

// Lights of each tile, row by row.
Surface tileMap(uint32_t lamps, const LightTiles& tiles) {
  Surface map{fmt::format("{} lights", lamps), {}, {}, {}};
  for (uint32_t x = 0; x < tiles.tiles().width; ++x) map.x.push_back(x);
  for (uint32_t y = 0; y < tiles.tiles().height; ++y) map.y.push_back(y);
  for (const uint32_t count : tiles.counts()) map.z.push_back(count);
  return map;
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) /
         static_cast<double>(std::max<size_t>(values.size(), 1));
}

void claimAt512(Outcome& outcome, const std::string& what, const Cost& ours, const Cost& other,
                double published, double most) {
  const double whole = ours.total_ms / other.total_ms;
  outcome.claim("512 lights, frame of CPS-T over " + what, published, whole, "times",
                fmt::format("at most {}", most), whole <= most);
  const double shaded =
      (ours.lighting_ms + ours.resolve_ms) / (other.lighting_ms + other.resolve_ms);
  outcome.report("512 lights, lighting and resolve of CPS-T over " + what, std::nullopt, shaded,
                 "times");
  outcome.report("512 lights, lighting of CPS-T over " + what, std::nullopt,
                 ours.lighting_ms / other.lighting_ms, "times");
  outcome.report("512 lights, evaluations of CPS-T over " + what, std::nullopt,
                 ours.evaluations_per_pixel / other.evaluations_per_pixel, "times");
}

}  // namespace

void table2(PaperLab& lab, Outcome& outcome) {
  const Subject& subject = sponza();
  if (!subject.note.empty()) outcome.note(subject.note);
  const VkExtent2D extent = timedExtent(lab);
  std::vector<double> lamps;
  std::vector<std::vector<double>> published(3);
  std::vector<std::vector<double>> measured(3);
  std::vector<std::vector<std::string>> lines(3);
  for (size_t i = 0; i < 3; ++i) lines[i].push_back(timed()[i].name);
  std::vector<Surface> maps;
  std::vector<std::string> columns = {"published / measured, ms"};
  for (const Column& column : kPublished) {
    lamps.push_back(column.lamps);
    columns.push_back(fmt::format("{} lights", column.lamps));
    BareScene scene(lab, subject.run, extent, timedFrames(lab), column.lamps, 60.0, kWorkloadReach);
    std::vector<Cost> costs;
    for (const SequenceRun& run : scene.timedRuns()) costs.push_back(costOf(run));
    for (size_t i = 0; i < 3; ++i) {
      published[i].push_back(i == 0 ? column.ps_ms : i == 1 ? column.cbr_ms : column.cpst_ms);
      measured[i].push_back(costs[i].total_ms);
      lines[i].push_back(fmt::format("{:.2f} / {:.0f}", published[i].back(), costs[i].total_ms));
    }
    maps.push_back(tileMap(column.lamps, scene.source().renderer().lightTiles()));
    const std::string of = fmt::format("{} lights", column.lamps);
    outcome.report(of + ", lights a tile", std::nullopt, mean(maps.back().z), "");
    const double of_ps = column.cpst_ms / column.ps_ms;
    const double of_cbr = column.cpst_ms / column.cbr_ms;
    const bool most = column.lamps == 512;
    outcome.report(of + ", lighting's share of PS's frame",
                   most ? std::optional(kPublishedShareOfLighting) : std::nullopt,
                   costs[0].lighting_ms / costs[0].total_ms, "");
    if (most) {
      claimAt512(outcome, "PS", costs[2], costs[0], of_ps, kMostFrameOfPs);
      claimAt512(outcome, "CBR", costs[2], costs[1], of_cbr, kMostFrameOfCbr);
    } else {
      outcome.report(of + ", frame of CPS-T over PS", of_ps, costs[2].total_ms / costs[0].total_ms,
                     "times");
      outcome.report(of + ", frame of CPS-T over CBR", of_cbr,
                     costs[2].total_ms / costs[1].total_ms, "times");
    }
  }
  outcome.report("PS's frame, 512 lights over 32", published[0].back() / published[0].front(),
                 measured[0].back() / measured[0].front(), "times");
  outcome.note(fmt::format(
      "Lamps reach {:g} times as far as scenes have it by themselves: the shortest reach "
      "at which lighting has the published share of PS's frame (item \"time by price\").",
      kWorkloadReach));
  // What the shader does once each light costs: the paper's regime, which the frame's other passes
  // hide on a CPU driver.
  outcome.note(
      "Evaluations times lights of their tile stand as evaluations do: all methods shade under the "
      "same tiles. Where lights dominate a frame, its time follows them; on a CPU driver "
      "visibility "
      "and shadows are most of a frame, whatever the shading rate.");
  outcome.table("Frame time by the number of lights", columns, lines);
  std::vector<Series> here;
  std::vector<Series> there;
  for (size_t i = 0; i < 3; ++i) {
    here.push_back({timed()[i].name, lamps, measured[i], false});
    there.push_back({timed()[i].name, lamps, published[i], false});
  }
  const auto text = [](const char* title) {
    return PlotText{.title = title, .x = "lights", .y = "frame, ms", .log_x = true, .log_y = true};
  };
  outcome.linePlot(text("Measured"), here);
  outcome.linePlot(text("Published"), there);
  outcome.heatMaps({"Lights of each tile", "tile", "tile", "lights"}, maps);
  noteColdPrograms(lab, outcome);
  outcome.note(fmt::format(
      "Published: Sponza at 1920 x 1080 on a GTX 1080, up to 32 lights and more a tile; here {} x "
      "{}. All methods take turns frame by frame.",
      extent.width, extent.height));
}

}  // namespace reprise::lab::cpst
