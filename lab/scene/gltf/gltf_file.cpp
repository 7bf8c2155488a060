// SPDX-License-Identifier: MIT
#include "lab/scene/gltf/gltf_file.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>

#include "lab/scene/gltf/scene_file_error.h"

namespace reprise::lab {
namespace {

// What a file may require of us.
constexpr const char* kKnownExtensions[] = {
    "KHR_lights_punctual", "KHR_materials_emissive_strength", "KHR_materials_unlit",
    "KHR_mesh_quantization", "KHR_texture_transform"};

// Accessors without data are zeros, as many as a number in the file says: bounded, so that damage
// cannot ask for all memory. Vertices of one mesh beyond this are no scene for this lab.
constexpr size_t kMostElements = size_t{1} << 26;

std::string firstLine(std::string text) {
  text = text.substr(0, text.find('\n'));
  while (!text.empty() && (text.back() == ' ' || text.back() == '.')) text.pop_back();
  // Damaged names may hold anything.
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 32) c = '?';
  }
  return text;
}

// Keeps images from files compressed. Those in a buffer view are read by imageBytes, since TinyGLTF
// does not check where they end.
bool keepBytes(tinygltf::Image* image, const int, std::string*, std::string*, int, int,
               const unsigned char* bytes, int size, void*) {
  image->as_is = true;
  if (image->bufferView < 0 && size > 0) image->image.assign(bytes, bytes + size);
  return true;
}

// Component types of glTF 2.0, bytes of one; 0: none of them.
size_t componentBytes(int type) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return 4;
    default:
      return 0;
  }
}

template <typename T>
T loaded(const uint8_t* data) {
  T value;
  std::memcpy(&value, data, sizeof(value));
  return value;
}

template <typename T>
float integerAsFloat(const uint8_t* data, bool normalized) {
  const auto value = static_cast<float>(loaded<T>(data));
  return normalized ? std::max(value / static_cast<float>(std::numeric_limits<T>::max()), -1.0f)
                    : value;
}

float component(const uint8_t* data, int type, bool normalized) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return integerAsFloat<int8_t>(data, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return integerAsFloat<uint8_t>(data, normalized);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return integerAsFloat<int16_t>(data, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return integerAsFloat<uint16_t>(data, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return static_cast<float>(loaded<uint32_t>(data));
    default:
      return loaded<float>(data);
  }
}

uint32_t unsignedInteger(const uint8_t* data, int type) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return *data;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return loaded<uint16_t>(data);
    default:
      return loaded<uint32_t>(data);
  }
}

bool isUnsigned(int type) {
  return type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
         type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
         type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

std::string readBytes(const std::filesystem::path& path, const std::string& name) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) throw SceneFileError(name, "no such file");
  if (!std::filesystem::is_regular_file(path, error)) throw SceneFileError(name, "not a file");
  std::ifstream stream(path, std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  if (!stream.good() && !stream.eof()) throw SceneFileError(name, "cannot be read");
  if (bytes.size() > std::numeric_limits<int32_t>::max()) {
    throw SceneFileError(name, "larger than 2 GiB");
  }
  return bytes;
}

}  // namespace

GltfFile::GltfFile(const std::filesystem::path& path) : name_(path.string()) {
  const std::string bytes = readBytes(path, name_);
  tinygltf::TinyGLTF reader;
  reader.SetImageLoader(keepBytes, nullptr);
  std::string error;
  std::string warning;
  const std::string folder = path.has_parent_path() ? path.parent_path().string() : ".";
  const auto length = static_cast<unsigned int>(bytes.size());
  bool read = false;
  try {
    read =
        bytes.starts_with("glTF")
            ? reader.LoadBinaryFromMemory(&model_, &error, &warning,
                                          reinterpret_cast<const unsigned char*>(bytes.data()),
                                          length, folder)
            : reader.LoadASCIIFromString(&model_, &error, &warning, bytes.data(), length, folder);
  } catch (const std::exception& exception) {
    fail(firstLine(exception.what()));
  }
  if (!read) fail("not a glTF 2.0 file that can be read: " + firstLine(error));
  if (!model_.asset.version.starts_with("2.")) {
    fail("glTF version '" + firstLine(model_.asset.version) + "'; version 2 is needed");
  }
  checkExtensions();
}

void GltfFile::fail(const std::string& what) const {
  throw SceneFileError(name_, what);
}

void GltfFile::checkExtensions() {
  const auto known = [](const std::string& extension) {
    return std::find(std::begin(kKnownExtensions), std::end(kKnownExtensions), extension) !=
           std::end(kKnownExtensions);
  };
  for (const std::string& extension : model_.extensionsRequired) {
    if (!known(extension)) fail("needs the extension " + firstLine(extension) + ", unknown here");
  }
  for (const std::string& extension : model_.extensionsUsed) {
    if (!known(extension)) warn("extension " + firstLine(extension) + " is left out");
  }
}

