// SPDX-License-Identifier: MIT
//
// Renders one scene: a jittered visibility pass, exact motion, shading in compute at any position.
// All images and buffers are made once; a frame records commands and writes one small buffer.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "equations/language.h"
#include "lab/frame_inputs.h"
#include "lab/render/coarse_shading.h"
#include "lab/render/frame_data.h"
#include "lab/render/light_tiles.h"
#include "lab/render/raster_shading.h"
#include "lab/render/scene_buffers.h"
#include "lab/render/shadow_map.h"
#include "lab/scene/scattered_lamps.h"
#include "lab/scene/scene.h"
#include "lab/vk/compute_program.h"
#include "lab/vk/graphics_program.h"
#include "lab/vk/timestamps.h"

namespace reprise::lab {

// Which pass shades a frame: a compute pass off what visibility saw, or the rasterizer's fragments.
enum class ShadeBy { kCompute, kRaster };

struct RenderSwitches {
  ShadeBy shade_by = ShadeBy::kCompute;
  bool unjitter_textures = false;  // shade at the pixel centre although visibility is jittered
  float mip_bias = 0.0f;           // levels, added to the plan's
  bool defer_lights = false;       // kLightLayerDeferred goes into an image of its own
  uint32_t late_positions = 4;     // a pixel, at which it is shaded: 1 (the centre) or 4
  TextureFilter texture_filter = TextureFilter::kAniso16;
  uint32_t samples = 1;  // a pixel, each with its own visibility and shading: 1, 2 or 4
  // Visibility stays at the pixel centre; only the shading position follows jitter and grid, on the
  // triangle seen there: shading is antialiased, silhouettes are not (as in Yang et al. 2009).
  bool shading_only = false;
  std::optional<uint32_t> lamps;  // scattered over the scene, instead of its own number
  float lamp_reach = 1.0f;        // of their usual range, at the same intensity
  bool cull_lamps = true;         // false: every pixel loops over all of them
  // Cameras see, and move by the pixels of, an image of this extent; {0, 0}: the one rendered. For
  // frames that will be upsampled.
  VkExtent2D view_extent{};
};

class Renderer {
 public:
  Renderer(Device& device, const SceneRun& run, VkExtent2D extent, double frame_rate,
           const RenderSwitches& switches = {});

  VkExtent2D extent() const { return extent_; }
  const Scene& scene() const { return *scene_; }

  // Makes frame `frame` the current one, which may lie between two: uploads cameras, transforms and
  // lights of it and of the frames before (the sequence begins at 0: earlier ones repeat the
  // first).
  void setFrame(double frame, float mip_bias);

  // Before every other pass of a frame: world space of all vertices, now and `frames_back` ago.
  void recordTransform(VkCommandBuffer commands, uint32_t frames_back) const;
  // Then, before anything is shaded: what the sun sees. Nothing in scenes without shadows.
  bool hasShadows() const { return shadow_map_.on(); }
  void recordShadows(VkCommandBuffer commands) { shadow_map_.record(commands); }
  // The passes. Each ends with a barrier: what it wrote is readable by what is recorded next.
  // `shift_px`: RasterShading::shiftOf, of what will be shaded by fragments.
  void recordVisibility(VkCommandBuffer commands, eq::vec2 jitter_px,
                        VkOffset2D shift_px = {0, 0}) const;
  void recordMotion(VkCommandBuffer commands, eq::vec2 jitter_px, uint32_t frames_back) const;
  // After visibility of the same jitter, before anything is shaded: Forward+. Nothing without
  // lamps.
  bool hasLamps() const { return light_tiles_.lampCount() > 0; }
  void recordLightTiles(VkCommandBuffer commands, eq::vec2 jitter_px) const;
  // The same to the frame `frames_back` ago, into motionBack(frames_back); replaces the transforms.
  // prepareMotionBack must have been called.
  void prepareMotionBack();
  void recordMotionBack(VkCommandBuffer commands, eq::vec2 jitter_px, uint32_t frames_back) const;
  // Motion of the frame before and both view depths, without jitter, into geometry(); replaces what
  // the passes of a frame wrote. prepareGeometry must have been called.
  void prepareGeometry();
  void recordGeometry(VkCommandBuffer commands) const;
  void recordShade(VkCommandBuffer commands, const ShadeConstants& constants) const;
  // Shading below the pixels' rate, into color(): a coarse pixel and triangle at a time where
  // `size`, pixels a side of it, is above 1, else half the pixels (constants.checkerboard).
  // prepareCoarse must have been called for the size.
  void prepareCoarse(uint32_t size);
  void recordCoarse(VkCommandBuffer commands, uint32_t size,
                    const CoarseConstants& constants) const;
  // The same two by fragments, with ShadeBy::kRaster: prepareRaster must have been called for the
  // size.
  void prepareRaster(uint32_t size) { raster_->prepare(size); }
  void recordRaster(VkCommandBuffer commands, const RasterFrame& frame) const;
  // The deferred layer of light, by equation hiddenGain, into late(). prepareLate must have been
  // called.
  void prepareLate();
  void recordLate(VkCommandBuffer commands, eq::vec2 jitter_px, uint32_t positions) const;
  // Depth of four samples a pixel, into depthSamples(). prepareDepthSamples must have been called.
  void prepareDepthSamples();
  void recordDepthSamples(VkCommandBuffer commands, eq::vec2 jitter_px) const;
  // Evaluates what a technique's request buffer asks for, into extra().
  // prepareServe must have been called.
  void prepareServe();
  void recordServe(VkCommandBuffer commands, VkBuffer requests, uint32_t light_layers) const;
  // Sums of shaded samples: clear, then for each sample visibility and shade, then the mean. All of
  // `constants` but its jitter. `shading_only` as RenderSwitches has it.
  void recordClearSum(VkCommandBuffer commands) const;
  void recordAccumulate(VkCommandBuffer commands, std::span<const eq::vec2> jitters_px,
                        ShadeConstants constants, bool shading_only, Timestamps* timestamps) const;
  void recordMean(VkCommandBuffer commands, float scale) const;

