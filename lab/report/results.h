// SPDX-License-Identifier: MIT
//
// What a comparison found, and its results.json: an interface that other tools read.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "lab/metrics/sequence_meter.h"
#include "lab/report/page_parts.h"

namespace reprise::lab {

struct RunCost {
  // Median over the counted frames in ms, in the order recorded.
  std::vector<std::pair<std::string, double>> passes_ms;  // the technique's
  std::vector<std::pair<std::string, double>> render_ms;  // the source's; empty for captures
  std::vector<std::pair<std::string, double>> post_ms;  // the post chain's, where one was asked for
  double median_ms = 0.0;                               // of the technique's passes together
  double shading_evaluations_per_pixel = 0.0;           // 0: not known
  uint64_t history_bytes = 0;
};

struct RunResult {
  std::string source;
  std::string technique;                                      // as written: "taa:alpha=0.05"
  std::vector<std::pair<std::string, OrderedJson>> settings;  // all that stand, by name
  uint32_t reference_samples = 0;
  std::string reference_filter;
  SequenceFigures figures;
  RunCost cost;
};

struct Results {
  std::string command;
  std::string device;
  std::string driver;
  uint32_t extent[2] = {0, 0};  // of the first source
  std::string post;             // what lies before the display curve; empty: nothing
  std::vector<RunResult> runs;
};

OrderedJson resultsJson(const Results& results);
// A line a run and frame.
std::string resultsCsv(const Results& results);

// Runs whose mean PSNR fell below the baseline's by more than `max_drop_db`, or that it has and we
// lack, a line each. `baseline` is a results.json; throws CaptureError naming `file` where it is
// none.
struct BaselineCheck {
  std::vector<std::string> failures;
  uint32_t compared = 0;
};
BaselineCheck checkBaseline(const Results& results, const std::string& baseline_text,
                            const std::string& file, double max_drop_db);

}  // namespace reprise::lab
