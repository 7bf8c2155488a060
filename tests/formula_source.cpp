// SPDX-License-Identifier: MIT
#include "formula_source.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "equations/shading_offset.h"

namespace reprise::lab {
namespace {

constexpr uint32_t kReferenceGrid = 32;

// Where the pixels of a coarse pixel shade, along an axis.
float coarseCentre(uint32_t px, uint32_t coarse, int32_t origin_px) {
  const auto size = static_cast<int32_t>(coarse);
  const int32_t base = (static_cast<int32_t>(px) - origin_px + size) / size * size - size;
  return static_cast<float>(base + origin_px) + 0.5f * static_cast<float>(size);
}

// A checkerboard's renderer knows nothing of the other half: what a technique makes of it shows.
void leaveOut(uint32_t checkerboard, FloatImage& color, FloatImage& depth, FloatImage& motion) {
  for (uint32_t y = 0; y < color.height; ++y) {
    for (uint32_t x = 0; x < color.width; ++x) {
      if ((x + y + checkerboard) % 2 != 0) continue;
      const float nothing = std::numeric_limits<float>::quiet_NaN();
      std::fill_n(color.at(x, y), 4, nothing);
      std::fill_n(depth.at(x, y), 1, nothing);
      std::fill_n(motion.at(x, y), 2, nothing);
    }
  }
}

}  // namespace

FormulaSource::FormulaSource(Device& device, VkExtent2D extent, Formula formula)
    : device_(device),
      info_{.name = "formula",
            .extent = extent,
            .frame_count = 1000,
            .frame_rate = 60.0,
            .depth_kind = REPRISE_DEPTH_PLANAR,
            .plan_is_honoured = true},
      formula_(std::move(formula)),
      // Float colour: the tests' tolerances are the technique's own.
      color_(device, {.format = VK_FORMAT_R32G32B32A32_SFLOAT, .extent = extent}),
      depth_(device, {.format = VK_FORMAT_R32_SFLOAT, .extent = extent}),
      motion_(device, {.format = VK_FORMAT_R32G32_SFLOAT, .extent = extent}) {}

FrameInputs FormulaSource::fill(uint32_t index, const SamplePlan& plan) {
  const VkExtent2D extent = info_.extent;
  FloatImage color(extent.width, extent.height, 4);
  FloatImage depth(extent.width, extent.height, 1);
  FloatImage motion(extent.width, extent.height, 2);
  const float* jitter_px = plan.library.jitter_px;
  const uint32_t coarse = plan.library.coarse_size;
  const auto frame = static_cast<float>(index);
  for (uint32_t y = 0; y < extent.height; ++y) {
    for (uint32_t x = 0; x < extent.width; ++x) {
      eq::vec2 sample_px(coarseCentre(x, coarse, plan.library.coarse_origin_px[0]) - jitter_px[0],
                         coarseCentre(y, coarse, plan.library.coarse_origin_px[1]) - jitter_px[1]);
      if (plan.library.shading_offset == REPRISE_SHADING_OFFSET_HASH_GAUSSIAN) {
        sample_px += eq::shadingOffset(x, y, plan.library.shading_offset_seed,
                                       plan.library.shading_offset_sigma_px,
                                       plan.library.shading_offset_quadrant);
      }
      const Rgb rgb = formula_.color(sample_px.x - frame * formula_.velocity_px[0],
                                     sample_px.y - frame * formula_.velocity_px[1]);
      float* texel = color.at(x, y);
      std::copy(rgb.begin(), rgb.end(), texel);
      texel[3] = 1.0f;
      *depth.at(x, y) = formula_.view_depth;
      // prev_px = px + motion.
      motion.at(x, y)[0] = -formula_.velocity_px[0];
      motion.at(x, y)[1] = -formula_.velocity_px[1];
    }
  }
  if (plan.library.checkerboard != 0) leaveOut(plan.library.checkerboard, color, depth, motion);
  if (formula_.damage) formula_.damage(index, color, depth, motion);
  upload(device_, color_, color);
  upload(device_, depth_, depth);
  upload(device_, motion_, motion);

  FrameInputs inputs;
  inputs.index = index;
  inputs.extent = extent;
  inputs.color = &color_;
  inputs.depth = &depth_;
  inputs.motion = &motion_;
  inputs.jitter_px[0] = jitter_px[0];
  inputs.jitter_px[1] = jitter_px[1];
  inputs.reset = index == 0;
  inputs.coarse_size = coarse;
  std::copy_n(plan.library.coarse_origin_px, 2, inputs.coarse_origin_px);
  inputs.checkerboard = plan.library.checkerboard;
  return inputs;
}

FrameInputs FormulaSource::frame(VkCommandBuffer, uint32_t index, const SamplePlan& plan) {
  return fill(index, plan);
}

FrameGeometry FormulaSource::geometry(uint32_t index) {
  const VkExtent2D extent = info_.extent;
  FrameGeometry geometry{.motion_px = FloatImage(extent.width, extent.height, 2),
                         .view_depth = FloatImage(extent.width, extent.height, 1),
                         .previous_view_depth = FloatImage(extent.width, extent.height, 1),
                         .reset = index == 0};
  for (size_t i = 0; i < geometry.view_depth.texelCount(); ++i) {
    geometry.motion_px.texels[2 * i] = -formula_.velocity_px[0];
    geometry.motion_px.texels[2 * i + 1] = -formula_.velocity_px[1];
    geometry.view_depth.texels[i] = formula_.view_depth;
    geometry.previous_view_depth.texels[i] = formula_.view_depth;
  }
  return geometry;
}

std::optional<FloatImage> FormulaSource::reference(uint32_t index) {
  const VkExtent2D extent = info_.extent;
  FloatImage image(extent.width, extent.height, 3);
  const auto frame = static_cast<float>(index);
  for (uint32_t y = 0; y < extent.height; ++y) {
    for (uint32_t x = 0; x < extent.width; ++x) {
      float weights = 0.0f;
      for (uint32_t s = 0; s < kReferenceGrid * kReferenceGrid; ++s) {
        float u = (static_cast<float>(s % kReferenceGrid) + 0.5f) / kReferenceGrid;
        float v = (static_cast<float>(s / kReferenceGrid) + 0.5f) / kReferenceGrid;
        float weight = 1.0f;
        if (const float sigma = formula_.reference_sigma_px; sigma > 0.0f) {
          // Over three deviations to each side of the centre.
          u = 0.5f + 6.0f * sigma * (u - 0.5f);
          v = 0.5f + 6.0f * sigma * (v - 0.5f);
          weight = std::exp(-0.5f * ((u - 0.5f) * (u - 0.5f) + (v - 0.5f) * (v - 0.5f)) /
                            (sigma * sigma));
        }
        weights += weight;
        const Rgb rgb = formula_.color(static_cast<float>(x) + u - frame * formula_.velocity_px[0],
                                       static_cast<float>(y) + v - frame * formula_.velocity_px[1]);
        for (size_t c = 0; c < 3; ++c) {
          image.at(x, y)[c] += weight * rgb[c];
        }
      }
      for (size_t c = 0; c < 3; ++c) image.at(x, y)[c] /= weights;
    }
  }
  return image;
}

FloatImage resolveFrames(Resolver& resolver, FormulaSource& source, uint32_t frames, uint32_t first,
                         const std::function<void(FrameInputs&)>& change) {
  Device& device = resolver.device();
  for (uint32_t index = first; index < first + frames; ++index) {
    FrameInputs inputs = source.fill(index, resolver.plan(index));
    if (change) change(inputs);
    device.submitAndWait(
        [&](VkCommandBuffer commands) { resolver.record(commands, inputs, nullptr); });
  }
  return download(device, resolver.output());
}

std::vector<std::string> everyTechnique() {
  std::vector<std::string> names;
  for (uint32_t i = 0; i < repriseGetTechniqueCount(); ++i) {
    const RepriseTechniqueInfo& info = *repriseGetTechnique(i);
    names.emplace_back(info.name);
    for (uint32_t p = 0; p < info.preset_count; ++p) {
      names.push_back(std::string(info.name) + ":preset=" + info.presets[p].name);
    }
  }
  return names;
}

}  // namespace reprise::lab
