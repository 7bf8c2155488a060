// SPDX-License-Identifier: MIT
#include "compare_output.h"

#include <fmt/format.h>

#include <cctype>

#include "lab/capture/output_file.h"
#include "lab/capture/png_file.h"
#include "lab/metrics/magma.h"

namespace reprise::app {
namespace {

// A name as a folder: "taa:alpha=0.05" -> "taa-alpha=0.05", "brick/pan" -> "brick-pan".
std::string folderName(const std::string& text) {
  std::string name;
  for (char c : text) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '=' ||
                       c == '_' || c == '-';
    if (plain)
      name += c;
    else if (!name.empty() && name.back() != '-')
      name += '-';
  }
  return name.empty() || name.find_first_not_of('.') == std::string::npos ? "_" : name;
}

}  // namespace

CompareOutput::CompareOutput(std::filesystem::path directory, uint64_t report_bytes)
    : directory_(std::move(directory)), images_(report_bytes) {
  lab::makeOutputDirectory(directory_);
}

void CompareOutput::add(const char* folder, const std::string& source, const std::string& what,
                        const std::string& label, uint32_t frame, const lab::FloatImage& display) {
  const std::filesystem::path path = directory_ / folder / folderName(source) / folderName(what);
  std::string png = lab::encodePng(display);
  const std::lock_guard lock(mutex_);
  lab::makeOutputDirectory(path);
  lab::writeOutputFile(path / fmt::format("{:04}.png", frame), png);
  images_.add(source, label, frame, std::move(png));
}

void CompareOutput::addImage(const std::string& source, const std::string& what, uint32_t frame,
                             const lab::FloatImage& display) {
  add("frames", source, what, what, frame, display);
}

void CompareOutput::addError(const std::string& source, const std::string& technique,
                             uint32_t frame, const lab::FloatImage& flip_error) {
  add("errors", source, technique, "flip of " + technique, frame, lab::magmaImage(flip_error));
}

void CompareOutput::finish(const lab::Results& results) {
  lab::writeOutputFile(directory_ / "results.json", lab::resultsJson(results).dump(1) + "\n");
  lab::writeOutputFile(directory_ / "results.csv", lab::resultsCsv(results));
  images_.fitBudget();
  lab::writeOutputFile(directory_ / "report.html",
                       lab::reportPage("Reprise: comparison", results, images_));
}

}  // namespace reprise::app
