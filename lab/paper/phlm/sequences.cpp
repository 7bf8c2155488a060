// SPDX-License-Identifier: MIT
#include "lab/paper/phlm/sequences.h"

namespace reprise::lab::phlm {

const Sequence& openWorld() {
  static const Sequence sequence{
      "foliage", "foliage/walk", "OpenWorld", {23.45, 23.61, 21.46, 23.29}};
  return sequence;
}

const Sequence& spaceLand() {
  static const Sequence sequence{"hangar", "hangar/fly", "SpaceLand", {25.98, 26.98, 24.78, 26.11}};
  return sequence;
}

const std::vector<Contender>& contenders() {
  static const std::vector<Contender> list = {
      {"no AA", "none", &PublishedPsnr::none_db, 0.0},
      {"FXAA", "fxaa", &PublishedPsnr::fxaa_db, 0.23},
      {"UE4-TAA", "ue4-taa", &PublishedPsnr::ue4_db, 0.40},
      {"PHLM", "phlm", &PublishedPsnr::phlm_db, 7.0},
      {"PHLM as published", "phlm:preset=paper", nullptr, 0.0},
      {"taa at its best", "taa", nullptr, 0.0},
      {"reprise, our own", "reprise", nullptr, 0.0},
  };
  return list;
}

PaperView view() {
  PaperView view;
  view.judged = Judged::kPixel;
  view.reference_filter = ReferenceFilter::kBox;
  view.over_time = true;
  return view;
}

double psnrOf(PaperLab& lab, const std::string& run, const std::string& technique,
              const PaperView& view) {
  const Measured& measured = lab.measure(run, technique, view);
  return measured.meanPsnr(PaperLab::warmUp(lab.scale().frames));
}

}  // namespace reprise::lab::phlm
