// SPDX-License-Identifier: MIT
//
// The figures and tables of Yang et al. 2009, one function each, in files of their names.
#pragma once

#include "lab/paper/outcome.h"
#include "lab/paper/paper_lab.h"

namespace reprise::lab::amortized {

void figure1(PaperLab& lab, Outcome& outcome);
void figure3(PaperLab& lab, Outcome& outcome);
void figure6(PaperLab& lab, Outcome& outcome);
void figure7(PaperLab& lab, Outcome& outcome);
void figure8(PaperLab& lab, Outcome& outcome);
void figure9(PaperLab& lab, Outcome& outcome);
void figure10(PaperLab& lab, Outcome& outcome);
void figure11(PaperLab& lab, Outcome& outcome);
void figure12(PaperLab& lab, Outcome& outcome);
void figure13(PaperLab& lab, Outcome& outcome);
void figure14(PaperLab& lab, Outcome& outcome);
void timeByPrice(PaperLab& lab, Outcome& outcome);
void silhouettes(PaperLab& lab, Outcome& outcome);
void limits(PaperLab& lab, Outcome& outcome);
void memory(PaperLab& lab, Outcome& outcome);

}  // namespace reprise::lab::amortized
