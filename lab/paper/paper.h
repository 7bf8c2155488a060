// SPDX-License-Identifier: MIT
//
// A published paper as a list of experiments: each figure or table is one of them, in a file of its
// own, under the folder of its paper.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "lab/paper/outcome.h"
#include "lab/paper/paper_lab.h"

namespace reprise::lab {

struct Experiment {
  std::string item;   // "figure 3"; its folder is "figure-3"
  std::string title;  // what it shows, one line
  void (*run)(PaperLab& lab, Outcome& outcome);
};

struct Paper {
  std::string name;      // of the command: "amortized"
  std::string citation;  // authors, year, title
  PaperScale scale;      // what a run without flags does
  PaperScale full;       // the published size
  std::vector<Experiment> experiments;
};

// The one list of papers.
const std::vector<Paper>& paperList();

// "figure 3" -> "figure-3".
std::string itemFolder(const std::string& item);

}  // namespace reprise::lab
