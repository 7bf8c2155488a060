// SPDX-License-Identifier: MIT
#include "lab/render/scene_source.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include "equations/jitter.h"

namespace reprise::lab {
namespace {

// Vulkan's standard positions, from the pixel's centre.
eq::vec2 standardOffset(uint32_t samples, uint32_t i) {
  if (samples == 4) return eq::rotatedGridOffset(i);
  const float diagonal = i == 0 ? 0.25f : -0.25f;
  return samples == 2 ? eq::vec2(diagonal, diagonal) : eq::vec2(0.0f, 0.0f);
}

// Positions of a frame's samples, as jitters: `samples` (1, 2 or 4) about the plan's jitter, or,
// with a grid of n x n, about the centre of each of its cells, n times closer together.
std::vector<eq::vec2> sampleJitters(eq::vec2 jitter_px, uint32_t n, uint32_t samples) {
  std::vector<eq::vec2> jitters_px;
  const float cells = static_cast<float>(n);
  for (uint32_t y = 0; y < n; ++y) {
    for (uint32_t x = 0; x < n; ++x) {
      const eq::vec2 center = n == 1 ? jitter_px
                                     : eq::vec2(0.5f - (static_cast<float>(x) + 0.5f) / cells,
                                                0.5f - (static_cast<float>(y) + 0.5f) / cells);
      for (uint32_t i = 0; i < samples; ++i) {
        const eq::vec2 offset = standardOffset(samples, i);
        jitters_px.emplace_back(center.x - offset.x / cells, center.y - offset.y / cells);
      }
    }
  }
  return jitters_px;
}

bool belowPixelRate(const SamplePlan& plan) {
  return plan.grid <= 1 && (plan.library.coarse_size > 1 || plan.library.checkerboard != 0);
}

// 1: a checkerboard.
uint32_t coarseSize(const RepriseSamplePlan& sampling) {
  return std::max(sampling.coarse_size, 1u);
}

// What derivatives across coarse pixels, or across a checkerboard's half resolution, add to a
// texture's level (Xiao et al. 2018, section 4); plans subtract it again.
float rateBias(const SamplePlan& plan) {
  if (!belowPixelRate(plan)) return 0.0f;
  if (plan.library.checkerboard != 0) return 1.0f;
  return std::log2(static_cast<float>(plan.library.coarse_size));
}

// Pixels a side that a fragment is shaded for.
uint32_t fragmentSize(const SamplePlan& plan) {
  return belowPixelRate(plan) ? coarseSize(plan.library) : 1;
}

// Of those that only compute passes have, the first in `plan`; "" where there is none.
std::string onlyByCompute(const SamplePlan& plan, uint32_t samples) {
  if (samples > 1 || plan.grid > 1) return "several samples a pixel";
  if (plan.library.checkerboard != 0) return "a checkerboard";
  return "";
}

std::string describedFilter(const ReferenceOptions& reference) {
  std::string text = reference.filter == ReferenceFilter::kBox ? "box" : "gaussian";
  if (reference.shutter > 0.0) {
    char shutter[32];
    std::snprintf(shutter, sizeof(shutter), ", shutter %.3g", reference.shutter);
    text += shutter;
  }
  return text;
}

}  // namespace

SceneSource::SceneSource(Device& device, const SceneRun& run, const SceneSourceOptions& options)
    : device_(device),
      options_(options),
      renderer_(device, run, options.extent, options.frame_rate, options.switches),
      references_(device, renderer_, options.reference) {
  const uint32_t samples = options.switches.samples;
  if (samples != 1 && samples != 2 && samples != 4) {
    throw std::invalid_argument("samples a pixel must be 1, 2 or 4");
  }
  info_ = {.name = run.name,
           .extent = options.extent,
           .frame_count = options.frames,
           .frame_rate = options.frame_rate,
           .depth_kind = REPRISE_DEPTH_REVERSED_INFINITE,
           .context_flags = 0,
           .plan_is_honoured = true,
           .reference_samples = options.reference.samples,
           .reference_filter = describedFilter(options.reference)};
}

void SceneSource::prepare(const SamplePlan& plan) {
  const uint32_t samples = options_.switches.samples;
  if (belowPixelRate(plan) && samples > 1) {
    throw std::invalid_argument("with --spp 4 every pixel is shaded: no coarse shading");
  }
  if (byRaster()) {
    const std::string lacking = onlyByCompute(plan, samples);
    if (!lacking.empty()) {
      throw std::invalid_argument("--shade-by raster cannot shade " + lacking);
    }
    renderer_.prepareRaster(fragmentSize(plan));
  } else {
    prepareCompute(plan);
  }
  if (plan.request) renderer_.prepareServe();
  if (plan.library.motion_back != 0) renderer_.prepareMotionBack();
  if (plan.library.depth_samples != 0) renderer_.prepareDepthSamples();
  if (options_.switches.defer_lights) renderer_.prepareLate();
}

FrameInputs SceneSource::frame(VkCommandBuffer commands, uint32_t index, const SamplePlan& plan) {
  const RepriseSamplePlan& sampling = plan.library;
  renderer_.setFrame(index, sampling.mip_bias + options_.switches.mip_bias + rateBias(plan));
  const auto span = [&](const char* name, const auto& record) {
    if (timestamps_ != nullptr) timestamps_->start(commands, name);
    record();
    if (timestamps_ != nullptr) timestamps_->stop(commands);
  };
  const eq::vec2 shading_px(sampling.jitter_px[0], sampling.jitter_px[1]);
  const bool shading_only = options_.switches.shading_only;
  const eq::vec2 jitter_px = shading_only ? eq::vec2(0.0f, 0.0f) : shading_px;
  const bool defer = options_.switches.defer_lights && plan.grid <= 1;
  const ShadeConstants constants = shadeConstants(plan);
  span("transform", [&] { renderer_.recordTransform(commands, 1); });
  if (renderer_.hasShadows()) span("shadows", [&] { renderer_.recordShadows(commands); });
  const std::vector<eq::vec2> jitters_px =
      sampleJitters(shading_px, plan.grid, options_.switches.samples);
  const bool many = jitters_px.size() > 1;
  if (many) {
    renderer_.recordClearSum(commands);
    renderer_.recordAccumulate(commands, jitters_px, constants, shading_only, timestamps_);
    span("mean",
         [&] { renderer_.recordMean(commands, 1.0f / static_cast<float>(jitters_px.size())); });
  }
  // Depth and motion are those of the frame's one position also where colour has many.
  const CoarseConstants coarse = coarseConstants(plan);
  const VkOffset2D shift_px =
      byRaster() ? RasterShading::shiftOf(coarse, fragmentSize(plan)) : VkOffset2D{0, 0};
  span("visibility", [&] { renderer_.recordVisibility(commands, jitter_px, shift_px); });
  if (renderer_.hasLamps()) {
    span("light tiles", [&] { renderer_.recordLightTiles(commands, jitter_px); });
  }
  span("motion", [&] { renderer_.recordMotion(commands, jitter_px, 1); });

  FrameInputs inputs;
  inputs.index = index;
  inputs.extent = info_.extent;
  inputs.depth = &renderer_.depth();
  inputs.motion = &renderer_.motion();
  inputs.jitter_px[0] = jitter_px.x;
  inputs.jitter_px[1] = jitter_px.y;
  inputs.near_plane = renderer_.nearPlane();
  inputs.camera = renderer_.camera();
  inputs.frame_time_s = static_cast<float>(1.0 / info_.frame_rate);
  inputs.reset = index == 0;
  for (uint32_t age = 1; age <= REPRISE_MAX_MOTION_BACK; ++age) {
    if ((sampling.motion_back & (1u << (age - 1))) == 0) continue;
    span("motion back", [&] { renderer_.recordMotionBack(commands, jitter_px, age); });
    inputs.motion_back[age - 1] = &renderer_.motionBack(age);
  }
  if (sampling.depth_samples != 0) {
    span("depth samples", [&] { renderer_.recordDepthSamples(commands, jitter_px); });
    inputs.depth_samples = &renderer_.depthSamples();
  }
  if (plan.grid <= 1 && plan.request) {
    const RepriseSampleRequests requests = plan.request(commands, inputs);
    span("serve",
         [&] { renderer_.recordServe(commands, requests.buffer, constants.light_layers); });
    inputs.extra = &renderer_.extra();
  }
  if (!many) {
    span("shade", [&] {
      if (byRaster()) {
        renderer_.recordRaster(commands, {jitter_px, constants, fragmentSize(plan), coarse});
      } else {
        shadeByCompute(commands, plan);
      }
    });
  }
  if (belowPixelRate(plan)) {
    inputs.coarse_size = sampling.coarse_size;
    std::copy_n(sampling.coarse_origin_px, 2, inputs.coarse_origin_px);
    inputs.checkerboard = sampling.checkerboard;
  }
  if (defer) {
    span("late light",
         [&] { renderer_.recordLate(commands, jitter_px, options_.switches.late_positions); });
    inputs.late = &renderer_.late();
  }

  inputs.color = &renderer_.color();
  return inputs;
}

ShadeConstants SceneSource::shadeConstants(const SamplePlan& plan) const {
  const RepriseSamplePlan& sampling = plan.library;
  const RenderSwitches& switches = options_.switches;
  const bool offset = sampling.shading_offset == REPRISE_SHADING_OFFSET_HASH_GAUSSIAN;
  // With a grid of samples there is nothing to amortize, and nothing to defer.
  const bool defer = switches.defer_lights && plan.grid <= 1;
  return {.jitter_px = {sampling.jitter_px[0], sampling.jitter_px[1]},
          .unjitter = switches.unjitter_textures ? 1u : 0u,
          .offset_on = offset && plan.grid == 1 ? 1u : 0u,
          .offset_sigma_px = sampling.shading_offset_sigma_px,
          .offset_seed = sampling.shading_offset_seed,
          .offset_quadrant = sampling.shading_offset_quadrant,
          .light_layers = defer ? kLightLayerMain : kAllLightLayers};
}

CoarseConstants SceneSource::coarseConstants(const SamplePlan& plan) const {
  const RepriseSamplePlan& sampling = plan.library;
  const ShadeConstants shade = shadeConstants(plan);
  return {.jitter_px = shade.unjitter != 0 ? glm::vec2(0.0f) : shade.jitter_px,
          .origin_x_px = static_cast<uint32_t>(sampling.coarse_origin_px[0]),
          .origin_y_px = static_cast<uint32_t>(sampling.coarse_origin_px[1]),
          .checkerboard = sampling.checkerboard,
          .light_layers = shade.light_layers,
          .shade_covered = sampling.coarse_covered};
}

void SceneSource::prepareCompute(const SamplePlan& plan) {
  if (belowPixelRate(plan)) renderer_.prepareCoarse(coarseSize(plan.library));
}

void SceneSource::shadeByCompute(VkCommandBuffer commands, const SamplePlan& plan) const {
  if (belowPixelRate(plan)) {
    renderer_.recordCoarse(commands, coarseSize(plan.library), coarseConstants(plan));
  } else {
    renderer_.recordShade(commands, shadeConstants(plan));
  }
}

std::optional<FloatImage> SceneSource::reference(uint32_t index) {
  return references_.reference(index);
}

FrameGeometry SceneSource::geometry(uint32_t index) {
  renderer_.prepareGeometry();
  renderer_.setFrame(index, 0.0f);
  device_.submitAndWait([&](VkCommandBuffer commands) { renderer_.recordGeometry(commands); });
  const FloatImage texels = download(device_, renderer_.geometry());
  const uint32_t width = texels.width;
  const uint32_t height = texels.height;
  FrameGeometry geometry{.motion_px = FloatImage(width, height, 2),
                         .view_depth = FloatImage(width, height, 1),
                         .previous_view_depth = FloatImage(width, height, 1),
                         .reset = index == 0};
  for (size_t i = 0; i < texels.texelCount(); ++i) {
    const float* texel = &texels.texels[4 * i];
    geometry.motion_px.texels[2 * i] = texel[0];
    geometry.motion_px.texels[2 * i + 1] = texel[1];
    geometry.view_depth.texels[i] = texel[2];
    geometry.previous_view_depth.texels[i] = texel[3];
  }
  return geometry;
}

}  // namespace reprise::lab
