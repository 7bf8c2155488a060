// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "lab/render/reference.h"
#include "lab/render/renderer.h"

namespace reprise::lab {

struct SceneSourceOptions {
  VkExtent2D extent{960, 540};
  uint32_t frames = 60;
  double frame_rate = 60.0;
  RenderSwitches switches;
  ReferenceOptions reference;
};

// A live scene as a sequence of frames. Honours the plan: jitter, per-pixel shading offset, mip
// bias, N x N grid, coarse pixels, checkerboard.
class SceneSource final : public FrameSource {
 public:
  SceneSource(Device& device, const SceneRun& run, const SceneSourceOptions& options);

  const SourceInfo& info() const override { return info_; }
  void prepare(const SamplePlan& plan) override;
  FrameInputs frame(VkCommandBuffer commands, uint32_t index, const SamplePlan& plan) override;
  std::optional<FloatImage> reference(uint32_t index) override;
  FrameGeometry geometry(uint32_t index) override;

  void setTimestamps(Timestamps* timestamps) override { timestamps_ = timestamps; }
  uint64_t takeEvaluations() override { return renderer_.takeEvaluations(); }

  // With ShadeBy::kRaster, after frame() of this plan: shades that frame's visibility by compute,
  // to be compared.
  void prepareCompute(const SamplePlan& plan);
  void shadeByCompute(VkCommandBuffer commands, const SamplePlan& plan) const;

  Renderer& renderer() { return renderer_; }
  ReferenceStore& references() { return references_; }

 private:
  bool byRaster() const { return options_.switches.shade_by == ShadeBy::kRaster; }
  ShadeConstants shadeConstants(const SamplePlan& plan) const;
  CoarseConstants coarseConstants(const SamplePlan& plan) const;

  Device& device_;
  SourceInfo info_;
  SceneSourceOptions options_;
  Renderer renderer_;
  ReferenceStore references_;
  Timestamps* timestamps_ = nullptr;
};

}  // namespace reprise::lab
