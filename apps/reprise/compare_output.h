// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <mutex>
#include <string>

#include "lab/report/report_page.h"
#include "lab/report/results.h"

namespace reprise::app {

// Where a comparison lands: frames/SOURCE/WHAT/NNNN.png, errors likewise, results.json,
// results.csv, report.html. Pictures may be added from several threads.
class CompareOutput {
 public:
  CompareOutput(std::filesystem::path directory, uint64_t report_bytes);

  void addImage(const std::string& source, const std::string& what, uint32_t frame,
                const lab::FloatImage& display);
  void addError(const std::string& source, const std::string& technique, uint32_t frame,
                const lab::FloatImage& flip_error);
  void finish(const lab::Results& results);

  const std::filesystem::path& directory() const { return directory_; }

 private:
  void add(const char* folder, const std::string& source, const std::string& what,
           const std::string& label, uint32_t frame, const lab::FloatImage& display);

  std::filesystem::path directory_;
  lab::ReportImages images_;
  std::mutex mutex_;
};

}  // namespace reprise::app
