// SPDX-License-Identifier: MIT
#include "lab/report/report_page.h"

#include <algorithm>
#include <set>
#include <string_view>

#include "lab/report/page_parts.h"

namespace reprise::lab {
namespace {

constexpr unsigned char kHtml[] = {
#include "page/report.html.inc"
};
constexpr unsigned char kReportScript[] = {
#include "page/report.js.inc"
};

template <size_t N>
std::string_view view(const unsigned char (&bytes)[N]) {
  return {reinterpret_cast<const char*>(bytes), N};
}

}  // namespace

void ReportImages::add(const std::string& source, const std::string& what, uint32_t frame,
                       std::string png) {
  std::string& slot = images_[source][what][frame];
  bytes_ = bytes_ - slot.size() + png.size();
  slot = std::move(png);
}

void ReportImages::fitBudget() {
  while (bytes_ > budget_bytes_) {
    std::set<uint32_t> frames;
    for (const auto& [source, kinds] : images_) {
      for (const auto& [what, pictures] : kinds) {
        for (const auto& [frame, png] : pictures) frames.insert(frame);
      }
    }
    if (frames.size() <= 1) return;
    // The last frame stays: histories are longest there.
    std::set<uint32_t> dropped;
    bool keep = true;
    for (auto frame = frames.rbegin(); frame != frames.rend(); ++frame, keep = !keep) {
      if (!keep) dropped.insert(*frame);
    }
    for (auto& [source, kinds] : images_) {
      for (auto& [what, pictures] : kinds) {
        for (uint32_t frame : dropped) {
          const auto found = pictures.find(frame);
          if (found == pictures.end()) continue;
          bytes_ -= found->second.size();
          pictures.erase(found);
        }
      }
    }
  }
}

std::string reportPage(const std::string& title, const Results& results,
                       const ReportImages& images) {
  OrderedJson data;
  data["results"] = resultsJson(results);
  data["images"] = OrderedJson::object();
  for (const auto& [source, kinds] : images.all()) {
    for (const auto& [what, pictures] : kinds) {
      OrderedJson& frames = data["images"][source][what];
      for (const auto& [frame, png] : pictures) {
        frames[std::to_string(frame)] = pngUri(png);
      }
    }
  }
  const std::string heading = escapedHtml(title);
  const std::string json = scriptJson(data);
  // Data last: a mark in a name is data.
  const PageMark marks[] = {{"@TITLE@", heading},
                            {"@TITLE@", heading},
                            {"@CSS@", pageStyle()},
                            {"@D3@", d3Script()},
                            {"@COMPARER@", comparerScript()},
                            {"@REPORT@", view(kReportScript)},
                            {"@DATA@", json}};
  return filledPage(view(kHtml), marks);
}

}  // namespace reprise::lab
