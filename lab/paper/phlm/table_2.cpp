// SPDX-License-Identifier: MIT
//
// Table 2: average PSNR and time of each method on both sequences; and what the text claims beside
// it: no more flicker than UE4-TAA, sharper, less ghosting.
#include <fmt/format.h>

#include "lab/paper/phlm/experiments.h"
#include "lab/paper/phlm/sequences.h"

namespace reprise::lab::phlm {
namespace {

// The smaller of the two published margins over UE4-TAA is 1.33 dB.
constexpr double kOverUe4_db = 1.3;

void tableOf(PaperLab& lab, const Sequence& sequence, Outcome& outcome) {
  std::vector<std::vector<std::string>> cells;
  for (const Contender& contender : contenders()) {
    const Measured& measured = lab.measure(sequence.run, contender.technique, view());
    const double psnr_db = psnrOf(lab, sequence.run, contender.technique, view());
    std::optional<double> published;
    if (contender.psnr != nullptr) published = sequence.psnr.*contender.psnr;
    outcome.report(sequence.scene + ", " + contender.name, published, psnr_db, "dB");
    const OverTime& o = measured.over_time;
    cells.push_back(
        {contender.name, contender.technique,
         published ? fmt::format("{:.2f} / {:.2f}", *published, psnr_db)
                   : fmt::format("- / {:.2f}", psnr_db),
         fmt::format("{:.2f}", o.tpsnr_db), fmt::format("{:.4f}", o.flicker),
         fmt::format("{:.2f}", o.disoccluded_db), fmt::format("{:.3f}", o.sharpness),
         contender.published_ms > 0.0
             ? fmt::format("{:.2f} / {:.2f}", contender.published_ms, measured.resolve_ms)
             : fmt::format("- / {:.2f}", measured.resolve_ms)});
  }
  outcome.table(fmt::format("{}, after {}: published / measured", sequence.run, sequence.published),
                {"method", "as", "PSNR, dB", "tPSNR, dB", "flicker", "disoccluded, dB", "sharpness",
                 "resolve, ms"},
                cells);

  const OverTime& ours = lab.measure(sequence.run, "phlm", view()).over_time;
  const OverTime& ue4 = lab.measure(sequence.run, "ue4-taa", view()).over_time;
  const double margin_db =
      psnrOf(lab, sequence.run, "phlm", view()) - psnrOf(lab, sequence.run, "ue4-taa", view());
  outcome.claim(sequence.scene + ", PHLM over UE4-TAA",
                sequence.psnr.phlm_db - sequence.psnr.ue4_db, margin_db, "dB",
                fmt::format("at least {} dB", kOverUe4_db), margin_db >= kOverUe4_db);
  outcome.claim(sequence.scene + ", flicker over UE4-TAA's", std::nullopt,
                ours.flicker / ue4.flicker, "times", "no more", ours.flicker <= ue4.flicker);
  outcome.claim(sequence.scene + ", sharpness over UE4-TAA's", std::nullopt,
                ours.sharpness / ue4.sharpness, "times", "sharper", ours.sharpness > ue4.sharpness);
  outcome.claim(sequence.scene + ", after disocclusion over UE4-TAA", std::nullopt,
                ours.disoccluded_db - ue4.disoccluded_db, "dB", "less ghosting",
                ours.disoccluded_db > ue4.disoccluded_db);
}

}  // namespace

void table2(PaperLab& lab, Outcome& outcome) {
  tableOf(lab, openWorld(), outcome);
  tableOf(lab, spaceLand(), outcome);
  outcome.note(
      "Means over the frames that count. The published scenes, and Unreal's renderer, are not "
      "ours: what can be compared are the differences. Published times: GTX 980, 1920 x 1080.");
}

}  // namespace reprise::lab::phlm
