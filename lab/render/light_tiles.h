// SPDX-License-Identifier: MIT
//
// Forward+: the scene's lamps, and for each tile of the screen a mask of those that may reach what
// it sees.
#pragma once

#include <cstdint>
#include <vector>

#include "equations/language.h"
#include "lab/render/frame_data.h"
#include "lab/vk/bindings.h"
#include "lab/vk/compute_program.h"

namespace reprise::lab {

class LightTiles {
 public:
  // `cull` false: every tile has every lamp.
  LightTiles(Device& device, const std::vector<GpuLamp>& lamps, VkExtent2D extent, bool cull);

  uint32_t lampCount() const { return static_cast<uint32_t>(lamps_.size()); }
  VkExtent2D tiles() const { return tiles_; }

  // After visibility, whose depth it reads, and before anything is shaded by it. Nothing without
  // lamps.
  void record(VkCommandBuffer commands, const Buffer& frame, const Image& depth, eq::vec2 jitter_px,
              float near_plane) const;

  // kLampsBinding and kLampTilesBinding.
  static std::vector<VkDescriptorType> types();
  std::vector<Bound> bindings() const;

  // Lamps of each tile, row by row; after the recorded work has finished.
  std::vector<uint32_t> counts() const;

  void appendContent(std::vector<uint8_t>& bytes) const;

 private:
  std::vector<GpuLamp> lamps_;
  VkExtent2D tiles_;
  bool cull_;
  Buffer lamp_buffer_;
  Buffer tile_buffer_;
  ComputeProgram program_;
};

}  // namespace reprise::lab
