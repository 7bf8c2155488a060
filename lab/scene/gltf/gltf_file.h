// SPDX-License-Identifier: MIT
//
// A glTF 2.0 file in memory. TinyGLTF takes the JSON apart but trusts numbers in it; everything
// that leads to memory is checked here: a damaged file throws SceneFileError.
#pragma once

#include <tiny_gltf.h>

#include <cstdint>
#include <filesystem>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace reprise::lab {

class GltfFile {
 public:
  // `.gltf` or `.glb`, with the buffers and images beside it. Images stay compressed.
  explicit GltfFile(const std::filesystem::path& path);

  const tinygltf::Model& model() const { return model_; }
  [[noreturn]] void fail(const std::string& what) const;
  // Something in the file that is left out; each line is kept once.
  void warn(const std::string& what) { warnings_.insert(what); }
  std::vector<std::string> warnings() const { return {warnings_.begin(), warnings_.end()}; }

  // `index` if it is one of `count`, else fails: "what 7 does not exist".
  size_t checked(int index, size_t count, const char* what) const;

  // All elements of an accessor one after another, `components` floats each; finite.
  std::vector<float> floats(int accessor, int components) const;
  // A scalar accessor of unsigned integers.
  std::vector<uint32_t> indices(int accessor) const;
  // The compressed bytes of an image; empty where the file beside is missing.
  std::span<const uint8_t> imageBytes(size_t image) const;

 private:
  // Elements in a buffer view, checked against its end.
  struct Elements {
    const uint8_t* data;
    size_t stride;
  };
  std::span<const uint8_t> viewBytes(int view) const;
  Elements elements(const std::string& name, int view, size_t offset, size_t count,
                    size_t element_bytes, bool strided) const;
  void checkExtensions();

  std::string name_;
  tinygltf::Model model_;
  std::set<std::string> warnings_;
};

}  // namespace reprise::lab
