// SPDX-License-Identifier: MIT
//
// Shading by a second drawing of the scene against the depth that visibility left, in fragments of
// one pixel on every device, and of 2 x 2 or 4 x 4 where it has VK_KHR_fragment_shading_rate.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "equations/language.h"
#include "lab/render/frame_data.h"
#include "lab/render/scene_buffers.h"
#include "lab/vk/graphics_program.h"

namespace reprise::lab {

// What visibility saw, and where the colour goes.
struct RasterImages {
  const Image* visible = nullptr;
  const Image* depth = nullptr;
  const Image* color = nullptr;
};

// One frame's shading. With `size` 1 as ShadeConstants says, else as CoarseConstants says too.
struct RasterFrame {
  eq::vec2 jitter_px{0.0f, 0.0f};  // of visibility
  ShadeConstants shade;
  uint32_t size = 1;  // pixels a side of a fragment
  CoarseConstants coarse;
};

class RasterShading {
 public:
  // `types` and `specialization` are those of every pass that shades. Throws DeviceError where
  // fragments cannot count.
  RasterShading(Device& device, const SceneBuffers& buffers, const std::vector<Instance>& instances,
                VkExtent2D extent, const std::vector<VkDescriptorType>& types,
                const std::vector<uint32_t>& specialization);

  // Before commands are recorded. Throws DeviceError where the device has no such fragments.
  void prepare(uint32_t size);

  // Fragments begin at multiples of their size. By as much as this everything is drawn beside the
  // frame, so that the coarse grid does too.
  static VkOffset2D shiftOf(const CoarseConstants& coarse, uint32_t size);
  // What visibility is drawn into where the shift is not {0, 0}. Needs prepare() of such a size.
  RasterImages beside() const { return {&visible_, &depth_, &color_}; }
  // Brings it from there to the frame.
  void copyVisibility(VkCommandBuffer commands, VkOffset2D shift_px,
                      const RasterImages& frame_images) const;

  // Bindings of every pass that shades, with this visibility among them.
  using ShadingBindings = std::function<std::vector<Bound>(const Image& visible)>;

  // After visibility of the same frame and shift; the colour comes to the frame's.
  void record(VkCommandBuffer commands, const RasterImages& frame_images, const RasterFrame& frame,
              const ShadingBindings& bindings) const;

 private:
  void draw(VkCommandBuffer commands, const RasterImages& images, const std::vector<Bound>& bound,
            RasterConstants constants, uint32_t size) const;
  void copyToFrame(VkCommandBuffer commands, const Image& from, VkOffset2D shift_px,
                   const Image& to) const;

  Device& device_;
  const SceneBuffers& buffers_;
  const std::vector<Instance>& instances_;
  VkExtent2D extent_;
  std::vector<VkDescriptorType> types_;
  std::vector<uint32_t> specialization_;
  std::array<GraphicsProgram, kMaxCoarseSize + 1> programs_;  // by size, once prepared
  std::array<bool, kMaxCoarseSize + 1> ready_{};
  // Beside the frame; made for fragments above a pixel.
  Image visible_;
  Image depth_;
  Image color_;
};

}  // namespace reprise::lab
