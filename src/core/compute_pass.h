// SPDX-License-Identifier: MIT
//
// A pass is declared once, in prepare, and recorded as one expression:
//   recorder.pass(resolve_).read(color).read(history.previous(n)).write(output)
//           .constants(k).dispatch(extent);
// Reads, writes and constants bind in the order in which they are named: binding 0, 1, 2 ... of set
// 0.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/gpu.h"

namespace reprise {

enum class Binding : uint8_t {
  kTexel,     // sampler2D or usampler2D with a nearest, clamped sampler: texelFetch, textureGather
  kLinear,    // sampler2D with a linear, clamped sampler
  kStorage,   // image2D, written
  kBuffer,    // storage buffer
  kConstants  // uniform block; at most one, the last
};

struct PassInfo {
  const char* name;
  std::span<const uint32_t> spirv;
  std::vector<Binding> bindings;
  uint32_t constant_bytes;
  std::vector<uint32_t> specialization;  // constant_id i = element i; floats by their bits
};

// Every compute shader of the library has this local size (src/core/workgroup.h).
class ComputePass {
 public:
  static constexpr uint32_t kMaxBindings = 24;

  ComputePass(const Gpu& gpu, const PassInfo& info, VkSampler nearest, VkSampler linear,
              uint32_t frames_in_flight);
  ~ComputePass();
  ComputePass(const ComputePass&) = delete;
  ComputePass& operator=(const ComputePass&) = delete;

  const char* name() const { return name_; }
  uint32_t constantBytes() const { return constant_bytes_; }

 private:
  friend class PassRecording;
  void build(const PassInfo& info, VkSampler nearest, VkSampler linear, uint32_t frames_in_flight);
  void release();

  const Gpu& gpu_;
  const char* name_;
  std::vector<Binding> bindings_;
  uint32_t constant_bytes_;
  VkDescriptorSetLayout set_layout_ = VK_NULL_HANDLE;
  VkPipelineLayout layout_ = VK_NULL_HANDLE;
  VkPipeline pipeline_ = VK_NULL_HANDLE;
  VkDescriptorPool pool_ = VK_NULL_HANDLE;
  std::vector<VkDescriptorSet> sets_;  // one a frame in flight
};

// Where a record call writes: the host's command buffer, the slot of this frame, its timestamps.
struct RecordTarget {
  VkCommandBuffer commands = VK_NULL_HANDLE;
  uint32_t slot = 0;
  ConstantRing* constants = nullptr;
  VkQueryPool timestamps = VK_NULL_HANDLE;
  uint32_t first_timestamp = 0;
};

class PassRecording {
 public:
  PassRecording(ComputePass& pass, const RecordTarget& target, uint32_t pass_index)
      : pass_(pass), target_(target), pass_index_(pass_index) {}

  PassRecording& read(VkImageView view, VkImageLayout layout = VK_IMAGE_LAYOUT_GENERAL);
  PassRecording& read(const RepriseImage& image) { return read(image.view, image.layout); }
  PassRecording& write(VkImageView view);
  PassRecording& buffer(VkBuffer buffer);
  template <typename Constants>
  PassRecording& constants(const Constants& value) {
    return constants(&value, static_cast<uint32_t>(sizeof(Constants)));
  }
  // In the place of binding and dispatching, where a frame has nothing for the pass to do: its
  // timestamps are written all the same.
  void skip();
  // One invocation a pixel of `extent`; then a barrier that lets later passes read what was
  // written.
  void dispatch(VkExtent2D extent);

 private:
  PassRecording& constants(const void* data, uint32_t bytes);
  void writeTimestamp(uint32_t end) const;
  void expect(Binding a, Binding b) const;

  ComputePass& pass_;
  const RecordTarget& target_;
  uint32_t pass_index_;
  uint32_t count_ = 0;
  VkDescriptorImageInfo images_[ComputePass::kMaxBindings] = {};
  VkDescriptorBufferInfo buffers_[ComputePass::kMaxBindings] = {};
};

}  // namespace reprise
