// SPDX-License-Identifier: MIT
#include "lab/scene/gltf/gltf_materials.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace reprise::lab {
namespace {

// A side beyond this is damage, or more than any device takes.
constexpr int kMostTexels = 16384;
// Blending is shown as a mask that is open where less than half is covered.
constexpr float kBlendCutoff = 0.5f;

const tinygltf::Value* member(const tinygltf::ExtensionMap& extensions, const char* extension,
                              const char* name) {
  const auto found = extensions.find(extension);
  if (found == extensions.end() || !found->second.IsObject() || !found->second.Has(name)) {
    return nullptr;
  }
  return &found->second.Get(name);
}

float finite(double value, float otherwise) {
  const auto narrow = static_cast<float>(value);
  return std::isfinite(narrow) ? narrow : otherwise;
}

float number(const tinygltf::Value* value, float otherwise) {
  return value != nullptr && value->IsNumber() ? finite(value->GetNumberAsDouble(), otherwise)
                                               : otherwise;
}

glm::vec2 pair(const tinygltf::Value* value, glm::vec2 otherwise) {
  if (value == nullptr || !value->IsArray() || value->ArrayLen() != 2) return otherwise;
  return {number(&value->Get(0), otherwise.x), number(&value->Get(1), otherwise.y)};
}

UvMapping mappingOf(int set, const tinygltf::ExtensionMap& extensions) {
  constexpr const char* kTransform = "KHR_texture_transform";
  UvMapping mapping;
  mapping.set =
      static_cast<int>(number(member(extensions, kTransform, "texCoord"), static_cast<float>(set)));
  mapping.offset = pair(member(extensions, kTransform, "offset"), {0.0f, 0.0f});
  mapping.scale = pair(member(extensions, kTransform, "scale"), {1.0f, 1.0f});
  mapping.rotation = number(member(extensions, kTransform, "rotation"), 0.0f);
  return mapping;
}

glm::vec4 factor(const std::vector<double>& from, glm::vec4 otherwise) {
  glm::vec4 to = otherwise;
  for (size_t i = 0; i < std::min<size_t>(from.size(), 4); ++i) {
    const auto at = static_cast<glm::vec4::length_type>(i);
    to[at] = std::max(finite(from[i], otherwise[at]), 0.0f);
  }
  return to;
}

}  // namespace

glm::vec2 UvMapping::apply(glm::vec2 uv) const {
  // KHR_texture_transform: translation * rotation * scale.
  const float c = std::cos(rotation);
  const float s = std::sin(rotation);
  const glm::vec2 scaled = uv * scale;
  return offset + glm::vec2(c * scaled.x + s * scaled.y, c * scaled.y - s * scaled.x);
}

const GltfMaterial& GltfMaterials::material(int index) {
  const auto found = made_.find(index);
  if (found != made_.end()) return found->second;
  const std::vector<tinygltf::Material>& all = file_.model().materials;
  if (index < 0) return made_[-1] = make({}, "default");
  const tinygltf::Material& from = all[file_.checked(index, all.size(), "material")];
  const std::string name = from.name.empty() ? std::to_string(index) : from.name;
  return made_[index] = make(from, name);
}

