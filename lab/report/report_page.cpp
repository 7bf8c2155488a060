// SPDX-License-Identifier: MIT
#include "lab/report/report_page.h"

#include <algorithm>
#include <set>
#include <string_view>

namespace reprise::lab {
namespace {

constexpr unsigned char kHtml[] = {
#include "page/report.html.inc"
};
constexpr unsigned char kCss[] = {
#include "page/report.css.inc"
};
constexpr unsigned char kReportScript[] = {
#include "page/report.js.inc"
};
constexpr unsigned char kComparerScript[] = {
#include "page/comparer.js.inc"
};
// D3 3.5, Michael Bostock, BSD licence; from the system's package at build time.
constexpr unsigned char kD3[] = {
#include "page/d3.min.js.inc"
};

template <size_t N>
std::string_view view(const unsigned char (&bytes)[N]) {
  return {reinterpret_cast<const char*>(bytes), N};
}

std::string base64(std::string_view bytes) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (size_t i = 0; i < bytes.size(); i += 3) {
    uint32_t group = 0;
    for (size_t k = 0; k < 3; ++k) {
      group = group << 8 | (i + k < bytes.size() ? static_cast<uint8_t>(bytes[i + k]) : 0u);
    }
    for (size_t k = 0; k < 4; ++k) {
      text += i + k > bytes.size() ? '=' : kDigits[group >> (18 - 6 * k) & 63];
    }
  }
  return text;
}

void replaceOnce(std::string& text, std::string_view mark, std::string_view with) {
  const size_t at = text.find(mark);
  if (at != std::string::npos) text.replace(at, mark.size(), with);
}

std::string escaped(std::string_view text) {
  std::string html;
  for (char c : text) {
    if (c == '&')
      html += "&amp;";
    else if (c == '<')
      html += "&lt;";
    else
      html += c;
  }
  return html;
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
        frames[std::to_string(frame)] = "data:image/png;base64," + base64(png);
      }
    }
  }
  // "</script>" in a name must not end the script.
  std::string json = data.dump();
  for (size_t at = json.find("</"); at != std::string::npos; at = json.find("</", at + 3)) {
    json.replace(at, 2, "<\\/");
  }
  std::string page(view(kHtml));
  for (int i = 0; i < 2; ++i) replaceOnce(page, "@TITLE@", escaped(title));
  replaceOnce(page, "@CSS@", view(kCss));
  replaceOnce(page, "@D3@", view(kD3));
  replaceOnce(page, "@COMPARER@", view(kComparerScript));
  replaceOnce(page, "@REPORT@", view(kReportScript));
  replaceOnce(page, "@DATA@", json);
  return page;
}

}  // namespace reprise::lab
