// SPDX-License-Identifier: MIT
//
// What one figure or table of a paper came to when it was run again: numbers beside the published
// ones, plots, pictures. All of it can be written to disk and read back.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lab/float_image.h"
#include "lab/report/page_parts.h"

namespace reprise::lab {

// A line of paper.json.
struct PaperRow {
  std::string row;                  // "brick moving"
  std::optional<double> published;  // absent where the paper prints no number
  std::optional<double> measured;   // absent where it could not be measured
  std::string unit;
  std::string claim;          // "above 4x4"; "" where the row only reports
  std::optional<bool> holds;  // absent without a claim, or without a measurement
};

struct Series {
  std::string name;
  std::vector<double> x, y;
  bool points = false;  // marks instead of a line
};

// z over the grid x times y: z[j * x.size() + i].
struct Surface {
  std::string name;
  std::vector<double> x, y, z;
};

struct PlotText {
  std::string title, x, y;
  std::string z = {};
  // Of line plots: logarithmic axes; where above 0, a square with both axes from 0 to it.
  bool log_x = false, log_y = false;
  double square = 0.0;
};

struct Picture {
  std::string label;
  std::string png;  // the file's bytes
};

class Outcome {
 public:
  void add(PaperRow row) { rows_.push_back(std::move(row)); }
  // A row with a claim that holds when `holds` does.
  void claim(const std::string& row, std::optional<double> published, double measured,
             const std::string& unit, const std::string& claim, bool holds);
  void report(const std::string& row, std::optional<double> published, double measured,
              const std::string& unit);
  // A sentence for the page and the terminal.
  void note(const std::string& text) { notes_.push_back(text); }
  // Something that it needs does not exist yet: it says so, and is run again when asked to resume.
  void lacks(const std::string& what);
  bool complete() const { return complete_; }

  void linePlot(const PlotText& text, const std::vector<Series>& series);
  // Surfaces over one grid drawn in space, side by side in `panels`; each panel has one or more.
  void surfacePlot(const PlotText& text,
                   const std::vector<std::pair<std::string, std::vector<Surface>>>& panels);
  // One colour a cell; equal colours mean equal values in all of them.
  void heatMaps(const PlotText& text, const std::vector<Surface>& maps);
  void table(const std::string& title, const std::vector<std::string>& columns,
             const std::vector<std::vector<std::string>>& lines);
  // Display values, RGB; each shown pixel by pixel, and any two in a comparer.
  void gallery(const std::string& title,
               const std::vector<std::pair<std::string, FloatImage>>& images);

  const std::vector<PaperRow>& rows() const { return rows_; }
  const std::vector<std::string>& notes() const { return notes_; }
  const std::vector<Picture>& pictures() const { return pictures_; }

  // All but the pictures' bytes.
  OrderedJson json() const;
  // Of what json() made; throws nlohmann::json::exception where it is none. `pictures` in the order
  // of pictures().
  static Outcome fromJson(const OrderedJson& json, std::vector<Picture> pictures);
  // Labels of the pictures of a json().
  static std::vector<std::string> pictureLabels(const OrderedJson& json);

 private:
  std::vector<PaperRow> rows_;
  std::vector<std::string> notes_;
  bool complete_ = true;
  OrderedJson blocks_ = OrderedJson::array();  // plots, tables, galleries, in order
  std::vector<Picture> pictures_;              // galleries name them by index
};

OrderedJson rowJson(const std::string& item, const PaperRow& row);

}  // namespace reprise::lab
