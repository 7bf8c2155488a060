// SPDX-License-Identifier: MIT
//
// What every page of ours is made of: one HTML file that fetches nothing.
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace reprise::lab {

using OrderedJson = nlohmann::ordered_json;

std::string_view pageStyle();       // CSS
std::string_view d3Script();        // D3 3.5
std::string_view comparerScript();  // makeComparer: two images on a canvas

// A PNG's bytes as the URI of an image.
std::string pngUri(std::string_view png);
// For text between tags.
std::string escapedHtml(std::string_view text);
// Of which no text can end the script element that it stands in.
std::string scriptJson(const OrderedJson& json);

// `html` with each mark ("@CSS@") replaced where it stands, once, in order: what replaces it is not
// searched for the marks before.
using PageMark = std::pair<std::string_view, std::string_view>;
std::string filledPage(std::string_view html, std::span<const PageMark> marks);

}  // namespace reprise::lab
