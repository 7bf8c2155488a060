// SPDX-License-Identifier: MIT
//
// The figures and tables of Iglesias-Guitian et al. 2016, one function each, in files of their
// names.
#pragma once

#include "lab/paper/outcome.h"
#include "lab/paper/paper_lab.h"

namespace reprise::lab::phlm {

void table2(PaperLab& lab, Outcome& outcome);
void figure2(PaperLab& lab, Outcome& outcome);
void figure3(PaperLab& lab, Outcome& outcome);
void figure4(PaperLab& lab, Outcome& outcome);
void figure5(PaperLab& lab, Outcome& outcome);
void figure6(PaperLab& lab, Outcome& outcome);
void equalTime(PaperLab& lab, Outcome& outcome);
void timeSplit(PaperLab& lab, Outcome& outcome);

}  // namespace reprise::lab::phlm
