// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/effort.h"
#include "core/technique.h"

namespace reprise {

// What prepare builds. History images survive a new prepare where they stay the same.
struct Prepared {
  std::unique_ptr<Technique> technique;
  std::vector<std::unique_ptr<HistoryImage>> histories;
  std::vector<std::unique_ptr<ComputePass>> passes;
  std::unique_ptr<ConstantRing> constants;
  std::unique_ptr<DeviceBuffer> requests;  // null: none are made
  uint32_t request_capacity = 0;           // entries
  uint32_t request_bins = 0;               // words behind them
};

// Hands a technique its passes and images while it records.
class Recorder {
 public:
  Recorder(const Prepared& prepared, const HistoryImage& float_placeholder,
           const HistoryImage& uint_placeholder, RecordTarget target)
      : prepared_(prepared),
        float_placeholder_(float_placeholder),
        uint_placeholder_(uint_placeholder),
        target_(target) {}

  PassRecording pass(PassHandle handle) {
    return PassRecording(*prepared_.passes[handle], target_, handle);
  }
  const HistoryImage& history(HistoryHandle handle) const { return *prepared_.histories[handle]; }
  VkBuffer requests() const { return prepared_.requests->handle(); }
  uint32_t requestCapacity() const { return prepared_.request_capacity; }
  // An optional input, or a 1 x 1 image in its place: every binding must hold a descriptor.
  RepriseImage orFloatPlaceholder(const RepriseImage& image) const;
  RepriseImage orUintPlaceholder(const RepriseImage& image) const;

 private:
  const Prepared& prepared_;
  const HistoryImage& float_placeholder_;
  const HistoryImage& uint_placeholder_;
  RecordTarget target_;
};

class Context {
 public:
  explicit Context(const RepriseContextInfo& info);
  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  void setSettings(const RepriseSettingValue* values, uint32_t count);
  double getSetting(const char* name) const;
  void holdFrameTime(double measured_s, double target_s);
  void resize(VkExtent2D max_input_extent, VkExtent2D max_output_extent);
  void prepare();
  void reset() { reset_pending_ = true; }
  // Extents {0, 0}: the maximum.
  void plan(uint64_t frame_index, VkExtent2D input, VkExtent2D output,
            RepriseSamplePlan& plan) const;
  void record(VkCommandBuffer commands, const RepriseFrame& frame);
  void recordRequest(VkCommandBuffer commands, const RepriseFrame& frame);
  void sampleRequests(RepriseSampleRequests& requests) const;
  uint32_t memory(RepriseMemoryItem* items, uint32_t capacity) const;
  uint32_t passCount() const { return static_cast<uint32_t>(prepared_.passes.size()); }
  const char* passName(uint32_t index) const;
  void report(RepriseMessageSeverity severity, const std::string& text) const;

 private:
  // What the next frame must know of this one.
  struct Previous {
    VkExtent2D input_extent{};
    VkExtent2D output_extent{};
    eq::vec2 jitter_px{};
    bool camera_moves = false;  // against the frame before it
    float pre_exposure = 1.0f;
    std::optional<RepriseCamera> camera;
  };
  void setExtents(VkExtent2D max_input_extent, VkExtent2D max_output_extent);
  void createSamplers();
  void requireRequests() const;
  // `shaded`: colour and output are there already.
  FrameState frameState(const RepriseFrame& frame, bool shaded) const;
  Recorder beginRecording(VkCommandBuffer commands, const RepriseFrame& frame);

  const TechniqueEntry& entry_;
  Gpu gpu_;
  Settings settings_;
  EffortControl effort_;
  RepriseDepthKind depth_kind_;
  uint32_t flags_;
  uint32_t frames_in_flight_;
  RepriseMessageCallback message_callback_;
  void* message_user_;
  VkExtent2D max_input_extent_{};
  VkExtent2D max_output_extent_{};
  VkSampler nearest_ = VK_NULL_HANDLE;
  VkSampler linear_ = VK_NULL_HANDLE;
  std::unique_ptr<HistoryImage> float_placeholder_;
  std::unique_ptr<HistoryImage> uint_placeholder_;
  std::unique_ptr<Technique> planner_;  // answers plan() before prepare
  Prepared prepared_;
  bool needs_prepare_ = true;
  bool reset_pending_ = true;
  bool request_recorded_ = false;
  uint64_t record_ = 0;
  Previous previous_;
};

// Resolves {0, 0} and throws Error, in one line, where the technique cannot work on these extents.
void checkExtents(const RepriseTechniqueInfo& technique, VkExtent2D max_input,
                  VkExtent2D max_output, VkExtent2D& input, VkExtent2D& output);

// Throws Error, in one line, when a frame breaks the contract of reprise.h. Not `shaded`: a
// request, for which colour and output need not exist. `input` and `output` receive the extents
// with {0, 0} resolved.
void checkFrame(const RepriseFrame& frame, const RepriseTechniqueInfo& technique,
                RepriseDepthKind depth_kind, VkExtent2D max_input, VkExtent2D max_output,
                bool shaded, VkExtent2D& input, VkExtent2D& output);

}  // namespace reprise
