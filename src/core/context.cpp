// SPDX-License-Identifier: MIT
#include "core/context.h"

#include <algorithm>
#include <cstring>

#include "core/error.h"
#include "core/near_names.h"
#include "equations/reprojection.h"

namespace reprise {
namespace {

RepriseImage orPlaceholder(const RepriseImage& image, const HistoryImage& placeholder) {
  if (image.view != VK_NULL_HANDLE) return image;
  return {placeholder.current(0), placeholder.extent(), VK_IMAGE_LAYOUT_GENERAL};
}

bool sameCamera(const RepriseCamera& a, const RepriseCamera& b) {
  return std::equal(std::begin(a.view), std::end(a.view), std::begin(b.view)) &&
         std::equal(std::begin(a.projection), std::end(a.projection), std::begin(b.projection));
}

// An empty list: a dispatch of no groups, no entries.
constexpr uint32_t kNoRequests[] = {0, 1, 1, 0};

const TechniqueEntry& requireTechnique(const char* name) {
  const TechniqueEntry* entry = findTechnique(name);
  if (entry != nullptr) return *entry;
  std::vector<std::string_view> names;
  for (const TechniqueEntry& known : techniqueList()) names.emplace_back(known.info->name);
  const std::string near = nearNames(name, names);
  fail(REPRISE_ERROR_INVALID_ARGUMENT, "there is no technique '" + std::string(name) + "'" +
                                           (near.empty() ? "" : "; near: " + near));
}

}  // namespace

RepriseImage Recorder::orFloatPlaceholder(const RepriseImage& image) const {
  return orPlaceholder(image, float_placeholder_);
}
RepriseImage Recorder::orUintPlaceholder(const RepriseImage& image) const {
  return orPlaceholder(image, uint_placeholder_);
}

Context::Context(const RepriseContextInfo& info)
    : entry_(requireTechnique(info.technique)),
      settings_(*entry_.info),
      effort_(static_cast<uint32_t>(entry_.rungs.size())),
      depth_kind_(info.depth_kind),
      flags_(info.flags),
      frames_in_flight_(info.frames_in_flight),
      message_callback_(info.message_callback),
      message_user_(info.message_user),
      planner_(entry_.create()) {
  gpu_.device = info.device;
  gpu_.pipeline_cache = info.pipeline_cache;
  if (const char* missing = gpu_.vk.load(info.instance, info.device, info.get_instance_proc_addr)) {
    fail(REPRISE_ERROR_DEVICE, std::string("get_instance_proc_addr does not give ") + missing);
  }
  gpu_.vk.GetPhysicalDeviceMemoryProperties(info.physical_device, &gpu_.memory);
  VkPhysicalDeviceProperties properties{};
  gpu_.vk.GetPhysicalDeviceProperties(info.physical_device, &properties);
  gpu_.limits = properties.limits;
  gpu_.physical_device = info.physical_device;

  if (info.preset != nullptr) settings_.applyPreset(info.preset);
  settings_.apply(info.settings, info.setting_count);
  setExtents(info.max_input_extent, info.max_output_extent);
  try {
    createSamplers();
    float_placeholder_ = std::make_unique<HistoryImage>(gpu_, "float placeholder",
                                                        VK_FORMAT_R32_SFLOAT, VkExtent2D{1, 1}, 1);
    uint_placeholder_ = std::make_unique<HistoryImage>(gpu_, "id placeholder", VK_FORMAT_R32_UINT,
                                                       VkExtent2D{1, 1}, 1);
  } catch (...) {
    gpu_.vk.DestroySampler(gpu_.device, nearest_, nullptr);
    gpu_.vk.DestroySampler(gpu_.device, linear_, nullptr);
    throw;
  }
}

Context::~Context() {
  prepared_ = {};
  gpu_.vk.DestroySampler(gpu_.device, nearest_, nullptr);
  gpu_.vk.DestroySampler(gpu_.device, linear_, nullptr);
}

void Context::createSamplers() {
  VkSamplerCreateInfo info{.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
  info.addressModeU = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  info.addressModeV = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  info.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  check(gpu_.vk.CreateSampler(gpu_.device, &info, nullptr, &nearest_), "nearest sampler");
  info.magFilter = VK_FILTER_LINEAR;
  info.minFilter = VK_FILTER_LINEAR;
  check(gpu_.vk.CreateSampler(gpu_.device, &info, nullptr, &linear_), "linear sampler");
}

void Context::setExtents(VkExtent2D input, VkExtent2D output) {
  if (output.width == 0 && output.height == 0) output = input;
  const uint32_t limit = gpu_.limits.maxImageDimension2D;
  for (const VkExtent2D extent : {input, output}) {
    if (extent.width < 1 || extent.height < 1 || extent.width > limit || extent.height > limit) {
      fail(REPRISE_ERROR_INVALID_ARGUMENT, "maximum extent " + std::to_string(extent.width) + "x" +
                                               std::to_string(extent.height) + " must be in [1, " +
                                               std::to_string(limit) + "] a side");
    }
  }
  const bool upsamples = (entry_.info->flags & REPRISE_TECHNIQUE_UPSAMPLES) != 0;
  if (!upsamples && (output.width != input.width || output.height != input.height)) {
    fail(REPRISE_ERROR_UNSUPPORTED, "technique '" + std::string(entry_.info->name) +
                                        "' cannot upsample: output extent must equal input extent");
  }
  if (output.width < input.width || output.height < input.height) {
    fail(REPRISE_ERROR_INVALID_ARGUMENT,
         "max_output_extent must not be below max_input_extent, width or height");
  }
  max_input_extent_ = input;
  max_output_extent_ = output;
}

void Context::report(RepriseMessageSeverity severity, const std::string& text) const {
  if (message_callback_ != nullptr) message_callback_(severity, text.c_str(), message_user_);
}

void Context::setSettings(const RepriseSettingValue* values, uint32_t count) {
  needs_prepare_ |= settings_.apply(values, count);
}

double Context::getSetting(const char* name) const {
  return settings_.number(settings_.find(name));
}

void Context::holdFrameTime(double measured_s, double target_s) {
  if (entry_.rungs.empty()) {
    fail(REPRISE_ERROR_UNSUPPORTED,
         "technique '" + std::string(entry_.info->name) + "' has nothing to trade for frame time");
  }
  const EffortRung& rung = entry_.rungs[effort_.next(measured_s, target_s)];
  settings_.apply(rung.data(), static_cast<uint32_t>(rung.size()));
}

void Context::resize(VkExtent2D max_input_extent, VkExtent2D max_output_extent) {
  setExtents(max_input_extent, max_output_extent);
  prepared_ = {};
  needs_prepare_ = true;
  reset_pending_ = true;
}

void Context::prepare() {
  if (!needs_prepare_) return;
  Declaration declaration(gpu_, settings_, max_input_extent_, max_output_extent_);
  Prepared next;
  next.technique = entry_.create();
  next.technique->declare(declaration);

  uint32_t constant_bytes = 0;
  for (const PassInfo& info : declaration.passes) {
    next.passes.push_back(
        std::make_unique<ComputePass>(gpu_, info, nearest_, linear_, frames_in_flight_));
    constant_bytes += ConstantRing::alignedSize(gpu_, info.constant_bytes);
  }
  next.constants = std::make_unique<ConstantRing>(gpu_, constant_bytes, frames_in_flight_);

  if (declaration.makes_requests) {
    next.request_capacity = max_input_extent_.width * max_input_extent_.height;
    next.request_bins = declaration.request_bins + 1;
    const uint64_t words = uint64_t{next.request_capacity} + next.request_bins;
    next.requests = std::make_unique<DeviceBuffer>(
        gpu_, "sample requests", sizeof(kNoRequests) + words * sizeof(uint32_t),
        VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT |
            VK_BUFFER_USAGE_TRANSFER_DST_BIT);
  }

  // New images first: should one fail, the old state is whole.
  const auto same = [](const Declaration::History& wanted, const HistoryImage& image) {
    return std::strcmp(image.name(), wanted.name) == 0 && image.format() == wanted.format &&
           image.extent().width == wanted.extent.width &&
           image.extent().height == wanted.extent.height && image.copies() == wanted.copies;
  };
  bool all_kept = true;
  next.histories.resize(declaration.histories.size());
  std::vector<size_t> kept_from(declaration.histories.size(), prepared_.histories.size());
  for (size_t i = 0; i < declaration.histories.size(); ++i) {
    const Declaration::History& wanted = declaration.histories[i];
    for (size_t j = 0; j < prepared_.histories.size(); ++j) {
      if (same(wanted, *prepared_.histories[j])) kept_from[i] = j;
    }
    if (kept_from[i] < prepared_.histories.size()) continue;
    next.histories[i] = std::make_unique<HistoryImage>(gpu_, wanted.name, wanted.format,
                                                       wanted.extent, wanted.copies);
    all_kept = false;
  }
  for (size_t i = 0; i < next.histories.size(); ++i) {
    if (next.histories[i] == nullptr)
      next.histories[i] = std::move(prepared_.histories[kept_from[i]]);
  }
  prepared_ = std::move(next);
  reset_pending_ |= !all_kept;
  request_recorded_ = false;
  needs_prepare_ = false;
}

void Context::plan(uint64_t frame_index, VkExtent2D input, VkExtent2D output,
                   RepriseSamplePlan& plan) const {
  checkExtents(*entry_.info, max_input_extent_, max_output_extent_, input, output);
  const size_t size = plan.size;
  plan = {.size = size, .coarse_size = 1};
  planner_->plan({frame_index, input, output, settings_, previous_.camera_moves}, plan);
}

FrameState Context::frameState(const RepriseFrame& frame, bool shaded) const {
  FrameState state{.frame = frame, .settings = settings_};
  checkFrame(frame, *entry_.info, depth_kind_, max_input_extent_, max_output_extent_, shaded,
             state.input_extent, state.output_extent);
  state.has_history = !reset_pending_ && frame.reset == 0 && record_ > 0;
  state.record = record_;
  state.previous_input_extent = state.has_history ? previous_.input_extent : state.input_extent;
  state.previous_output_extent = state.has_history ? previous_.output_extent : state.output_extent;
  state.jitter_px = eq::vec2(frame.jitter_px[0], frame.jitter_px[1]);
  state.previous_jitter_px = state.has_history ? previous_.jitter_px : state.jitter_px;
  state.motion_offset_px = eq::vec2(0.0f, 0.0f);
  if ((flags_ & REPRISE_CONTEXT_MOTION_INCLUDES_JITTER) != 0) {
    state.motion_offset_px = eq::vec2(state.jitter_px.x - state.previous_jitter_px.x,
                                      state.jitter_px.y - state.previous_jitter_px.y);
  }
  state.view_depth_coefficients =
      eq::viewDepthCoefficients(depth_kind_, frame.near_plane, frame.far_plane);
  state.previous_depth_coefficients = eq::vec4(0.0f, 0.0f, 1.0f, 0.0f);
  if (state.has_history && frame.camera != nullptr && previous_.camera.has_value()) {
    state.previous_depth_coefficients = eq::previousDepthCoefficients(
        frame.camera->view, frame.camera->projection, previous_.camera->view,
        static_cast<float>(state.input_extent.width),
        static_cast<float>(state.input_extent.height));
  }
  state.exposure_ratio = state.has_history ? frame.pre_exposure / previous_.pre_exposure : 1.0f;
  return state;
}

Recorder Context::beginRecording(VkCommandBuffer commands, const RepriseFrame& frame) {
  float_placeholder_->recordInitialLayout(commands);
  uint_placeholder_->recordInitialLayout(commands);
  for (const auto& history : prepared_.histories) history->recordInitialLayout(commands);
  const auto slot = static_cast<uint32_t>(record_ % frames_in_flight_);
  // The request of the same frame has written its constants to the same slot already.
  if (!request_recorded_) prepared_.constants->beginSlot(slot);
  return Recorder(
      prepared_, *float_placeholder_, *uint_placeholder_,
      {commands, slot, prepared_.constants.get(), frame.timestamps, frame.first_timestamp});
}

void Context::record(VkCommandBuffer commands, const RepriseFrame& frame) {
  if (needs_prepare_) {
    fail(REPRISE_ERROR_NOT_PREPARED, "reprisePrepare must be called before recording");
  }
  const FrameState state = frameState(frame, true);
  Recorder recorder = beginRecording(commands, frame);
  prepared_.technique->record(recorder, state);
  request_recorded_ = false;

  previous_.input_extent = state.input_extent;
  previous_.output_extent = state.output_extent;
  previous_.jitter_px = state.jitter_px;
  previous_.pre_exposure = frame.pre_exposure;
  previous_.camera_moves = frame.camera != nullptr && previous_.camera.has_value() &&
                           !sameCamera(*frame.camera, *previous_.camera);
  previous_.camera.reset();
  if (frame.camera != nullptr) previous_.camera = *frame.camera;
  reset_pending_ = false;
  ++record_;
}

void Context::requireRequests() const {
  if ((entry_.info->flags & REPRISE_TECHNIQUE_REQUESTS) == 0) {
    fail(REPRISE_ERROR_UNSUPPORTED,
         "technique '" + std::string(entry_.info->name) + "' makes no sample requests");
  }
  if (needs_prepare_) {
    fail(REPRISE_ERROR_NOT_PREPARED, "reprisePrepare must be called before asking for requests");
  }
  if (prepared_.requests == nullptr) {
    fail(REPRISE_ERROR_UNSUPPORTED,
         "technique '" + std::string(entry_.info->name) + "' is set to make no sample requests");
  }
}

void Context::sampleRequests(RepriseSampleRequests& requests) const {
  requireRequests();
  requests.buffer = prepared_.requests->handle();
  requests.bytes = prepared_.requests->bytes();
}

void Context::recordRequest(VkCommandBuffer commands, const RepriseFrame& frame) {
  requireRequests();
  if (request_recorded_) {
    fail(REPRISE_ERROR_INVALID_ARGUMENT, "the requests of this frame are recorded already");
  }
  const FrameState state = frameState(frame, false);
  // What served the last frame's requests has read them; then the list is emptied, then filled.
  VkMemoryBarrier barrier{.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER};
  barrier.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT;
  barrier.dstAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
  gpu_.vk.CmdPipelineBarrier(
      commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_DRAW_INDIRECT_BIT,
      VK_PIPELINE_STAGE_TRANSFER_BIT, 0, 1, &barrier, 0, nullptr, 0, nullptr);
  gpu_.vk.CmdUpdateBuffer(commands, prepared_.requests->handle(), 0, sizeof(kNoRequests),
                          kNoRequests);
  gpu_.vk.CmdFillBuffer(
      commands, prepared_.requests->handle(),
      sizeof(kNoRequests) + uint64_t{prepared_.request_capacity} * sizeof(uint32_t),
      uint64_t{prepared_.request_bins} * sizeof(uint32_t), 0);
  barrier.srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
  barrier.dstAccessMask = VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT;
  gpu_.vk.CmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TRANSFER_BIT,
                             VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, 0, 1, &barrier, 0, nullptr, 0,
                             nullptr);
  Recorder recorder = beginRecording(commands, frame);
  prepared_.technique->recordRequest(recorder, state);
  request_recorded_ = true;
  barrier.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT;
  barrier.dstAccessMask = VK_ACCESS_INDIRECT_COMMAND_READ_BIT | VK_ACCESS_SHADER_READ_BIT;
  gpu_.vk.CmdPipelineBarrier(
      commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT,
      VK_PIPELINE_STAGE_DRAW_INDIRECT_BIT | VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, 0, 1, &barrier, 0,
      nullptr, 0, nullptr);
}

const char* Context::passName(uint32_t index) const {
  return index < prepared_.passes.size() ? prepared_.passes[index]->name() : nullptr;
}

uint32_t Context::memory(RepriseMemoryItem* items, uint32_t capacity) const {
  if (needs_prepare_) {
    fail(REPRISE_ERROR_NOT_PREPARED, "reprisePrepare must be called before asking for memory");
  }
  const auto images = static_cast<uint32_t>(prepared_.histories.size());
  const uint32_t count = images + (prepared_.requests != nullptr ? 1 : 0);
  for (uint32_t i = 0; i < std::min(count, capacity); ++i) {
    if (i == images) {
      const DeviceBuffer& buffer = *prepared_.requests;
      items[i] = {buffer.name(), VK_FORMAT_UNDEFINED, {0, 0}, 1, buffer.bytes()};
      break;
    }
    const HistoryImage& image = *prepared_.histories[i];
    items[i] = {image.name(), image.format(), image.extent(), image.copies(), image.bytes()};
  }
  return count;
}

}  // namespace reprise
