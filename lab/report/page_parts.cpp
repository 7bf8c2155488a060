// SPDX-License-Identifier: MIT
#include "lab/report/page_parts.h"

#include <cstdint>

namespace reprise::lab {
namespace {

constexpr unsigned char kCss[] = {
#include "page/report.css.inc"
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

}  // namespace

std::string_view pageStyle() {
  return view(kCss);
}

std::string_view d3Script() {
  return view(kD3);
}

std::string_view comparerScript() {
  return view(kComparerScript);
}

std::string pngUri(std::string_view png) {
  return "data:image/png;base64," + base64(png);
}

std::string escapedHtml(std::string_view text) {
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

std::string scriptJson(const OrderedJson& json) {
  std::string text = json.dump();
  for (size_t at = text.find("</"); at != std::string::npos; at = text.find("</", at + 3)) {
    text.replace(at, 2, "<\\/");
  }
  return text;
}

std::string filledPage(std::string_view html, std::span<const PageMark> marks) {
  std::string page(html);
  for (const auto& [mark, with] : marks) {
    const size_t at = page.find(mark);
    if (at != std::string::npos) page.replace(at, mark.size(), with);
  }
  return page;
}

}  // namespace reprise::lab
