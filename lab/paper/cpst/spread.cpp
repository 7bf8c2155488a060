// SPDX-License-Identifier: MIT
//
// What the paper names as future work: points of shading and of visibility that fit together within
// one frame. Hardware shades at the coarse pixel's centre even where the triangle does not cover
// it; here it is also shaded at the middle of the pixels that it covers, which extrapolates less.
#include <fmt/format.h>

#include "lab/paper/cpst/experiments.h"
#include "lab/paper/cpst/subjects.h"

namespace reprise::lab::cpst {
namespace {

struct Case {
  std::string name;
  std::string technique;  // shade_at is added to it
};

}  // namespace

void spread(PaperLab& lab, Outcome& outcome) {
  const std::vector<Case> cases = {{"one frame", "cpst:variance=none,alpha=1,reconstruct=none,"},
                                   {"resolved", "cpst:"}};
  const uint32_t first = PaperLab::warmUp(lab.scale().frames);
  std::vector<std::vector<std::string>> lines;
  for (const std::string run : {"horse/gallop", "foliage/walk", "indoor/fly"}) {
    const std::string name = run.substr(0, run.find('/'));
    std::vector<std::string> techniques;
    for (const Case& of : cases) {
      for (const char* at : {"centre", "covered"}) {
        techniques.push_back(of.technique + "shade_at=" + at);
      }
    }
    lab.measureTogether(run, techniques, view());
    std::vector<double> psnr_db;
    std::vector<std::string> line = {run};
    for (const std::string& technique : techniques) {
      psnr_db.push_back(lab.measure(run, technique, view()).meanPsnr(first));
      line.push_back(fmt::format("{:.2f}", psnr_db.back()));
    }
    for (size_t i = 0; i < cases.size(); ++i) {
      const double gain_db = psnr_db[2 * i + 1] - psnr_db[2 * i];
      outcome.claim(fmt::format("{}, {}, covered over centre", name, cases[i].name), std::nullopt,
                    gain_db, "dB", "less extrapolation is better", gain_db > 0.0);
    }
    lines.push_back(line);
  }
  outcome.table(
      "Where a partly covered coarse pixel is shaded, dB",
      {"", "one frame, centre", "one frame, covered", "resolved, centre", "resolved, covered"},
      lines);
  outcome.note("The resolve weighs by the distance from the coarse pixel's centre in both cases.");
}

}  // namespace reprise::lab::cpst
