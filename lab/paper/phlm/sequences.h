// SPDX-License-Identifier: MIT
//
// The two sequences of Iglesias-Guitian et al. 2016, what was published of them, and what every
// experiment asks of them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lab/paper/paper_lab.h"

namespace reprise::lab::phlm {

// Average PSNR, dB, of table 2.
struct PublishedPsnr {
  double none_db, fxaa_db, ue4_db, phlm_db;
};

struct Sequence {
  std::string scene;      // ours
  std::string run;        // its moving camera
  std::string published;  // the paper's name of what it stands for
  PublishedPsnr psnr;
};

const Sequence& openWorld();
const Sequence& spaceLand();

// A line of table 2: as the paper calls it, and what we run.
struct Contender {
  std::string name;
  std::string technique;
  double PublishedPsnr::*psnr;  // null where the paper has no such line
  double published_ms;          // at 1920 x 1080 on a GTX 980; 0: none
};

// None, FXAA, UE4-TAA, PHLM; then PHLM as published, `taa` at its best, and our own technique.
const std::vector<Contender>& contenders();

// Whole pixels, every frame judged, references of one sample filter's pixel: the box.
PaperView view();

// Mean over the frames that count.
double psnrOf(PaperLab& lab, const std::string& run, const std::string& technique,
              const PaperView& view);

}  // namespace reprise::lab::phlm