  const Image& color() const { return color_; }    // RGBA16F
  const Image& depth() const { return depth_; }    // D32, reversed, infinite
  const Image& motion() const { return motion_; }  // RG32F, px
  const Image& sum() const { return sum_; }        // RGBA32F; a: samples
  const Image& extra() const { return extra_; }    // RGBA16F; a: evaluations
  // RG32F, [1, kMaxFramesBack]; valid after recordMotionBack.
  const Image& motionBack(uint32_t frames_back) const { return motion_back_[frames_back - 1]; }
  // RGBA32F: motion (px), view depth, view depth of the same point a frame ago.
  const Image& geometry() const { return geometry_; }
  const Image& late() const { return late_; }                   // RGBA16F
  const Image& depthSamples() const { return depth_samples_; }  // D32, 4 samples
  const RepriseCamera& camera() const { return camera_; }
  float nearPlane() const { return near_plane_; }
  const ShadowMap& shadowMap() const { return shadow_map_; }
  const SceneBuffers& buffers() const { return buffers_; }
  const LightTiles& lightTiles() const { return light_tiles_; }

  // Surface evaluations since the last call; after the recorded work has finished.
  uint64_t takeEvaluations() { return buffers_.takeEvaluations(); }

  // Bytes that determine what setFrame's frame looks like, for content hashes: geometry,
  // textures and their filter, transforms, wind, camera, lights, shadow map and shaders.
  std::vector<uint8_t> contentBytes() const;

 private:
  RepriseCamera cameraAt(double time_s, float* near_plane) const;
  void createPrograms(Device& device, ShadeBy shade_by);
  ComputeProgram createShadeProgram(Device& device, bool accumulate) const;
  // Seconds at which the scene is in frame `frame`; earlier frames than 0 repeat it.
  double timeOf(double frame) const;
  std::vector<uint32_t> shadeSpecialization(bool accumulate) const;
  // 0 to kFirstPassBinding - 1, of every pass that shades.
  static std::vector<VkDescriptorType> shadingTypes();
  std::vector<Bound> shadingBindings() const { return shadingBindings(visible_); }
  std::vector<Bound> shadingBindings(const Image& visible) const;
  void recordShadeWith(VkCommandBuffer commands, const ComputeProgram& program, const Image& color,
                       const ShadeConstants& constants) const;
  // Opaque triangles first: they hide what would be tested in vain.
  void drawScene(VkCommandBuffer commands, const GraphicsProgram& opaque,
                 const GraphicsProgram& tested, eq::vec2 jitter_px) const;

  void recordMotionInto(VkCommandBuffer commands, const Image& image, eq::vec2 jitter_px,
                        uint32_t frames_back) const;

  Device& device_;
  std::unique_ptr<Scene> scene_;
  SceneRun run_;
  VkExtent2D extent_;
  VkExtent2D view_extent_;
  double frame_rate_;
  RepriseCamera camera_{};
  float near_plane_ = 0.1f;

  SceneBuffers buffers_;
  ShadowMap shadow_map_;
  LightTiles light_tiles_;
  Image visible_;
  Image depth_;
  Image motion_;
  Image color_;
  Image sum_;
  // Made by their prepare functions.
  Image extra_;
  Image geometry_;
  Image late_;
  Image depth_samples_;
  std::array<Image, kMaxFramesBack> motion_back_;
  GraphicsProgram visibility_program_;
  GraphicsProgram depth_samples_program_;
  GraphicsProgram depth_samples_tested_program_;
  GraphicsProgram tested_program_;  // where the scene has holes
  ComputeProgram transform_program_;
  ComputeProgram motion_program_;
  ComputeProgram shade_program_;
  ComputeProgram accumulate_program_;
  ComputeProgram mean_program_;
  ComputeProgram serve_program_;
  std::array<CoarseShading, kMaxCoarseSize + 1> coarse_;  // by size
  std::unique_ptr<RasterShading> raster_;                 // with ShadeBy::kRaster
  ComputeProgram late_program_;
};

}  // namespace reprise::lab
