// SPDX-License-Identifier: MIT
#include "lab/paper/paper_page.h"

#include "lab/report/page_parts.h"
#include "reprise/reprise.h"

namespace reprise::lab {
namespace {

constexpr unsigned char kHtml[] = {
#include "page/paper.html.inc"
};
constexpr unsigned char kCss[] = {
#include "page/paper.css.inc"
};
constexpr unsigned char kPlots[] = {
#include "page/plots.js.inc"
};
constexpr unsigned char kPaper[] = {
#include "page/paper.js.inc"
};

template <size_t N>
std::string_view view(const unsigned char (&bytes)[N]) {
  return {reinterpret_cast<const char*>(bytes), N};
}

OrderedJson scaleJson(const PaperScale& scale) {
  return {{"extent", {scale.extent.width, scale.extent.height}},
          {"frames", scale.frames},
          {"still_frames", scale.still_frames},
          {"samples", scale.samples},
          {"still_samples", scale.still_samples}};
}

}  // namespace

std::string paperPage(const Paper& paper, const PaperScale& scale, const std::string& command,
                      const std::vector<PaperItem>& items) {
  OrderedJson data;
  data["citation"] = paper.citation;
  data["command"] = command;
  data["reprise"] = repriseGetVersion();
  data["scale"] = scaleJson(scale);
  data["items"] = OrderedJson::array();
  for (const PaperItem& item : items) {
    OrderedJson json = item.outcome.json();
    json["item"] = item.experiment->item;
    json["title"] = item.experiment->title;
    json["seconds"] = item.seconds;
    json["pictures"] = OrderedJson::array();
    for (const Picture& picture : item.outcome.pictures()) {
      json["pictures"].push_back(pngUri(picture.png));
    }
    data["items"].push_back(std::move(json));
  }
  const std::string heading = escapedHtml("Reprise: the paper '" + paper.name + "' run again");
  const std::string json = scriptJson(data);
  const PageMark marks[] = {
      {"@TITLE@", heading},      {"@TITLE@", heading},      {"@CSS@", pageStyle()},
      {"@OWN_CSS@", view(kCss)}, {"@D3@", d3Script()},      {"@COMPARER@", comparerScript()},
      {"@PLOTS@", view(kPlots)}, {"@PAPER@", view(kPaper)}, {"@DATA@", json}};
  return filledPage(view(kHtml), marks);
}

}  // namespace reprise::lab
