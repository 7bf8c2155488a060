// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "lab/capture/layouts.h"
#include "lab/render/scene_source.h"
#include "verbs.h"

namespace reprise::app {

// What a scene is rendered with; a capture has its own.
struct SceneFlags {
  std::string extent = "960x540";
  uint32_t frames = 60;
  double frame_rate = 60.0;
  uint32_t reference_samples = 256;
  std::string reference_filter = "box";
  double reference_shutter = 0.0;
  std::string cache;
  std::string shade_by = "compute";
  bool unjitter_textures = false;
  bool defer_lights = false;
  uint32_t late_positions = 4;
  bool shading_only = false;
  std::string reference_coverage = "pixel";
  float mip_bias = 0.0f;
  std::string texture_filter = "aniso16";
  uint32_t samples_a_pixel = 1;
  std::optional<uint32_t> lamps;

  // Output's extent over the input's, a side: of techniques that upsample, in `compare` alone.
  double scale = 1.0;
  VkExtent2D view_extent{};  // of the output that a smaller scene is for

  void addTo(CLI::App& verb, bool with_reference);
  lab::SceneSourceOptions options() const;
};

// A scene ("brick/pan", "gltf:PATH/path") or a capture's directory. Throws what its parts throw.
std::unique_ptr<lab::FrameSource> openSource(lab::Device& device, const std::string& text,
                                             const SceneFlags& flags, lab::CaptureLayout layout);

// Logs assumptions of a capture once it is open, and repairs once it has run.
void reportCapture(const lab::FrameSource& source, bool finished);

}  // namespace reprise::app
