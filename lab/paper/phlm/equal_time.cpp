// SPDX-License-Identifier: MIT
//
// Section 7.1: FXAA on about two samples a pixel takes the time of PHLM on one, and flickers more.
#include <fmt/format.h>

#include "lab/paper/phlm/experiments.h"
#include "lab/paper/phlm/sequences.h"

namespace reprise::lab::phlm {
namespace {

void equalTimeOf(PaperLab& lab, const Sequence& sequence, Outcome& outcome) {
  PaperView two = view();
  two.samples = 2;
  const Measured& fxaa = lab.measure(sequence.run, "fxaa", two);
  const double fxaa_db = psnrOf(lab, sequence.run, "fxaa", two);
  const Measured& ours = lab.measure(sequence.run, "phlm", view());
  const double ours_db = psnrOf(lab, sequence.run, "phlm", view());
  outcome.report(sequence.scene + ", FXAA at 2 samples", std::nullopt, fxaa_db, "dB");
  outcome.report(sequence.scene + ", PHLM at 1 sample", std::nullopt, ours_db, "dB");
  outcome.report(sequence.scene + ", frame time, FXAA at 2 over PHLM at 1", 1.0,
                 fxaa.frameMs() / ours.frameMs(), "times");
  outcome.claim(sequence.scene + ", flicker, FXAA at 2 over PHLM at 1", std::nullopt,
                fxaa.over_time.flicker / ours.over_time.flicker, "times", "FXAA flickers more",
                fxaa.over_time.flicker > ours.over_time.flicker);
}

}  // namespace

void equalTime(PaperLab& lab, Outcome& outcome) {
  equalTimeOf(lab, openWorld(), outcome);
  equalTimeOf(lab, spaceLand(), outcome);
  outcome.note("The paper names no figures here; its supplementary video shows them.");
}

}  // namespace reprise::lab::phlm
