// SPDX-License-Identifier: MIT
#include "lab/paper/paper_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "lab/capture/capture_error.h"
#include "lab/capture/output_file.h"
#include "lab/paper/paper_page.h"
#include "reprise/reprise.h"

namespace reprise::lab {
namespace {

std::filesystem::path pictureFile(const std::filesystem::path& folder, size_t index) {
  return folder / fmt::format("picture-{:02}.png", index + 1);
}

// What an outcome depends on besides the program: one of another size is not taken up.
std::string identityOf(const PaperScale& s) {
  return fmt::format("{}x{}, {} and {} frames, {} and {} samples, grid {}, reprise {}",
                     s.extent.width, s.extent.height, s.frames, s.still_frames, s.samples,
                     s.still_samples, s.grid, repriseGetVersion());
}

void writeItem(const std::filesystem::path& folder, const std::string& identity,
               const PaperItem& item) {
  makeOutputDirectory(folder);
  const std::vector<Picture>& pictures = item.outcome.pictures();
  for (size_t i = 0; i < pictures.size(); ++i) {
    writeOutputFile(pictureFile(folder, i), pictures[i].png);
  }
  OrderedJson json;
  json["identity"] = identity;
  json["seconds"] = item.seconds;
  json["outcome"] = item.outcome.json();
  writeOutputFile(folder / "outcome.json", json.dump(1) + "\n");
}

// Whole, complete and of this size, or nothing.
bool readItem(const std::filesystem::path& folder, const std::string& identity, PaperItem& item) {
  try {
    const OrderedJson json = OrderedJson::parse(readWholeFile(folder / "outcome.json"));
    if (json.at("identity") != identity) return false;
    std::vector<Picture> pictures;
    for (const std::string& label : Outcome::pictureLabels(json.at("outcome"))) {
      pictures.push_back({label, readWholeFile(pictureFile(folder, pictures.size()))});
    }
    item.outcome = Outcome::fromJson(json.at("outcome"), std::move(pictures));
    item.seconds = json.at("seconds");
    item.kept = true;
    return item.outcome.complete();
  } catch (const CaptureError&) {
    return false;
  } catch (const OrderedJson::exception&) {
    return false;
  }
}

std::vector<const Experiment*> chosen(const Paper& paper, const std::vector<std::string>& items) {
  std::vector<const Experiment*> experiments;
  for (const Experiment& experiment : paper.experiments) {
    if (items.empty() || std::find(items.begin(), items.end(), experiment.item) != items.end()) {
      experiments.push_back(&experiment);
    }
  }
  for (const std::string& item : items) {
    std::string all;
    bool known = false;
    for (const Experiment& experiment : paper.experiments) {
      known = known || experiment.item == item;
      all += (all.empty() ? "" : ", ") + experiment.item;
    }
    if (!known) throw UsageError("paper '" + paper.name + "' has no item '" + item + "': " + all);
  }
  return experiments;
}

}  // namespace

OrderedJson paperJson(const std::vector<PaperItem>& items) {
  OrderedJson json = OrderedJson::array();
  for (const PaperItem& item : items) {
    for (const PaperRow& row : item.outcome.rows()) {
      json.push_back(rowJson(item.experiment->item, row));
    }
  }
  return json;
}

std::string itemTable(const PaperItem& item) {
  std::string text =
      fmt::format("{}: {} ({:.0f} s{})\n", item.experiment->item, item.experiment->title,
                  item.seconds, item.kept ? ", done before" : "");
  const auto number = [](std::optional<double> value) {
    return value.has_value() ? fmt::format("{:.4g}", *value) : std::string("-");
  };
  size_t width = 20;
  for (const PaperRow& row : item.outcome.rows()) width = std::max(width, row.row.size());
  for (const PaperRow& row : item.outcome.rows()) {
    text += fmt::format("  {:<{}}  {:>9}  {:>9} {:<5}", row.row, width, number(row.published),
                        number(row.measured), row.unit);
    if (row.holds.has_value()) {
      text += fmt::format("  {}: {}", row.claim, *row.holds ? "holds" : "DOES NOT HOLD");
    }
    text += "\n";
  }
  for (const std::string& note : item.outcome.notes()) text += "  " + note + "\n";
  return text;
}

PaperRun runPaper(const Paper& paper, const PaperRunOptions& options,
                  const std::function<void(const PaperItem&)>& done) {
  const std::vector<const Experiment*> experiments = chosen(paper, options.items);
  const std::filesystem::path& directory = options.lab.directory;
  makeOutputDirectory(directory);
  const std::string identity = identityOf(options.lab.scale);
  PaperLab lab(options.lab);
  PaperRun run;
  for (const Experiment* experiment : experiments) {
    PaperItem item;
    item.experiment = experiment;
    const std::filesystem::path folder = directory / itemFolder(experiment->item);
    if (!options.lab.resume || !readItem(folder, identity, item)) {
      item = PaperItem{};
      item.experiment = experiment;
      const auto begin = std::chrono::steady_clock::now();
      experiment->run(lab, item.outcome);
      const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
      item.seconds = taken.count();
      writeItem(folder, identity, item);
    }
    run.items.push_back(std::move(item));
    writeOutputFile(directory / "paper.json", paperJson(run.items).dump(1) + "\n");
    writeOutputFile(directory / "paper.html",
                    paperPage(paper, options.lab.scale, options.command, run.items));
    done(run.items.back());
  }
  run.validation_messages = lab.takeValidationMessages();
  return run;
}

}  // namespace reprise::lab
