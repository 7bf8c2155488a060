// SPDX-License-Identifier: MIT
//
// The hinge of the lab. Everything that makes a frame (scenes, the renderer, captures) ends here
// and knows nothing of techniques; everything that turns frames into images begins here and knows
// nothing of scenes. Conventions are those of reprise/reprise.h.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "lab/float_image.h"
#include "lab/frame_geometry.h"
#include "lab/sample_plan.h"
#include "reprise/reprise.h"

namespace reprise::lab {

class Timestamps;  // lab/vk/timestamps.h
class Image;       // lab/vk/image.h; every image of the lab stays in VK_IMAGE_LAYOUT_GENERAL

struct FrameInputs {
  uint32_t index = 0;  // within the sequence, from 0
  VkExtent2D extent{};
  VkExtent2D output_extent{};            // {0, 0}: as RepriseFrame
  const Image* color = nullptr;          // live frames: RGBA16F
  const Image* depth = nullptr;          // live frames: D32
  const Image* motion = nullptr;         // live frames: RG32F, pixels: prev_px = px + motion
  const Image* reactive = nullptr;       // optional
  const Image* id = nullptr;             // optional
  const Image* extra = nullptr;          // optional: served sample requests
  const Image* depth_samples = nullptr;  // optional: D32, 4 samples, where the plan asks for it
  // Optional: RGBA16F, light that was kept out of `color`, by equation hiddenGain; withHiddenLight
  // brings it into what is resolved.
  const Image* late = nullptr;
  // Motion to the frame a frames back at [a - 1]; null where the plan did not ask for it.
  std::array<const Image*, REPRISE_MAX_MOTION_BACK> motion_back{};
  float jitter_px[2] = {0.0f, 0.0f};
  float near_plane = 0.1f;
  float far_plane = 1000.0f;
  std::optional<RepriseCamera> camera;
  float pre_exposure = 1.0f;
  float frame_time_s = 1.0f / 60.0f;
  bool reset = false;
  // How colour was shaded (RepriseFrame).
  uint32_t coarse_size = 1;
  int32_t coarse_origin_px[2] = {0, 0};
  uint32_t checkerboard = 0;
};

struct SourceInfo {
  std::string name;  // "brick/pan", or a capture's directory
  VkExtent2D extent{};
  uint32_t frame_count = 0;
  double frame_rate = 60.0;  // frames a second
  RepriseDepthKind depth_kind = REPRISE_DEPTH_REVERSED_INFINITE;
  uint32_t context_flags = 0;      // RepriseContextFlags
  bool plan_is_honoured = false;   // live scenes: yes; captures were sampled when they were written
  uint32_t reference_samples = 0;  // a pixel; 0: no references
  std::string reference_filter = "box";
};

// A sequence of frames, from a scene or from disk. Deterministic: frame(i, plan) gives the same
// bytes whenever it is asked.
class FrameSource {
 public:
  virtual ~FrameSource() = default;

  virtual const SourceInfo& info() const = 0;

  // Makes what a plan like this one needs beyond the ordinary; before commands are recorded.
  virtual void prepare(const SamplePlan&) {}

  // Records into `commands` what makes frame `index`, and says where its images will be. They are
  // readable by compute shaders after the recorded work and stay valid until the next call.
  virtual FrameInputs frame(VkCommandBuffer commands, uint32_t index, const SamplePlan& plan) = 0;

  // The many-sample reference of the frame in linear RGB; nullopt where there is none.
  virtual std::optional<FloatImage> reference(uint32_t index) = 0;

  // What stands where in frame `index`, for the metrics; submits work of its own, so never between
  // frame() and the end of what it recorded.
  virtual FrameGeometry geometry(uint32_t index) = 0;

  // Times the passes of the frames to come, where the source renders; null stops it.
  virtual void setTimestamps(Timestamps*) {}
  // Shading evaluations of the finished frames since the last call; 0 where they are not known.
  virtual uint64_t takeEvaluations() { return 0; }
};

}  // namespace reprise::lab
