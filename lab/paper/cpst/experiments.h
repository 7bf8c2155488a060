// SPDX-License-Identifier: MIT
//
// The figures and tables of Xiao, Liktor, Vaidyanathan 2018, one function each, in files of their
// names.
#pragma once

#include "lab/paper/outcome.h"
#include "lab/paper/paper_lab.h"

namespace reprise::lab::cpst {

void evaluations(PaperLab& lab, Outcome& outcome);
void table1(PaperLab& lab, Outcome& outcome);
void table2(PaperLab& lab, Outcome& outcome);
void timeByPrice(PaperLab& lab, Outcome& outcome);
void quality(PaperLab& lab, Outcome& outcome);
void figure1(PaperLab& lab, Outcome& outcome);
void figure5(PaperLab& lab, Outcome& outcome);
void figure6(PaperLab& lab, Outcome& outcome);
void figure7(PaperLab& lab, Outcome& outcome);
void figure8(PaperLab& lab, Outcome& outcome);
void figure9(PaperLab& lab, Outcome& outcome);
void pointSets(PaperLab& lab, Outcome& outcome);
void disocclusion(PaperLab& lab, Outcome& outcome);
void spread(PaperLab& lab, Outcome& outcome);
void rasterRate(PaperLab& lab, Outcome& outcome);

}  // namespace reprise::lab::cpst
