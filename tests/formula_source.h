// SPDX-License-Identifier: MIT
//
// Frames that are formulas: what a pixel holds is the formula at its jittered sample position,
// minus the path that content has moved since frame 0.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>

#include "lab/frame_inputs.h"
#include "lab/run/resolver.h"
#include "lab/vk/image.h"

namespace reprise::lab {

using Rgb = std::array<float, 3>;

struct Formula {
  std::function<Rgb(float x_px, float y_px)> color = [](float, float) {
    return Rgb{0.5f, 0.5f, 0.5f};
  };
  // px a frame by which content moves.
  float velocity_px[2] = {0.0f, 0.0f};
  // Deviation of the reference's Gaussian; 0: a box of 1 px.
  float reference_sigma_px = 0.0f;
  float view_depth = 10.0f;
  // Changes the texels (RGBA, depth, motion) of a frame after the formula has filled them.
  std::function<void(uint32_t frame, FloatImage& color, FloatImage& depth, FloatImage& motion)>
      damage;
};

class FormulaSource final : public FrameSource {
 public:
  FormulaSource(Device& device, VkExtent2D extent, Formula formula);

  const SourceInfo& info() const override { return info_; }
  FrameInputs frame(VkCommandBuffer commands, uint32_t index, const SamplePlan& plan) override;
  std::optional<FloatImage> reference(uint32_t index) override;  // 32 x 32 samples, box
  FrameGeometry geometry(uint32_t index) override;

  // Makes the frame's images at once, outside a command buffer.
  FrameInputs fill(uint32_t index, const SamplePlan& plan);

 private:
  Device& device_;
  SourceInfo info_;
  Formula formula_;
  Image color_, depth_, motion_;
  FrameInputs inputs_;
};

// Resolves `frames` frames, from frame 0 on or from `first`, and gives the last output, RGBA.
FloatImage resolveFrames(Resolver& resolver, FormulaSource& source, uint32_t frames,
                         uint32_t first = 0, const std::function<void(FrameInputs&)>& change = {});

// Every technique of the library by its defaults, then each preset, as the command line names them.
std::vector<std::string> everyTechnique();

}  // namespace reprise::lab
