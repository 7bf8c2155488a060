// SPDX-License-Identifier: MIT
//
// Runs a paper's experiments one after the other into a directory:
//   figure-3/outcome.json, *.png   what an item came to; last written, so that a whole one is done
//   runs/                          measurements that items share
//   paper.json, paper.html         rewritten after each item
#pragma once

#include <functional>

#include "lab/paper/paper.h"

namespace reprise::lab {

struct PaperRunOptions {
  PaperLabOptions lab;             // its directory is the paper's
  std::string command;             // for the page
  std::vector<std::string> items;  // the only ones to run; empty: all
};

struct PaperItem {
  const Experiment* experiment;
  Outcome outcome;
  double seconds = 0.0;
  bool kept = false;  // done by an earlier process
};

struct PaperRun {
  std::vector<PaperItem> items;
  std::vector<std::string> validation_messages;
};

// Throws UsageError for an item that the paper does not have. `done` is called after each item.
PaperRun runPaper(const Paper& paper, const PaperRunOptions& options,
                  const std::function<void(const PaperItem&)>& done);

// The document of paper.json: one object a row, in the order of the items.
OrderedJson paperJson(const std::vector<PaperItem>& items);
// An item's rows as text.
std::string itemTable(const PaperItem& item);

}  // namespace reprise::lab
