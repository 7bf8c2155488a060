// SPDX-License-Identifier: MIT
#include "lab/render/coarse_shading.h"

#include <array>

#include "lab/render/coarse_list.h"

namespace reprise::lab {
namespace {

constexpr uint32_t kListShader[] = {
#include "coarse_list.comp.inc"
};
constexpr uint32_t kCoarseShader[] = {
#include "coarse.comp.inc"
};
constexpr uint32_t kCheckerboardShader[] = {
#include "checkerboard.comp.inc"
};

// Before the items (coarse.glsl): groups to dispatch, the number of items, and that of each strip.
// Groups lie in rows, as many of which are dispatched as there are items: one row alone might be
// longer than a device allows.
constexpr uint32_t kGroupsARow = 64;
using Head = std::array<uint32_t, 4 + kStrips>;
constexpr Head kNoItems = {kGroupsARow, 0, 1};
constexpr uint32_t kItemBytes = 8;

}  // namespace

CoarseShading::CoarseShading(Device& device, uint32_t size, VkExtent2D extent,
                             const std::vector<VkDescriptorType>& types,
                             const std::vector<uint32_t>& specialization)
    : size_(size), extent_(extent) {
  ComputeProgramInfo info{.name = "checkerboard",
                          .spirv = kCheckerboardShader,
                          .bindings = followedBy(types, {VK_DESCRIPTOR_TYPE_STORAGE_IMAGE}),
                          .push_bytes = sizeof(CoarseConstants),
                          .specialization = specialization};
  if (size > 1) {
    const uint64_t items = uint64_t{kStrips} * stripCapacity(extent.width, extent.height, size);
    items_ = Buffer(device, sizeof(Head) + kItemBytes * items, BufferKind::kDevice);
    info.name = "list of coarse pixels";
    info.spirv = kListShader;
    info.bindings.push_back(VK_DESCRIPTOR_TYPE_STORAGE_BUFFER);
    info.specialization.push_back(size);
    list_program_ = ComputeProgram(device, info);
    info.name = "coarse pixels";
    info.spirv = kCoarseShader;
  }
  shade_program_ = ComputeProgram(device, info);
}

void CoarseShading::record(VkCommandBuffer commands, const std::vector<Bound>& bound,
                           const Image& color, const CoarseConstants& constants) const {
  if (size_ == 1) {
    shade_program_.dispatch(commands, {(extent_.width + 1) / 2, extent_.height},
                            followedBy(bound, {stored(color)}), constants);
    fullBarrier(commands);
    return;
  }
  const std::vector<Bound> with_items = followedBy(bound, {stored(color), stored(items_)});
  vkCmdUpdateBuffer(commands, items_.handle(), 0, sizeof(kNoItems), kNoItems.data());
  fullBarrier(commands);
  const VkExtent2D listed = {listedCoarsePixels(extent_.width, size_),
                             listedCoarsePixels(extent_.height, size_)};
  list_program_.dispatch(commands, listed, with_items, constants);
  fullBarrier(commands);
  shade_program_.dispatchIndirect(commands, items_.handle(), with_items, constants);
  fullBarrier(commands);
}

}  // namespace reprise::lab
