// SPDX-License-Identifier: MIT
#include "lab/render/light_tiles.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "core/workgroup.h"

namespace reprise::lab {
namespace {

constexpr uint32_t kTilesShader[] = {
#include "light_tiles.comp.inc"
};

}  // namespace

LightTiles::LightTiles(Device& device, const std::vector<GpuLamp>& lamps, VkExtent2D extent,
                       bool cull)
    : lamps_(lamps),
      tiles_{(extent.width + kLightTile_px - 1) / kLightTile_px,
             (extent.height + kLightTile_px - 1) / kLightTile_px},
      cull_(cull) {
  lamps_.resize(std::min<size_t>(lamps_.size(), kMaxLamps));
  // Bound, if empty, by passes that shade.
  const uint64_t tile_bytes = uint64_t{kLampWords} * sizeof(uint32_t) *
                              (lamps_.empty() ? 1 : uint64_t{tiles_.width} * tiles_.height);
  lamp_buffer_ =
      Buffer(device, std::max<size_t>(lamps_.size(), 1) * sizeof(GpuLamp), BufferKind::kHost);
  lamp_buffer_.write(std::span<const GpuLamp>(lamps_));
  tile_buffer_ = Buffer(device, tile_bytes, BufferKind::kHost);
  std::memset(tile_buffer_.mapped(), 0, tile_buffer_.bytes());
  if (lamps_.empty()) return;
  program_ = ComputeProgram(
      device,
      {.name = "light tiles",
       .spirv = kTilesShader,
       .bindings = {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
                    VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER},
       .push_bytes = sizeof(LightTilesConstants),
       .specialization = {lampCount()}});
}

void LightTiles::record(VkCommandBuffer commands, const Buffer& frame, const Image& depth,
                        eq::vec2 jitter_px, float near_plane) const {
  if (lamps_.empty()) return;
  // A workgroup a tile; dispatch counts in groups of the usual size.
  program_.dispatch(commands,
                    {tiles_.width * REPRISE_WORKGROUP_SIZE, tiles_.height * REPRISE_WORKGROUP_SIZE},
                    {uniform(frame), sampled(depth), stored(lamp_buffer_), stored(tile_buffer_)},
                    LightTilesConstants{{jitter_px.x, jitter_px.y}, near_plane, cull_ ? 1u : 0u});
  fullBarrier(commands);
}

std::vector<VkDescriptorType> LightTiles::types() {
  return {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER};
}

std::vector<Bound> LightTiles::bindings() const {
  return {stored(lamp_buffer_), stored(tile_buffer_)};
}

std::vector<uint32_t> LightTiles::counts() const {
  std::vector<uint32_t> counts;
  if (lamps_.empty()) return counts;
  const auto* words = static_cast<const uint32_t*>(tile_buffer_.mapped());
  for (uint32_t tile = 0; tile < tiles_.width * tiles_.height; ++tile) {
    uint32_t count = 0;
    for (uint32_t word = 0; word < kLampWords; ++word) {
      count += static_cast<uint32_t>(std::popcount(words[kLampWords * tile + word]));
    }
    counts.push_back(count);
  }
  return counts;
}

void LightTiles::appendContent(std::vector<uint8_t>& bytes) const {
  const auto* begin = reinterpret_cast<const uint8_t*>(lamps_.data());
  bytes.insert(bytes.end(), begin, begin + lamps_.size() * sizeof(GpuLamp));
}

}  // namespace reprise::lab
