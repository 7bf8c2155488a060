// SPDX-License-Identifier: MIT
#pragma once

#include "lab/paper/paper_run.h"

namespace reprise::lab {

// One HTML file that needs nothing else: every item with its numbers beside the published ones, its
// plots, tables and pictures.
std::string paperPage(const Paper& paper, const PaperScale& scale, const std::string& command,
                      const std::vector<PaperItem>& items);

}  // namespace reprise::lab
