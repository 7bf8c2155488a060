// SPDX-License-Identifier: MIT
#include "lab/post/post_chain.h"

#include <algorithm>
#include <string>

#include "core/workgroup.h"
#include "lab/post/post_data.h"

namespace reprise::lab {
namespace {

constexpr uint32_t kMeterShader[] = {
#include "meter.comp.inc"
};
constexpr uint32_t kAdaptShader[] = {
#include "adapt.comp.inc"
};
constexpr uint32_t kDownShader[] = {
#include "bloom_down.comp.inc"
};
constexpr uint32_t kUpShader[] = {
#include "bloom_up.comp.inc"
};
constexpr uint32_t kShowShader[] = {
#include "show.comp.inc"
};

// A level's texel reaches about 2^level pixels: six reach a tenth of a picture of 1080 rows.
constexpr uint32_t kMaxBloomLevels = 6;
// Coarser levels would be the picture's mean.
constexpr uint32_t kLeastBloomSide_px = 4;

constexpr VkDescriptorType kSampled = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
constexpr VkDescriptorType kStored = VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
constexpr VkDescriptorType kStorage = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;

uint32_t halfOf(uint32_t side) {
  return (side + 1) / 2;
}

uint32_t groupsOf(uint32_t side) {
  return (side + REPRISE_WORKGROUP_SIZE - 1) / REPRISE_WORKGROUP_SIZE;
}

std::vector<Image> makeLevels(Device& device, VkExtent2D extent) {
  std::vector<Image> levels;
  do {
    extent = {halfOf(extent.width), halfOf(extent.height)};
    levels.emplace_back(device,
                        ImageInfo{.format = VK_FORMAT_R16G16B16A16_SFLOAT, .extent = extent});
  } while (levels.size() < kMaxBloomLevels &&
           halfOf(std::min(extent.width, extent.height)) >= kLeastBloomSide_px);
  return levels;
}

}  // namespace

PostChain::PostChain(Device& device, VkExtent2D extent, const PostSettings& settings)
    : settings_(settings),
      groups_{groupsOf(extent.width), groupsOf(extent.height)},
      shown_(device, {.format = VK_FORMAT_R32G32B32A32_SFLOAT, .extent = extent}),
      levels_(makeLevels(device, extent)),
      sums_(device, uint64_t{groups_.width} * groups_.height * sizeof(float), BufferKind::kDevice),
      eye_(device, sizeof(Adaptation), BufferKind::kDevice),
      meter_(device, {.name = "meter",
                      .spirv = kMeterShader,
                      .bindings = {kSampled, kStorage},
                      .specialization = {}}),
      adapt_(device, {.name = "adapt",
                      .spirv = kAdaptShader,
                      .bindings = {kStorage, kStorage},
                      .push_bytes = sizeof(AdaptConstants),
                      .specialization = {}}),
      down_(device, {.name = "bloom down",
                     .spirv = kDownShader,
                     .bindings = {kSampled, kStored},
                     .specialization = {}}),
      up_(device, {.name = "bloom up",
                   .spirv = kUpShader,
                   .bindings = {kSampled, kStored},
                   .push_bytes = sizeof(BloomConstants),
                   .specialization = {}}),
      show_(device, {.name = "show",
                     .spirv = kShowShader,
                     .bindings = {kSampled, kSampled, kStorage, kStored},
                     .push_bytes = sizeof(ShowConstants),
                     .specialization = {}}) {}

void PostChain::record(VkCommandBuffer commands, const Image& color, float frame_time_s, bool reset,
                       Timestamps* timestamps) const {
  const auto timed = [&](const std::string& name, const auto& pass) {
    if (timestamps != nullptr) timestamps->start(commands, name);
    pass();
    fullBarrier(commands);
    if (timestamps != nullptr) timestamps->stop(commands);
  };
  const VkExtent2D extent = shown_.extent();
  timed("meter", [&] { meter_.dispatch(commands, extent, {sampled(color), stored(sums_)}); });
  timed("adapt", [&] {
    adapt_.dispatch(commands, {1, 1}, {stored(sums_), stored(eye_)},
                    AdaptConstants{groups_.width * groups_.height, extent.width * extent.height,
                                   frame_time_s, settings_.adaptation_s, reset ? 1u : 0u});
  });
  timed("bloom", [&] { bloom(commands, color); });
  timed("show", [&] {
    show_.dispatch(commands, extent,
                   {sampled(color), sampled(levels_[0]), stored(eye_), stored(shown_)},
                   ShowConstants{settings_.bloom});
  });
}

void PostChain::bloom(VkCommandBuffer commands, const Image& color) const {
  for (size_t i = 0; i < levels_.size(); ++i) {
    if (i > 0) fullBarrier(commands);
    const Image& fine = i == 0 ? color : levels_[i - 1];
    down_.dispatch(commands, levels_[i].extent(), {sampled(fine), stored(levels_[i])});
  }
  for (size_t i = levels_.size() - 1; i-- > 0;) {
    fullBarrier(commands);
    up_.dispatch(commands, levels_[i].extent(), {sampled(levels_[i + 1]), stored(levels_[i])},
                 BloomConstants{settings_.bloom_spread});
  }
}

}  // namespace reprise::lab
