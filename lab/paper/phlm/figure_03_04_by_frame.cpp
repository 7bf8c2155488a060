// SPDX-License-Identifier: MIT
//
// Figures 3 and 4: PSNR frame by frame.
#include "lab/paper/phlm/experiments.h"
#include "lab/paper/phlm/sequences.h"

namespace reprise::lab::phlm {
namespace {

void byFrame(PaperLab& lab, const Sequence& sequence, Outcome& outcome) {
  std::vector<Series> series;
  for (const Contender& contender : contenders()) {
    const Measured& measured = lab.measure(sequence.run, contender.technique, view());
    series.push_back({contender.name,
                      {measured.frames.begin(), measured.frames.end()},
                      measured.psnr_db,
                      false});
  }
  outcome.linePlot({sequence.run, "frame", "PSNR, dB"}, series);
  // In the published curves PHLM is above UE4-TAA all along.
  const Measured& ours = lab.measure(sequence.run, "phlm", view());
  const Measured& ue4 = lab.measure(sequence.run, "ue4-taa", view());
  size_t above = 0;
  size_t counted = 0;
  for (size_t i = 0; i < ours.frames.size(); ++i) {
    if (ours.frames[i] < PaperLab::warmUp(lab.scale().frames)) continue;
    ++counted;
    if (ours.psnr_db[i] > ue4.psnr_db[i]) ++above;
  }
  const double share = static_cast<double>(above) / static_cast<double>(counted);
  outcome.claim(sequence.scene + ", frames in which PHLM is above UE4-TAA", 1.0, share, "of all",
                "all", above == counted);
}

}  // namespace

void figure3(PaperLab& lab, Outcome& outcome) {
  byFrame(lab, openWorld(), outcome);
}

void figure4(PaperLab& lab, Outcome& outcome) {
  byFrame(lab, spaceLand(), outcome);
}

}  // namespace reprise::lab::phlm
