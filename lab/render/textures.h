// SPDX-License-Identifier: MIT
//
// A scene's images on the GPU: arrays by size class, all mip levels, one sampler.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "lab/render/frame_data.h"
#include "lab/scene/scene.h"
#include "lab/vk/bindings.h"
#include "lab/vk/texture_array.h"

namespace reprise::lab {

enum class TextureFilter {
  kAniso16,    // up to 16 trilinear lookups along the longer gradient
  kTrilinear,  // between two levels, by the longer gradient
  kNone        // level 0 alone, bilinear
};

// An array of images of one extent and colour space.
struct TextureClass {
  VkExtent2D extent{};
  bool srgb = false;
  std::vector<uint32_t> images;  // numbers in the scene's list, layer by layer
};

// At most kMaxTextureClasses classes. Where images have more extents than that, the class that
// costs fewest texels by it is resized to another one's extent, until they fit.
std::vector<TextureClass> textureClasses(std::span<const SceneImage> images);

class Textures {
 public:
  Textures(Device& device, std::span<const SceneImage> images, TextureFilter filter);
  ~Textures();
  Textures(const Textures&) = delete;
  Textures& operator=(const Textures&) = delete;

  // What GpuMaterial holds for a scene's image: ((class + 1) << 16) | layer; 0 for 0.
  uint32_t reference(uint32_t scene_texture) const;
  // kTextureClasses of textures.glsl.
  uint32_t classCount() const { return class_count_; }
  // kAnisotropy.
  uint32_t anisotropy() const { return filter_ == TextureFilter::kAniso16 ? 16 : 1; }

  // The sampler, then kMaxTextureClasses arrays.
  static std::vector<VkDescriptorType> types();
  std::vector<Bound> bindings() const;

  // Bytes that determine what lookups return, for content hashes.
  void appendContent(std::vector<uint8_t>& bytes) const;

 private:
  Device& device_;
  std::span<const SceneImage> images_;
  TextureFilter filter_;
  uint32_t class_count_ = 0;
  std::vector<uint32_t> references_;
  std::array<TextureArray, kMaxTextureClasses> arrays_;  // beyond class_count_: one white texel
  VkSampler sampler_ = VK_NULL_HANDLE;
};

}  // namespace reprise::lab