GltfMaterial GltfMaterials::make(const tinygltf::Material& from, const std::string& name) {
  const tinygltf::PbrMetallicRoughness& pbr = from.pbrMetallicRoughness;
  const glm::vec4 base = factor(pbr.baseColorFactor, glm::vec4(1.0f));
  const bool masked = from.alphaMode == "MASK" || from.alphaMode == "BLEND";
  const float asked = from.alphaMode == "MASK" ? finite(from.alphaCutoff, 0.5f) : kBlendCutoff;
  GltfMaterial made;
  GpuMaterial m{.kind = kMaterialTextured, .normal_scale = 1.0f};
  if (masked && asked > 0.0f) {
    // The texture's alpha is compared alone: the factor moves to the other side.
    made.invisible = base.a < asked;
    m.alpha_cutoff = made.invisible || pbr.baseColorTexture.index < 0 ? 0.0f : asked / base.a;
  }
  m.parameters = glm::vec4(glm::min(glm::vec3(base), glm::vec3(1.0f)),
                           std::clamp(finite(pbr.roughnessFactor, 1.0f), 0.0f, 1.0f));
  m.emission = factor(from.emissiveFactor, glm::vec4(0.0f));
  m.emission *= std::max(
      number(member(from.extensions, "KHR_materials_emissive_strength", "emissiveStrength"), 1.0f),
      0.0f);
  m.emission.w = std::clamp(finite(pbr.metallicFactor, 1.0f), 0.0f, 1.0f);

  // One set of coordinates a vertex: that of the first texture there is.
  std::optional<UvMapping> mapping;
  const auto map = [&](const auto& info) {
    if (info.index < 0) return;
    const UvMapping its = mappingOf(info.texCoord, info.extensions);
    if (!mapping) mapping = its;
    if (*mapping != its) {
      file_.warn("material '" + name + "': textures have different coordinates; those of the " +
                 "base colour are used for all");
    }
    const tinygltf::Model& model = file_.model();
    const tinygltf::Texture& texture =
        model.textures[file_.checked(info.index, model.textures.size(), "texture")];
    if (texture.sampler < 0) return;
    const tinygltf::Sampler& sampler =
        model.samplers[file_.checked(texture.sampler, model.samplers.size(), "sampler")];
    made.repeats = made.repeats && sampler.wrapS == TINYGLTF_TEXTURE_WRAP_REPEAT &&
                   sampler.wrapT == TINYGLTF_TEXTURE_WRAP_REPEAT;
  };
  map(pbr.baseColorTexture);
  map(pbr.metallicRoughnessTexture);
  map(from.normalTexture);
  map(from.occlusionTexture);
  map(from.emissiveTexture);
  if (mapping) made.mapping = *mapping;

  if (!made.invisible) {
    m.color_texture = image(pbr.baseColorTexture.index, ImageRole::kColor, m.alpha_cutoff);
    // A picture that cannot be had has no holes either.
    if (m.color_texture == 0) m.alpha_cutoff = 0.0f;
    m.normal_texture = image(from.normalTexture.index, ImageRole::kNormal, 0.0f);
    m.normal_scale = finite(from.normalTexture.scale, 1.0f);
    m.surface_texture =
        surfaceImage(pbr.metallicRoughnessTexture.index, from.occlusionTexture.index,
                     std::clamp(finite(from.occlusionTexture.strength, 1.0f), 0.0f, 1.0f));
    m.emission_texture = image(from.emissiveTexture.index, ImageRole::kColor, 0.0f);
  }
  if (from.extensions.contains("KHR_materials_unlit")) {
    // A black metal mirrors nothing; what the base colour is, it gives off.
    m.emission = glm::vec4(glm::vec3(m.parameters), 1.0f);
    m.emission_texture = image(pbr.baseColorTexture.index, ImageRole::kColor, m.alpha_cutoff);
    m.parameters = glm::vec4(0.0f, 0.0f, 0.0f, 1.0f);
  }
  geometry_.materials.push_back(m);
  made.number = static_cast<uint32_t>(geometry_.materials.size() - 1);
  return made;
}

std::optional<size_t> GltfMaterials::source(int texture) {
  if (texture < 0) return std::nullopt;
  const tinygltf::Model& model = file_.model();
  const int image = model.textures[file_.checked(texture, model.textures.size(), "texture")].source;
  if (image < 0) {
    file_.warn("texture " + std::to_string(texture) + " has no picture in a known format");
    return std::nullopt;
  }
  const size_t number = file_.checked(image, model.images.size(), "image");
  if (pixels(number).rgba.empty()) return std::nullopt;
  return number;
}

