// SPDX-License-Identifier: MIT
#include "lab/paper/cold_programs.h"

namespace reprise::lab {

void noteColdPrograms(const PaperLab& lab, Outcome& outcome) {
  if (lab.openDevice()->name().find("llvmpipe") == std::string::npos) return;
  outcome.note(
      "Times count from the second run of a build on: llvmpipe takes longer for large programs, by "
      "the same in every frame, until Mesa's shader cache holds them from an earlier process.");
}

}  // namespace reprise::lab
