// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "lab/report/results.h"

namespace reprise::lab {

// Figures of all runs, one source after the other, as aligned text; the best of a column is
// starred.
std::string resultsTable(const Results& results);

}  // namespace reprise::lab
