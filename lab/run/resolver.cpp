// SPDX-License-Identifier: MIT
#include "lab/run/resolver.h"

namespace reprise::lab {
namespace {

// The frames of a sequence are submitted one at a time and waited for.
constexpr uint32_t kFramesInFlight = 1;

OwnedContext createContext(Device& device, const TechniqueChoice& choice, const SourceInfo& source,
                           VkExtent2D output_extent) {
  if (choice.grid > 1 && !source.plan_is_honoured) {
    throw UsageError("technique '" + choice.name + "' works on scenes only: '" + source.name +
                     "' was sampled when it was written");
  }
  std::vector<RepriseSettingValue> values = choice.values();
  // Frames from disk were shaded long ago.
  const bool requests = (choice.library->flags & REPRISE_TECHNIQUE_REQUESTS) != 0;
  if (requests && !source.plan_is_honoured) values.push_back({"requests", 0.0, "false"});
  RepriseContextInfo info{};
  info.instance = device.instance();
  info.physical_device = device.physicalDevice();
  info.device = device.handle();
  info.get_instance_proc_addr = device.getInstanceProcAddr();
  info.technique = choice.library->name;
  info.preset = choice.preset.empty() ? nullptr : choice.preset.c_str();
  info.settings = values.data();
  info.setting_count = static_cast<uint32_t>(values.size());
  info.max_input_extent = source.extent;
  info.max_output_extent = output_extent;
  info.frames_in_flight = kFramesInFlight;
  info.depth_kind = source.depth_kind;
  info.flags = source.context_flags;
  OwnedContext context(info);
  context.prepare();
  return context;
}

RepriseImage asInput(const Image* image) {
  if (image == nullptr) return {};
  return {image->view(), image->extent(), VK_IMAGE_LAYOUT_GENERAL};
}

}  // namespace

Resolver::Resolver(Device& device, const TechniqueChoice& choice, const SourceInfo& source,
                   VkExtent2D output_extent)
    : device_(device),
      choice_(choice),
      context_(createContext(device, choice, source, output_extent)),
      output_(device, {.format = VK_FORMAT_R32G32B32A32_SFLOAT,
                       .extent = output_extent.width > 0 ? output_extent : source.extent}),
      pass_names_(context_.passNames()) {}

SamplePlan Resolver::plan(uint32_t frame_index, Timestamps* timestamps) {
  SamplePlan plan{.library = context_.plan(frame_index), .grid = choice_.grid, .request = {}};
  const RepriseSampleRequests requests = context_.sampleRequests();
  if (requests.buffer != VK_NULL_HANDLE) {
    plan.request = [this, requests, timestamps](VkCommandBuffer commands,
                                                const FrameInputs& inputs) {
      context_.recordRequest(commands, frameOf(inputs, timestamps));
      return requests;
    };
  }
  return plan;
}

void Resolver::record(VkCommandBuffer commands, const FrameInputs& inputs, Timestamps* timestamps) {
  // A source that does not ask leaves the request out; its queries would then never be written.
  const bool requests = context_.sampleRequests().buffer != VK_NULL_HANDLE;
  if (timestamps != nullptr && requests && !reserved_.has_value()) {
    context_.recordRequest(commands, frameOf(inputs, timestamps));
  }
  const RepriseFrame frame = frameOf(inputs, timestamps);
  reserved_.reset();
  context_.record(commands, frame);
}

RepriseFrame Resolver::frameOf(const FrameInputs& inputs, Timestamps* timestamps) {
  RepriseFrame frame{};
  frame.frame_index = inputs.index;
  frame.input_extent = inputs.extent;
  frame.output_extent = inputs.output_extent;
  frame.color = asInput(inputs.color);
  frame.depth = asInput(inputs.depth);
  frame.motion = asInput(inputs.motion);
  frame.reactive = asInput(inputs.reactive);
  frame.id = asInput(inputs.id);
  frame.extra = asInput(inputs.extra);
  frame.depth_samples = asInput(inputs.depth_samples);
  for (size_t i = 0; i < motion_back_.size(); ++i) {
    motion_back_[i] = asInput(inputs.motion_back[i]);
  }
  frame.motion_back = motion_back_.data();
  frame.motion_back_count = REPRISE_MAX_MOTION_BACK;
  frame.output = asInput(&output_);
  frame.jitter_px[0] = inputs.jitter_px[0];
  frame.jitter_px[1] = inputs.jitter_px[1];
  frame.motion_scale[0] = 1.0f;
  frame.motion_scale[1] = 1.0f;
  frame.near_plane = inputs.near_plane;
  frame.far_plane = inputs.far_plane;
  frame.camera = inputs.camera.has_value() ? &*inputs.camera : nullptr;
  frame.pre_exposure = inputs.pre_exposure;
  frame.frame_time_s = inputs.frame_time_s;
  frame.reset = inputs.reset ? 1 : 0;
  frame.coarse_size = inputs.coarse_size;
  frame.coarse_origin_px[0] = inputs.coarse_origin_px[0];
  frame.coarse_origin_px[1] = inputs.coarse_origin_px[1];
  frame.checkerboard = inputs.checkerboard;
  if (timestamps != nullptr) {
    frame.timestamps = timestamps->pool();
    if (!reserved_.has_value()) reserved_ = timestamps->reserve(pass_names_);
    frame.first_timestamp = *reserved_;
  }
  return frame;
}

uint64_t Resolver::historyBytes() const {
  uint64_t bytes = 0;
  for (const RepriseMemoryItem& item : memory()) bytes += item.bytes;
  return bytes;
}

std::vector<std::pair<const RepriseSettingInfo*, double>> Resolver::settings() const {
  std::vector<std::pair<const RepriseSettingInfo*, double>> values;
  for (uint32_t i = 0; i < choice_.library->setting_count; ++i) {
    const RepriseSettingInfo& info = choice_.library->settings[i];
    values.emplace_back(&info, context_.get(info.name));
  }
  return values;
}

}  // namespace reprise::lab