const GltfMaterials::Pixels& GltfMaterials::pixels(size_t image) {
  const auto found = pixels_.find(image);
  if (found != pixels_.end()) return found->second;
  Pixels& pixels = pixels_[image];
  const tinygltf::Image& from = file_.model().images[image];
  const std::span<const uint8_t> bytes = file_.imageBytes(image);
  const std::string name = "image " + std::to_string(image) +
                           (from.uri.empty() || from.uri.size() > 200 ? "" : " (" + from.uri + ")");
  if (bytes.empty()) {
    file_.warn(name + " is missing: white instead");
    return pixels;
  }
  tinygltf::Image decoded;
  std::string error;
  std::string warning;
  const bool read =
      tinygltf::LoadImageData(&decoded, static_cast<int>(image), &error, &warning, 0, 0,
                              bytes.data(), static_cast<int>(bytes.size()), nullptr);
  if (!read || decoded.component != 4 || (decoded.bits != 8 && decoded.bits != 16)) {
    file_.fail(name + " cannot be decoded");
  }
  if (decoded.width < 1 || decoded.height < 1 || decoded.width > kMostTexels ||
      decoded.height > kMostTexels) {
    file_.fail(name + " is larger than 16384 texels a side");
  }
  pixels.width = static_cast<uint32_t>(decoded.width);
  pixels.height = static_cast<uint32_t>(decoded.height);
  if (decoded.bits == 8) {
    pixels.rgba = std::move(decoded.image);
  } else {
    pixels.rgba.resize(decoded.image.size() / 2);
    for (size_t i = 0; i < pixels.rgba.size(); ++i) {
      uint16_t value = 0;
      std::memcpy(&value, decoded.image.data() + 2 * i, sizeof(value));
      pixels.rgba[i] = static_cast<uint8_t>(value >> 8);
    }
  }
  return pixels;
}

uint32_t GltfMaterials::image(int texture, ImageRole role, float alpha_cutoff) {
  const std::optional<size_t> number = source(texture);
  if (!number) return 0;
  uint32_t& made = images_[{*number, role, alpha_cutoff}];
  if (made == 0) {
    const Pixels& from = pixels(*number);
    made = addImage(geometry_, {.width = from.width,
                                .height = from.height,
                                .role = role,
                                .alpha_cutoff = alpha_cutoff,
                                .rgba = from.rgba});
  }
  return made;
}

uint32_t GltfMaterials::surfaceImage(int surface_texture, int occlusion_texture, float strength) {
  const std::optional<size_t> surface = source(surface_texture);
  const std::optional<size_t> occlusion = source(occlusion_texture);
  if (!surface && !occlusion) return 0;
  uint32_t& made = surface_images_[{surface ? static_cast<int>(*surface) : -1,
                                    occlusion ? static_cast<int>(*occlusion) : -1, strength}];
  if (made != 0) return made;
  const Pixels* s = surface ? &pixels(*surface) : nullptr;
  const Pixels* o = occlusion ? &pixels(*occlusion) : nullptr;
  SceneImage to{.role = ImageRole::kMask};
  to.width = std::max(s != nullptr ? s->width : 0, o != nullptr ? o->width : 0);
  to.height = std::max(s != nullptr ? s->height : 0, o != nullptr ? o->height : 0);
  to.rgba.assign(size_t{4} * to.width * to.height, 255);
  const auto texel = [&](const Pixels& from, uint32_t x, uint32_t y) {
    const size_t column = size_t{x} * from.width / to.width;
    const size_t row = size_t{y} * from.height / to.height;
    return &from.rgba[4 * (row * from.width + column)];
  };
  for (uint32_t y = 0; y < to.height; ++y) {
    for (uint32_t x = 0; x < to.width; ++x) {
      uint8_t* out = &to.rgba[4 * (size_t{y} * to.width + x)];
      if (s != nullptr) {
        out[1] = texel(*s, x, y)[1];
        out[2] = texel(*s, x, y)[2];
      }
      if (o != nullptr) {
        const float open = static_cast<float>(texel(*o, x, y)[0]) - 255.0f;
        out[0] = static_cast<uint8_t>(255.5f + strength * open);
      }
    }
  }
  return made = addImage(geometry_, std::move(to));
}

}  // namespace reprise::lab
