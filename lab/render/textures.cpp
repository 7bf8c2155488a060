// SPDX-License-Identifier: MIT
#include "lab/render/textures.h"

#include <algorithm>
#include <limits>

#include "lab/render/image_pyramid.h"
#include "lab/render/reference_file.h"

namespace reprise::lab {
namespace {

uint64_t texelsOf(VkExtent2D extent) {
  return uint64_t{extent.width} * extent.height;
}

// Texels added when the images of `from` take the extent of `to`; less than none is no gain but a
// loss of detail, and counts as much.
uint64_t costOf(const TextureClass& from, const TextureClass& to) {
  const uint64_t a = texelsOf(from.extent);
  const uint64_t b = texelsOf(to.extent);
  return from.images.size() * (a > b ? a - b : b - a);
}

void mergeCheapest(std::vector<TextureClass>& classes) {
  size_t best_from = 0;
  size_t best_to = 0;
  uint64_t best_cost = std::numeric_limits<uint64_t>::max();
  for (size_t from = 0; from < classes.size(); ++from) {
    for (size_t to = 0; to < classes.size(); ++to) {
      if (from == to || classes[from].srgb != classes[to].srgb) continue;
      // Ties go to the larger extent, which keeps detail.
      const uint64_t cost = 2 * costOf(classes[from], classes[to]) +
                            (texelsOf(classes[from].extent) > texelsOf(classes[to].extent) ? 1 : 0);
      if (cost < best_cost) {
        best_cost = cost;
        best_from = from;
        best_to = to;
      }
    }
  }
  std::vector<uint32_t>& images = classes[best_to].images;
  images.insert(images.end(), classes[best_from].images.begin(), classes[best_from].images.end());
  classes.erase(classes.begin() + static_cast<std::ptrdiff_t>(best_from));
}

VkSampler createSampler(Device& device, TextureFilter filter) {
  VkSamplerCreateInfo info{.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
  info.magFilter = VK_FILTER_LINEAR;
  info.minFilter = VK_FILTER_LINEAR;
  info.mipmapMode = VK_SAMPLER_MIPMAP_MODE_LINEAR;
  info.maxLod = filter == TextureFilter::kNone ? 0.0f : VK_LOD_CLAMP_NONE;
  VkSampler sampler = VK_NULL_HANDLE;
  check(vkCreateSampler(device.handle(), &info, nullptr, &sampler), "vkCreateSampler");
  return sampler;
}

}  // namespace

std::vector<TextureClass> textureClasses(std::span<const SceneImage> images) {
  std::vector<TextureClass> classes;
  for (uint32_t i = 0; i < images.size(); ++i) {
    const VkExtent2D extent{images[i].width, images[i].height};
    const bool srgb = images[i].role == ImageRole::kColor;
    auto found = std::find_if(classes.begin(), classes.end(), [&](const TextureClass& c) {
      return c.extent.width == extent.width && c.extent.height == extent.height && c.srgb == srgb;
    });
    if (found == classes.end()) {
      classes.push_back({extent, srgb, {}});
      found = std::prev(classes.end());
    }
    found->images.push_back(i);
  }
  while (classes.size() > kMaxTextureClasses) mergeCheapest(classes);
  return classes;
}

Textures::Textures(Device& device, std::span<const SceneImage> images, TextureFilter filter)
    : device_(device), images_(images), filter_(filter), references_(images.size(), 0) {
  const std::vector<TextureClass> classes = textureClasses(images);
  class_count_ = static_cast<uint32_t>(classes.size());
  for (uint32_t c = 0; c < class_count_; ++c) {
    std::vector<std::vector<std::vector<uint8_t>>> layers;
    for (const uint32_t image : classes[c].images) {
      references_[image] = ((c + 1) << 16) | static_cast<uint32_t>(layers.size());
      layers.push_back(
          imagePyramid(images[image], classes[c].extent.width, classes[c].extent.height));
    }
    arrays_[c] =
        TextureArray(device, classes[c].srgb ? VK_FORMAT_R8G8B8A8_SRGB : VK_FORMAT_R8G8B8A8_UNORM,
                     classes[c].extent, layers);
  }
  for (uint32_t c = class_count_; c < kMaxTextureClasses; ++c) {
    arrays_[c] = TextureArray(device, VK_FORMAT_R8G8B8A8_UNORM, {1, 1}, {{{255, 255, 255, 255}}});
  }
  sampler_ = createSampler(device, filter);
}

Textures::~Textures() {
  vkDestroySampler(device_.handle(), sampler_, nullptr);
}

uint32_t Textures::reference(uint32_t scene_texture) const {
  return scene_texture == 0 ? 0 : references_.at(scene_texture - 1);
}

std::vector<VkDescriptorType> Textures::types() {
  std::vector<VkDescriptorType> types(1 + kMaxTextureClasses, VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE);
  types[0] = VK_DESCRIPTOR_TYPE_SAMPLER;
  return types;
}

std::vector<Bound> Textures::bindings() const {
  std::vector<Bound> bound{separateSampler(sampler_)};
  for (const TextureArray& array : arrays_) bound.push_back(separateImage(array.view()));
  return bound;
}

void Textures::appendContent(std::vector<uint8_t>& bytes) const {
  if (images_.empty()) return;  // the filter changes nothing then
  uint64_t hash = hashBytes(&filter_, sizeof(filter_));
  for (const SceneImage& image : images_) {
    const uint32_t shape[] = {image.width, image.height, static_cast<uint32_t>(image.role)};
    hash = hashBytes(shape, sizeof(shape), hash);
    hash = hashBytes(&image.alpha_cutoff, sizeof(image.alpha_cutoff), hash);
    hash = hashBytes(image.rgba.data(), image.rgba.size(), hash);
  }
  const auto* begin = reinterpret_cast<const uint8_t*>(&hash);
  bytes.insert(bytes.end(), begin, begin + sizeof(hash));
}

}  // namespace reprise::lab
