// SPDX-License-Identifier: MIT
//
// What a sun sees, as depth: whoever is farther is in the shade (shadow.glsl). Kept from frame to
// frame where nothing that it shows has changed, as a renderer keeps the map of what stands still.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "lab/render/scene_buffers.h"
#include "lab/vk/graphics_program.h"
#include "lab/vk/image.h"

namespace reprise::lab {

// What a shadow map covers: `matrix` takes the world to Vulkan clip space, orthographic, depth from
// 0 at the caster nearest to the sun to 1.
struct SunView {
  glm::mat4 matrix{1.0f};
  float texel_m = 0.0f;  // side of a texel in the world
  float depth_m = 1.0f;  // length of the depth range
};

// Covers `receivers` seen along `towards_world`, with everything of `casters` between it and the
// sun. The map's grid is fixed in the world: when the ball moves, it moves by whole texels, so that
// the shadows of a still sun do not crawl.
SunView sunView(glm::vec3 towards_world, const Ball& receivers, const Ball& casters,
                uint32_t resolution);

class ShadowMap {
 public:
  // Without a sun that casts shadows at time 0: one texel, never rendered.
  ShadowMap(Device& device, const Scene& scene, const SceneBuffers& buffers);

  // kShadows of shadow.glsl.
  bool on() const { return on_; }
  const Image& image() const { return image_; }  // D32

  // Fills in what the frame, the sequence's `number`, says of the shadow map. `forward_world`: the
  // way the camera looks.
  void setFrame(GpuFrame& frame, double number, const SceneLights& lights, glm::vec3 forward_world);
  // Whether the map that an earlier frame made is this frame's, texel by texel. A frame that made
  // its own makes it again whenever it is recorded: techniques that take turns at it pay alike.
  bool isKept() const;
  // After the transform pass; ends with a barrier. Nothing where there is no shadow, or the map is
  // kept.
  void record(VkCommandBuffer commands);

  void appendContent(std::vector<uint8_t>& bytes) const;

 private:
  const Scene& scene_;
  const SceneBuffers& buffers_;
  bool on_;
  Image image_;
  GraphicsProgram opaque_program_;
  GraphicsProgram tested_program_;

  // All that a map's texels depend on and a frame may change.
  struct Seen {
    glm::mat4 from_world{1.0f};
    std::vector<glm::mat4> transforms;  // of all instances
    glm::vec4 wind{0.0f};               // where something sways
    bool operator==(const Seen&) const = default;
  };
  struct Made {
    Seen seen;
    double number = 0.0;
  };
  Seen seen_;  // of the current frame
  double number_ = 0.0;
  std::optional<Made> made_;  // what the image shows
};

}  // namespace reprise::lab