size_t GltfFile::checked(int index, size_t count, const char* what) const {
  if (index < 0 || static_cast<size_t>(index) >= count) {
    fail(std::string(what) + " " + std::to_string(index) + " does not exist");
  }
  return static_cast<size_t>(index);
}

std::span<const uint8_t> GltfFile::viewBytes(int view) const {
  const tinygltf::BufferView& v =
      model_.bufferViews[checked(view, model_.bufferViews.size(), "buffer view")];
  const std::vector<unsigned char>& buffer =
      model_.buffers[checked(v.buffer, model_.buffers.size(), "buffer")].data;
  if (v.byteOffset > buffer.size() || v.byteLength > buffer.size() - v.byteOffset) {
    fail("buffer view " + std::to_string(view) + " goes beyond its buffer");
  }
  return {buffer.data() + v.byteOffset, v.byteLength};
}

GltfFile::Elements GltfFile::elements(const std::string& name, int view, size_t offset,
                                      size_t count, size_t element_bytes, bool strided) const {
  const std::span<const uint8_t> bytes = viewBytes(view);
  const size_t said = model_.bufferViews[static_cast<size_t>(view)].byteStride;
  const size_t stride = strided && said != 0 ? said : element_bytes;
  if (stride > bytes.size() + element_bytes || offset > bytes.size() ||
      (count > 0 && (count - 1) * stride + element_bytes > bytes.size() - offset)) {
    fail(name + " goes beyond its buffer view");
  }
  return {bytes.data() + offset, stride};
}

std::vector<float> GltfFile::floats(int accessor, int components) const {
  const tinygltf::Accessor& a =
      model_.accessors[checked(accessor, model_.accessors.size(), "accessor")];
  const std::string name = "accessor " + std::to_string(accessor);
  const size_t bytes = componentBytes(a.componentType);
  if (bytes == 0 || tinygltf::GetNumComponentsInType(static_cast<uint32_t>(a.type)) != components) {
    fail(name + " has the wrong type");
  }
  if (a.count > kMostElements) fail(name + " is too long");
  const auto n = static_cast<size_t>(components);
  const size_t element_bytes = n * bytes;
  std::vector<float> values(a.count * n, 0.0f);
  const auto read = [&](const uint8_t* from, size_t element) {
    for (size_t c = 0; c < n; ++c) {
      values[element * n + c] = component(from + c * bytes, a.componentType, a.normalized);
    }
  };
  if (a.bufferView >= 0) {
    const Elements data = elements(name, a.bufferView, a.byteOffset, a.count, element_bytes, true);
    for (size_t i = 0; i < a.count; ++i) read(data.data + i * data.stride, i);
  }
  if (a.sparse.isSparse) {
    const auto& sparse = a.sparse;
    const auto count = static_cast<size_t>(sparse.count);
    if (sparse.count < 0 || count > a.count || !isUnsigned(sparse.indices.componentType) ||
        sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0) {
      fail(name + " is damaged: sparse");
    }
    const size_t index_bytes = componentBytes(sparse.indices.componentType);
    const Elements at =
        elements(name, sparse.indices.bufferView, static_cast<size_t>(sparse.indices.byteOffset),
                 count, index_bytes, false);
    const Elements data =
        elements(name, sparse.values.bufferView, static_cast<size_t>(sparse.values.byteOffset),
                 count, element_bytes, false);
    for (size_t i = 0; i < count; ++i) {
      const uint32_t element =
          unsignedInteger(at.data + i * at.stride, sparse.indices.componentType);
      if (element >= a.count) fail(name + " is damaged: sparse index");
      read(data.data + i * data.stride, element);
    }
  }
  for (const float value : values) {
    if (!std::isfinite(value)) fail(name + " holds a value that is not finite");
  }
  return values;
}

std::vector<uint32_t> GltfFile::indices(int accessor) const {
  const tinygltf::Accessor& a =
      model_.accessors[checked(accessor, model_.accessors.size(), "accessor")];
  const std::string name = "accessor " + std::to_string(accessor);
  if (!isUnsigned(a.componentType) || a.type != TINYGLTF_TYPE_SCALAR || a.bufferView < 0 ||
      a.sparse.isSparse) {
    fail(name + " cannot be indices");
  }
  if (a.count > 3 * kMostElements) fail(name + " is too long");
  const Elements data =
      elements(name, a.bufferView, a.byteOffset, a.count, componentBytes(a.componentType), true);
  std::vector<uint32_t> values(a.count);
  for (size_t i = 0; i < a.count; ++i) {
    values[i] = unsignedInteger(data.data + i * data.stride, a.componentType);
  }
  return values;
}

std::span<const uint8_t> GltfFile::imageBytes(size_t image) const {
  const tinygltf::Image& i = model_.images[image];
  if (i.bufferView >= 0) return viewBytes(i.bufferView);
  return {i.image.data(), i.image.size()};
}

}  // namespace reprise::lab
