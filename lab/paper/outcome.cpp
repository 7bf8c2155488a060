// SPDX-License-Identifier: MIT
#include "lab/paper/outcome.h"

#include <cmath>

#include "lab/capture/png_file.h"

namespace reprise::lab {
namespace {

OrderedJson numberJson(std::optional<double> value) {
  if (!value.has_value() || !std::isfinite(*value)) return nullptr;
  return *value;
}

std::optional<double> numberFrom(const OrderedJson& json) {
  if (json.is_null()) return std::nullopt;
  return json.get<double>();
}

OrderedJson surfaceJson(const Surface& surface) {
  return {{"name", surface.name}, {"x", surface.x}, {"y", surface.y}, {"z", surface.z}};
}

OrderedJson blockJson(const char* kind, const PlotText& text) {
  return {{"kind", kind}, {"title", text.title}, {"x", text.x},         {"y", text.y},
          {"z", text.z},  {"log_x", text.log_x}, {"log_y", text.log_y}, {"square", text.square}};
}

}  // namespace

OrderedJson rowJson(const std::string& item, const PaperRow& row) {
  OrderedJson json;
  json["item"] = item;
  json["row"] = row.row;
  json["published"] = numberJson(row.published);
  json["measured"] = numberJson(row.measured);
  json["unit"] = row.unit;
  json["claim"] = row.claim;
  json["holds"] = row.holds.has_value() ? OrderedJson(*row.holds) : OrderedJson(nullptr);
  return json;
}

void Outcome::claim(const std::string& row, std::optional<double> published, double measured,
                    const std::string& unit, const std::string& claim, bool holds) {
  add({row, published, measured, unit, claim, holds});
}

void Outcome::report(const std::string& row, std::optional<double> published, double measured,
                     const std::string& unit) {
  add({row, published, measured, unit, "", std::nullopt});
}

void Outcome::lacks(const std::string& what) {
  note(what + " is not here");
  complete_ = false;
}

void Outcome::linePlot(const PlotText& text, const std::vector<Series>& series) {
  OrderedJson block = blockJson("lines", text);
  block["series"] = OrderedJson::array();
  for (const Series& one : series) {
    block["series"].push_back(
        {{"name", one.name}, {"x", one.x}, {"y", one.y}, {"points", one.points}});
  }
  blocks_.push_back(std::move(block));
}

void Outcome::surfacePlot(const PlotText& text,
                          const std::vector<std::pair<std::string, std::vector<Surface>>>& panels) {
  OrderedJson block = blockJson("surfaces", text);
  block["panels"] = OrderedJson::array();
  for (const auto& [name, surfaces] : panels) {
    OrderedJson panel = {{"name", name}, {"surfaces", OrderedJson::array()}};
    for (const Surface& surface : surfaces) panel["surfaces"].push_back(surfaceJson(surface));
    block["panels"].push_back(std::move(panel));
  }
  blocks_.push_back(std::move(block));
}

void Outcome::heatMaps(const PlotText& text, const std::vector<Surface>& maps) {
  OrderedJson block = blockJson("heat", text);
  block["maps"] = OrderedJson::array();
  for (const Surface& map : maps) block["maps"].push_back(surfaceJson(map));
  blocks_.push_back(std::move(block));
}

void Outcome::table(const std::string& title, const std::vector<std::string>& columns,
                    const std::vector<std::vector<std::string>>& lines) {
  blocks_.push_back({{"kind", "table"}, {"title", title}, {"columns", columns}, {"lines", lines}});
}

void Outcome::gallery(const std::string& title,
                      const std::vector<std::pair<std::string, FloatImage>>& images) {
  OrderedJson block = {{"kind", "gallery"}, {"title", title}, {"pictures", OrderedJson::array()}};
  for (const auto& [label, image] : images) {
    block["pictures"].push_back({{"label", label},
                                 {"index", pictures_.size()},
                                 {"width", image.width},
                                 {"height", image.height}});
    pictures_.push_back({label, encodePng(image)});
  }
  blocks_.push_back(std::move(block));
}

OrderedJson Outcome::json() const {
  OrderedJson json;
  json["rows"] = OrderedJson::array();
  for (const PaperRow& row : rows_) json["rows"].push_back(rowJson("", row));
  json["notes"] = notes_;
  json["complete"] = complete_;
  json["blocks"] = blocks_;
  return json;
}

std::vector<std::string> Outcome::pictureLabels(const OrderedJson& json) {
  std::vector<std::string> labels;
  for (const OrderedJson& block : json.at("blocks")) {
    if (block.at("kind") != "gallery") continue;
    for (const OrderedJson& picture : block.at("pictures")) labels.push_back(picture.at("label"));
  }
  return labels;
}

Outcome Outcome::fromJson(const OrderedJson& json, std::vector<Picture> pictures) {
  Outcome outcome;
  for (const OrderedJson& row : json.at("rows")) {
    PaperRow read{row.at("row"),
                  numberFrom(row.at("published")),
                  numberFrom(row.at("measured")),
                  row.at("unit"),
                  row.at("claim"),
                  std::nullopt};
    if (!row.at("holds").is_null()) read.holds = row.at("holds").get<bool>();
    outcome.rows_.push_back(std::move(read));
  }
  for (const OrderedJson& note : json.at("notes")) outcome.notes_.push_back(note);
  outcome.complete_ = json.at("complete");
  outcome.blocks_ = json.at("blocks");
  outcome.pictures_ = std::move(pictures);
  return outcome;
}

}  // namespace reprise::lab
