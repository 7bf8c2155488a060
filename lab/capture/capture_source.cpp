// SPDX-License-Identifier: MIT
#include "lab/capture/capture_source.h"

#include <fmt/format.h>

#include <cmath>
#include <cstring>

#include "equations/reprojection.h"
#include "lab/capture/capture_error.h"
#include "lab/capture/output_file.h"

namespace reprise::lab {
namespace {

// Copies into images start at multiples of this: the largest texel.
constexpr uint64_t kUploadAlignment = 16;

}  // namespace

CaptureSource::CaptureSource(Device& device, std::filesystem::path directory, CaptureLayout layout)
    : device_(device), directory_(std::move(directory)) {
  std::error_code error;
  if (!std::filesystem::is_directory(directory_, error)) {
    throw CaptureError(directory_.string(), "", "there is no such directory");
  }
  const std::filesystem::path json = directory_ / "capture.json";
  if (std::filesystem::exists(json, error)) {
    description_ = parseDescription(readWholeFile(json), json.string());
  } else {
    DetectedCapture detected = detectCapture(directory_, layout);
    description_ = std::move(detected.description);
    warnings_ = std::move(detected.assumptions);
    warnings_.insert(warnings_.begin(), json.string() + " is missing; assumed:");
  }
  for (size_t i = 0; i < description_.frames.size(); ++i) {
    const std::filesystem::path file = directory_ / description_.frameFile(i);
    if (!std::filesystem::exists(file, error)) {
      throw CaptureError(file.string(), fmt::format("frame {}", description_.frames[i].number),
                         "the file is missing");
    }
  }
  info_ = {.name = directory_.string(),
           .extent = description_.extent,
           .frame_count = static_cast<uint32_t>(description_.frames.size()),
           .frame_rate = description_.frame_rate,
           .depth_kind = description_.depthKind(),
           .context_flags = description_.motion.includes_jitter
                                ? static_cast<uint32_t>(REPRISE_CONTEXT_MOTION_INCLUDES_JITTER)
                                : 0u,
           .plan_is_honoured = false,
           .reference_samples = description_.reference_samples,
           .reference_filter = description_.reference_filter};
  color_is_half_ = colorIsHalf(readExrHeader(directory_ / description_.frameFile(0)), description_);
  const VkExtent2D extent = info_.extent;
  const auto image = [&](VkFormat format) {
    return Image(device_, {.format = format, .extent = extent});
  };
  color_ = image(color_is_half_ ? VK_FORMAT_R16G16B16A16_SFLOAT : VK_FORMAT_R32G32B32A32_SFLOAT);
  depth_ = image(VK_FORMAT_R32_SFLOAT);
  motion_ = image(VK_FORMAT_R32G32_SFLOAT);
  uint64_t texel_bytes = (color_is_half_ ? 8 : 16) + 4 + 8;
  if (!description_.reactive_channel.empty()) {
    reactive_ = image(VK_FORMAT_R32_SFLOAT);
    texel_bytes += 4;
  }
  if (!description_.id_channel.empty()) {
    id_ = image(VK_FORMAT_R32_UINT);
    texel_bytes += 4;
  }
  const uint64_t pixels = uint64_t{extent.width} * extent.height;
  staging_ = Buffer(device_, pixels * texel_bytes + 5 * kUploadAlignment, BufferKind::kHost);
}

CaptureFrame CaptureSource::take(uint32_t index) {
  CaptureFrame frame;
  const bool read_ahead = ahead_.valid() && ahead_index_ == index;
  if (ahead_.valid() && !read_ahead) {
    ahead_.wait();
    ahead_ = {};
  }
  frame = read_ahead ? ahead_.get() : readCaptureFrame(directory_, description_, index);
  if (index + 1 < info_.frame_count) {
    ahead_index_ = index + 1;
    ahead_ = std::async(std::launch::async, [this, next = index + 1] {
      return readCaptureFrame(directory_, description_, next);
    });
  }
  return frame;
}

FrameInputs CaptureSource::frame(VkCommandBuffer commands, uint32_t index, const SamplePlan&) {
  frame_ = take(index);
  const CaptureFrameInfo& info = description_.frames[index];
  if (frame_.color_is_half != color_is_half_) {
    throw CaptureError((directory_ / description_.frameFile(index)).string(),
                       fmt::format("frame {}: color", info.number),
                       "half and float files in one sequence");
  }
  repairs_.add(frame_.repairs);
  uint64_t offset = 0;
  const auto upload = [&](const Image& image, const void* texels, uint64_t bytes) {
    std::memcpy(static_cast<uint8_t*>(staging_.mapped()) + offset, texels, bytes);
    image.recordUpload(commands, staging_, offset);
    offset = (offset + bytes + kUploadAlignment - 1) / kUploadAlignment * kUploadAlignment;
  };
  upload(color_, frame_.color.data(), frame_.color.size());
  upload(depth_, frame_.depth.data(), 4 * frame_.depth.size());
  upload(motion_, frame_.motion.data(), 4 * frame_.motion.size());
  if (!frame_.reactive.empty())
    upload(reactive_, frame_.reactive.data(), 4 * frame_.reactive.size());
  if (!frame_.id.empty()) upload(id_, frame_.id.data(), 4 * frame_.id.size());
  fullBarrier(commands);

  FrameInputs inputs;
  inputs.index = index;
  inputs.extent = info_.extent;
  inputs.color = &color_;
  inputs.depth = &depth_;
  inputs.motion = &motion_;
  inputs.reactive = frame_.reactive.empty() ? nullptr : &reactive_;
  inputs.id = frame_.id.empty() ? nullptr : &id_;
  inputs.jitter_px[0] = info.jitter_px[0];
  inputs.jitter_px[1] = info.jitter_px[1];
  if (info.camera.has_value()) {
    inputs.near_plane = info.camera->near_plane;
    inputs.far_plane = info.camera->far_plane;
    inputs.camera = libraryCamera(*info.camera);
  }
  inputs.pre_exposure = info.pre_exposure;
  inputs.frame_time_s = static_cast<float>(1.0 / info_.frame_rate);
  inputs.reset = info.reset || index == 0;
  return inputs;
}

std::optional<FloatImage> CaptureSource::reference(uint32_t index) {
  std::error_code error;
  if (!std::filesystem::exists(directory_ / description_.referenceFile(index), error)) {
    return std::nullopt;
  }
  return readCaptureReference(directory_, description_, index);
}

FrameGeometry CaptureSource::geometry(uint32_t index) {
  const uint32_t width = info_.extent.width;
  const uint32_t height = info_.extent.height;
  const CaptureFrameInfo& now = description_.frames[index];
  const CaptureFrameInfo* before = index > 0 ? &description_.frames[index - 1] : nullptr;
  CaptureFrame frame = take(index);
  FrameGeometry geometry{.motion_px = FloatImage(width, height, 2),
                         .view_depth = FloatImage(width, height, 1),
                         .previous_view_depth = FloatImage(width, height, 1),
                         .reset = now.reset || before == nullptr};
  geometry.motion_px.texels = std::move(frame.motion);
  if (description_.motion.includes_jitter && before != nullptr) {
    for (size_t i = 0; i < geometry.motion_px.texels.size(); ++i) {
      geometry.motion_px.texels[i] -= before->jitter_px[i % 2] - now.jitter_px[i % 2];
    }
  }
  const FrameInputs defaults;
  const eq::vec4 view_depth = eq::viewDepthCoefficients(
      info_.depth_kind, now.camera ? now.camera->near_plane : defaults.near_plane,
      now.camera ? now.camera->far_plane : defaults.far_plane);
  // Without cameras static points are expected at the depth that they have now, as the library
  // does.
  eq::vec4 previous_depth(0.0f, 0.0f, 1.0f, 0.0f);
  const auto camera = now.camera ? libraryCamera(*now.camera) : std::nullopt;
  const auto camera_before =
      before != nullptr && before->camera ? libraryCamera(*before->camera) : std::nullopt;
  if (camera && camera_before) {
    previous_depth =
        eq::previousDepthCoefficients(camera->view, camera->projection, camera_before->view,
                                      static_cast<float>(width), static_cast<float>(height));
  }
  for (size_t i = 0; i < frame.depth.size(); ++i) {
    const float depth = eq::viewDepthFromDepth(view_depth, frame.depth[i]);
    const bool covered = std::isfinite(depth) && depth < kBackgroundDepth;
    geometry.view_depth.texels[i] = covered ? depth : kBackgroundDepth;
    const eq::vec2 px(static_cast<float>(i % width) + 0.5f - now.jitter_px[0],
                      static_cast<float>(i / width) + 0.5f - now.jitter_px[1]);
    geometry.previous_view_depth.texels[i] =
        covered ? eq::expectedPreviousDepth(previous_depth, px, depth) : kBackgroundDepth;
  }
  return geometry;
}

}  // namespace reprise::lab
