// SPDX-License-Identifier: MIT
#include "lab/report/results_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

namespace reprise::lab {
namespace {

struct Column {
  const char* title;
  int width;
  int decimals;
  int better;  // +1: more is better, -1: less, 0: neither
  double (*value)(const RunResult&);
  bool is_split = false;  // of still or moving frames alone
};

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

double figure(const std::optional<MeanFigures>& mean, double MeanFigures::*member) {
  return mean.has_value() ? (*mean).*member : kNone;
}

const Column kColumns[] = {
    {"PSNR dB", 9, 2, 1,
     [](const RunResult& r) { return figure(r.figures.mean, &MeanFigures::psnr); }},
    {"still", 8, 2, 1,
     [](const RunResult& r) { return figure(r.figures.still, &MeanFigures::psnr); }, true},
    {"moving", 8, 2, 1,
     [](const RunResult& r) { return figure(r.figures.moving, &MeanFigures::psnr); }, true},
    {"SSIM", 8, 4, 1,
     [](const RunResult& r) { return figure(r.figures.mean, &MeanFigures::ssim); }},
    {"FLIP", 8, 4, -1,
     [](const RunResult& r) { return figure(r.figures.mean, &MeanFigures::flip); }},
    {"FLIP30", 8, 4, -1,
     [](const RunResult& r) { return figure(r.figures.mean, &MeanFigures::flip30); }},
    {"tPSNR dB", 9, 2, 1,
     [](const RunResult& r) { return figure(r.figures.mean, &MeanFigures::tpsnr); }},
    {"flicker", 8, 4, -1,
     [](const RunResult& r) { return figure(r.figures.mean, &MeanFigures::flicker); }},
    {"residue", 8, 4, -1,
     [](const RunResult& r) { return r.figures.residue ? r.figures.residue->sigma_mean : kNone; }},
    {"disocc dB", 10, 2, 1,
     [](const RunResult& r) { return figure(r.figures.mean, &MeanFigures::disoccluded); }},
    {"sharp", 7, 3, 0,
     [](const RunResult& r) { return figure(r.figures.mean, &MeanFigures::sharpness); }},
    {"settles", 8, 0, 0,
     [](const RunResult& r) {
       return r.figures.convergence ? static_cast<double>(r.figures.convergence->frames) : kNone;
     }},
    {"JOD", 7, 3, 1, [](const RunResult& r) { return figure(r.figures.mean, &MeanFigures::jod); }},
    {"resolve ms", 11, 2, 0, [](const RunResult& r) { return r.cost.median_ms; }},
    {"shadings/px", 12, 2, 0,
     [](const RunResult& r) {
       return r.cost.shading_evaluations_per_pixel > 0.0 ? r.cost.shading_evaluations_per_pixel
                                                         : kNone;
     }},
    {"history MiB", 12, 2, 0,
     [](const RunResult& r) { return static_cast<double>(r.cost.history_bytes) / 1048576.0; }},
};

// Columns that say something of these runs: a figure that none has is left out, and so is the split
// where all frames are of one kind.
std::vector<Column> shownColumns(std::span<const RunResult> runs) {
  std::vector<Column> shown;
  for (const Column& column : kColumns) {
    const bool has_value = std::any_of(runs.begin(), runs.end(), [&](const RunResult& run) {
      return std::isfinite(column.value(run));
    });
    const bool split = std::any_of(runs.begin(), runs.end(), [](const RunResult& run) {
      return run.figures.still.has_value() && run.figures.moving.has_value();
    });
    if (has_value && (split || !column.is_split)) shown.push_back(column);
  }
  return shown;
}

}  // namespace

std::string resultsTable(const Results& results) {
  size_t name_width = 12;
  for (const RunResult& run : results.runs) name_width = std::max(name_width, run.technique.size());
  std::string table;
  for (size_t begin = 0; begin < results.runs.size();) {
    size_t end = begin;
    while (end < results.runs.size() && results.runs[end].source == results.runs[begin].source)
      ++end;
    const RunResult& first = results.runs[begin];
    table += fmt::format("{}: {} frames counted, reference {} samples ({})\n", first.source,
                         first.figures.mean ? first.figures.mean->frames : 0,
                         first.reference_samples, first.reference_filter);
    table += fmt::format("{:<{}}", "technique", name_width);
    const std::vector<Column> columns = shownColumns({&results.runs[begin], end - begin});
    for (const Column& column : columns)
      table += fmt::format("{:>{}}", column.title, column.width + 1);
    table += "\n";
    for (size_t i = begin; i < end; ++i) {
      table += fmt::format("{:<{}}", results.runs[i].technique, name_width);
      for (const Column& column : columns) {
        const double value = column.value(results.runs[i]);
        bool best = column.better != 0 && end - begin > 1;
        for (size_t k = begin; k < end && best; ++k) {
          best = !(column.value(results.runs[k]) * column.better > value * column.better);
        }
        const std::string text =
            std::isfinite(value) ? fmt::format("{:.{}f}", value, column.decimals) : "-";
        table +=
            fmt::format("{:>{}}{}", text, column.width, best && std::isfinite(value) ? "*" : " ");
      }
      table += "\n";
    }
    begin = end;
    if (begin < results.runs.size()) table += "\n";
  }
  return table;
}

}  // namespace reprise::lab
