// SPDX-License-Identifier: MIT
//
// For tests: glTF files put together on the spot.
#pragma once

#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "lab/capture/png_file.h"

namespace reprise::lab {

struct MadeUpGltf {
  using Json = nlohmann::json;

  Json json{{"asset", {{"version", "2.0"}}}, {"scene", 0}, {"scenes", {{{"nodes", {0}}}}}};
  std::string bytes;

  // An accessor with a buffer view of its own.
  template <typename T>
  int accessor(const std::vector<T>& values, int component_type, const char* type, int components) {
    while (bytes.size() % 4 != 0) bytes += '\0';
    const size_t offset = bytes.size();
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
    json["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", values.size() * sizeof(T)}});
    json["accessors"].push_back({{"bufferView", json["bufferViews"].size() - 1},
                                 {"componentType", component_type},
                                 {"type", type},
                                 {"count", values.size() / static_cast<size_t>(components)}});
    return static_cast<int>(json["accessors"].size()) - 1;
  }
  int vec3(const std::vector<float>& values) { return accessor(values, 5126, "VEC3", 3); }
  int vec2(const std::vector<float>& values) { return accessor(values, 5126, "VEC2", 2); }
  int scalars(const std::vector<float>& values) { return accessor(values, 5126, "SCALAR", 1); }

  // A square of side 2 about the origin that faces +z, uv (0, 0) at its upper left.
  int quad(int material = -1) {
    Json primitive;
    primitive["attributes"] = {{"POSITION", vec3({-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0})},
                               {"NORMAL", vec3({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1})},
                               {"TEXCOORD_0", vec2({0, 1, 1, 1, 1, 0, 0, 0})}};
    primitive["indices"] = accessor(std::vector<uint16_t>{0, 1, 2, 0, 2, 3}, 5123, "SCALAR", 1);
    if (material >= 0) primitive["material"] = material;
    json["meshes"].push_back({{"primitives", {primitive}}});
    return static_cast<int>(json["meshes"].size()) - 1;
  }

  // A texture of one image in a buffer view.
  int texture(const FloatImage& display) {
    const std::string png = encodePng(display);
    json["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", png.size()}});
    bytes += png;
    json["images"].push_back(
        {{"bufferView", json["bufferViews"].size() - 1}, {"mimeType", "image/png"}});
    json["textures"].push_back({{"source", json["images"].size() - 1}});
    return static_cast<int>(json["textures"].size()) - 1;
  }

  int node(const Json& node) {
    json["nodes"].push_back(node);
    return static_cast<int>(json["nodes"].size()) - 1;
  }

  std::filesystem::path save(const std::filesystem::path& folder) const {
    Json whole = json;
    whole["buffers"] = {{{"uri", "a.bin"}, {"byteLength", bytes.size()}}};
    std::ofstream(folder / "a.bin", std::ios::binary) << bytes;
    std::ofstream(folder / "a.gltf") << whole.dump(1);
    return folder / "a.gltf";
  }

  // As one binary file (glTF 2.0, 4.4).
  std::string glb() const {
    Json whole = json;
    whole["buffers"] = {{{"byteLength", bytes.size()}}};
    const auto padded = [](std::string text, char with) {
      while (text.size() % 4 != 0) text += with;
      return text;
    };
    const auto word = [](uint32_t value) {
      return std::string(reinterpret_cast<const char*>(&value), sizeof(value));
    };
    const std::string text = padded(whole.dump(), ' ');
    const std::string data = padded(bytes, '\0');
    const auto size = [](const std::string& s) { return static_cast<uint32_t>(s.size()); };
    return "glTF" + word(2) + word(28 + size(text) + size(data)) + word(size(text)) + "JSON" +
           text + word(size(data)) + std::string("BIN\0", 4) + data;
  }
};

inline FloatImage plainPicture(uint32_t width, uint32_t height, std::vector<float> rgb) {
  FloatImage image(width, height, 3);
  for (size_t i = 0; i < image.texels.size(); ++i) image.texels[i] = rgb[i % 3];
  return image;
}

}  // namespace reprise::lab
