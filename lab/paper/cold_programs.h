// SPDX-License-Identifier: MIT
#pragma once

#include "lab/paper/outcome.h"
#include "lab/paper/paper_lab.h"

namespace reprise::lab {

// For what measures time, where times of a first run mislead: llvmpipe adds a constant to each
// dispatch of a large program, 0.2 to 0.5 s for lighting's, until Mesa's cache on disk holds that
// from an earlier process (docs/figures.md).
void noteColdPrograms(const PaperLab& lab, Outcome& outcome);

}  // namespace reprise::lab
