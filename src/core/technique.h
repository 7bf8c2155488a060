// SPDX-License-Identifier: MIT
//
// What a technique is to the library: a table of settings, a sample plan, the images and passes
// that it needs, and how it records them. One folder in src/techniques, one line in
// technique_list.cpp.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/compute_pass.h"
#include "core/effort.h"
#include "core/gpu.h"
#include "core/settings.h"
#include "equations/language.h"
#include "reprise/reprise.h"

namespace reprise {

struct PlanRequest {
  uint64_t frame_index;
  VkExtent2D input_extent;
  VkExtent2D output_extent;
  const Settings& settings;
  // Whether the last two recorded frames had different cameras; false while fewer have come with
  // one.
  bool camera_moves;
};

using HistoryHandle = uint32_t;
using PassHandle = uint32_t;

// Collects what a technique asks for in prepare.
class Declaration {
 public:
  Declaration(const Gpu& gpu, const Settings& settings_, VkExtent2D max_input,
              VkExtent2D max_output)
      : settings(settings_),
        max_input_extent(max_input),
        max_output_extent(max_output),
        gpu_(gpu) {}

  // Whether history may have this format: beyond the few that Vulkan promises, devices differ.
  bool storable(VkFormat format) const { return gpu_.storable(format); }

  HistoryHandle history(const char* name, VkFormat format, VkExtent2D extent, uint32_t copies) {
    histories.push_back({name, format, extent, copies});
    return static_cast<HistoryHandle>(histories.size() - 1);
  }
  PassHandle pass(PassInfo info) {
    passes.push_back(std::move(info));
    return static_cast<PassHandle>(passes.size() - 1);
  }

  // Gives the context its request buffer; the technique's recordRequest fills it. `bins`: words
  // behind its entries that are zero before, for the technique's own counts, and one more.
  void makeRequests(uint32_t bins) {
    makes_requests = true;
    request_bins = bins;
  }

  const Settings& settings;
  VkExtent2D max_input_extent;
  VkExtent2D max_output_extent;
  bool makes_requests = false;
  uint32_t request_bins = 0;

  struct History {
    const char* name;
    VkFormat format;
    VkExtent2D extent;
    uint32_t copies;
  };
  std::vector<History> histories;
  std::vector<PassInfo> passes;

 private:
  const Gpu& gpu_;
};

// A frame after validation, with everything resolved that depends on the frame before.
struct FrameState {
  const RepriseFrame& frame;
  const Settings& settings;
  VkExtent2D input_extent;
  VkExtent2D output_extent;
  VkExtent2D previous_input_extent;   // = input_extent when there is no history
  VkExtent2D previous_output_extent;  // = output_extent when there is no history
  bool has_history;  // false: the first record, after a reset or a change of images
  uint64_t record;   // counts records; the turn of history images
  eq::vec2 jitter_px;
  eq::vec2 previous_jitter_px;
  // To be added to motion in px: non-zero when the host's motion includes jitter.
  eq::vec2 motion_offset_px;
  // view_depth = (x * depth + y) / (z * depth + w)
  eq::vec4 view_depth_coefficients;
  // Expected view depth in the previous frame of a static point at px with view depth z:
  // z * (x * px.x + y * px.y + z_coefficient) + w; (0, 0, 1, 0) without cameras.
  eq::vec4 previous_depth_coefficients;
  float exposure_ratio;  // pre_exposure / pre_exposure of the previous frame
};

class Recorder;

class Technique {
 public:
  virtual ~Technique() = default;
  // A pure function of the request.
  virtual void plan(const PlanRequest& request, RepriseSamplePlan& plan) const = 0;
  virtual void declare(Declaration& declaration) = 0;
  virtual void record(Recorder& recorder, const FrameState& state) = 0;
  // Of techniques with REPRISE_TECHNIQUE_REQUESTS; called before record with the same state.
  virtual void recordRequest(Recorder&, const FrameState&) {}
};

struct TechniqueEntry {
  const RepriseTechniqueInfo* info;
  std::unique_ptr<Technique> (*create)();
  std::span<const EffortRung> rungs = {};  // for repriseHoldFrameTime; empty: it cannot
};

std::span<const TechniqueEntry> techniqueList();
// nullptr when there is none of that name.
const TechniqueEntry* findTechnique(const char* name);

}  // namespace reprise
