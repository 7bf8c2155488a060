// SPDX-License-Identifier: MIT
//
// What the paper names as future work: points of shading and of visibility that fit together within
// one frame. Hardware shades at the coarse pixel's centre even where the triangle does not cover
// it; here it is also shaded at the middle of the pixels that it covers, which extrapolates less.
#include <fmt/format.h>

#include "lab/paper/cpst/experiments.h"
#include "lab/paper/cpst/subjects.h"

namespace reprise::lab::cpst {

void spread(PaperLab& lab, Outcome& outcome) {
  std::vector<std::vector<std::string>> lines;
  for (const std::string run : {"horse/gallop", "foliage/walk", "indoor/fly"}) {
    const std::string name = run.substr(0, run.find('/'));
    PaperView covered = view();
    covered.shade_covered = true;
    std::vector<std::string> line = {run};
    for (const char* technique :
         {"cpst:variance=none,alpha=1,reconstruct=none,shade_at=centre", "cpst:shade_at=centre"}) {
      const uint32_t first = PaperLab::warmUp(lab.scale().frames);
      const double center_db = lab.measure(run, technique, view()).meanPsnr(first);
      const double covered_db = lab.measure(run, technique, covered).meanPsnr(first);
      line.push_back(fmt::format("{:.2f}", center_db));
      line.push_back(fmt::format("{:.2f}", covered_db));
      const bool whole = std::string(technique) == "cpst:shade_at=centre";
      outcome.claim(name + (whole ? ", resolved" : ", one frame") + ", covered over centre",
                    std::nullopt, covered_db - center_db, "dB", "less extrapolation is better",
                    covered_db > center_db);
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
