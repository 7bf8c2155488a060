// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <string>

#include "core/context.h"
#include "core/error.h"

namespace reprise {
namespace {

std::string text(VkExtent2D extent) {
  return std::to_string(extent.width) + "x" + std::to_string(extent.height);
}

VkExtent2D resolvedExtent(VkExtent2D extent, VkExtent2D maximum, const char* field) {
  if (extent.width == 0 && extent.height == 0) return maximum;
  if (extent.width < 1 || extent.height < 1 || extent.width > maximum.width ||
      extent.height > maximum.height) {
    fail(REPRISE_ERROR_INVALID_ARGUMENT,
         std::string(field) + " " + text(extent) + " must be in [1x1, " + text(maximum) + "]");
  }
  return extent;
}

void checkImage(const RepriseImage& image, const char* field, bool required, VkExtent2D extent) {
  if (image.view == VK_NULL_HANDLE) {
    if (required) fail(REPRISE_ERROR_INVALID_ARGUMENT, std::string(field) + ".view is null");
    return;
  }
  if (image.extent.width < extent.width || image.extent.height < extent.height) {
    fail(REPRISE_ERROR_INVALID_ARGUMENT, std::string(field) + ".extent " + text(image.extent) +
                                             " is smaller than the frame's " + text(extent));
  }
}

void checkInputLayout(const RepriseImage& image, const char* field) {
  if (image.view == VK_NULL_HANDLE) return;
  switch (image.layout) {
    case VK_IMAGE_LAYOUT_GENERAL:
    case VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL:
    case VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL:
      return;
    default:
      fail(REPRISE_ERROR_INVALID_ARGUMENT,
           std::string(field) +
               ".layout must be GENERAL, SHADER_READ_ONLY_OPTIMAL or "
               "DEPTH_STENCIL_READ_ONLY_OPTIMAL");
  }
}

void require(bool holds, const char* message) {
  if (!holds) fail(REPRISE_ERROR_INVALID_ARGUMENT, message);
}

void checkPlanes(const RepriseFrame& frame, RepriseDepthKind kind) {
  if (kind == REPRISE_DEPTH_PLANAR) return;
  require(std::isfinite(frame.near_plane) && frame.near_plane > 0.0f,
          "near_plane must be finite and above 0");
  const bool infinite =
      kind == REPRISE_DEPTH_DEVICE_INFINITE || kind == REPRISE_DEPTH_REVERSED_INFINITE;
  require(infinite || (std::isfinite(frame.far_plane) && frame.far_plane > frame.near_plane),
          "far_plane must be finite and above near_plane for this depth kind");
}

void checkCamera(const RepriseCamera& camera) {
  for (const float element : camera.view) {
    require(std::isfinite(element), "camera.view holds a NaN or infinite element");
  }
  for (const float element : camera.projection) {
    require(std::isfinite(element), "camera.projection holds a NaN or infinite element");
  }
  require(camera.projection[0] != 0.0f && camera.projection[5] != 0.0f,
          "camera.projection has a zero scale");
}

}  // namespace

void checkExtents(const RepriseTechniqueInfo& technique, VkExtent2D max_input,
                  VkExtent2D max_output, VkExtent2D& input, VkExtent2D& output) {
  const bool open_output = output.width == 0 && output.height == 0;
  input = resolvedExtent(input, max_input, "input_extent");
  output = resolvedExtent(output, max_output, "output_extent");
  const bool upsamples = (technique.flags & REPRISE_TECHNIQUE_UPSAMPLES) != 0;
  const bool native = max_input.width == max_output.width && max_input.height == max_output.height;
  // Without upsampling an output extent that is left open follows the input's sub-rectangle.
  if (open_output && (native || !upsamples)) output = input;
  if (!upsamples && (output.width != input.width || output.height != input.height)) {
    fail(REPRISE_ERROR_UNSUPPORTED, "technique '" + std::string(technique.name) +
                                        "' cannot upsample: output_extent " + text(output) +
                                        " must equal input_extent " + text(input));
  }
  if (output.width < input.width || output.height < input.height) {
    fail(REPRISE_ERROR_INVALID_ARGUMENT,
         "output_extent " + text(output) + " must not be below input_extent " + text(input));
  }
}

void checkFrame(const RepriseFrame& frame, const RepriseTechniqueInfo& technique,
                RepriseDepthKind depth_kind, VkExtent2D max_input, VkExtent2D max_output,
                bool shaded, VkExtent2D& input, VkExtent2D& output) {
  require(frame.size == sizeof(RepriseFrame), "frame.size must be sizeof(RepriseFrame)");
  input = frame.input_extent;
  output = frame.output_extent;
  checkExtents(technique, max_input, max_output, input, output);
  checkImage(frame.color, "color", shaded, input);
  checkImage(frame.depth, "depth", true, input);
  checkImage(frame.motion, "motion", true, input);
  checkImage(frame.reactive, "reactive", false, input);
  checkImage(frame.id, "id", false, input);
  checkImage(frame.extra, "extra", false, input);
  checkImage(frame.depth_samples, "depth_samples", false, input);
  checkImage(frame.output, "output", shaded, output);
  require(frame.motion_back_count <= REPRISE_MAX_MOTION_BACK,
          "motion_back_count is above REPRISE_MAX_MOTION_BACK");
  require(frame.motion_back_count == 0 || frame.motion_back != nullptr, "motion_back is null");
  for (uint32_t i = 0; i < frame.motion_back_count; ++i) {
    checkImage(frame.motion_back[i], "motion_back", false, input);
    checkInputLayout(frame.motion_back[i], "motion_back");
  }
  checkInputLayout(frame.extra, "extra");
  checkInputLayout(frame.depth_samples, "depth_samples");
  checkInputLayout(frame.color, "color");
  checkInputLayout(frame.depth, "depth");
  checkInputLayout(frame.motion, "motion");
  checkInputLayout(frame.reactive, "reactive");
  checkInputLayout(frame.id, "id");
  require(std::abs(frame.jitter_px[0]) <= 1.0f && std::abs(frame.jitter_px[1]) <= 1.0f,
          "jitter_px must be in [-1, 1] pixels (is it in uv or NDC?)");
  require(std::isfinite(frame.motion_scale[0]) && std::isfinite(frame.motion_scale[1]) &&
              frame.motion_scale[0] != 0.0f && frame.motion_scale[1] != 0.0f,
          "motion_scale must be finite and not 0; {1, 1} for motion in pixels");
  require(std::isfinite(frame.pre_exposure) && frame.pre_exposure > 0.0f,
          "pre_exposure must be finite and above 0");
  require(std::isfinite(frame.frame_time_s) && frame.frame_time_s >= 0.0f,
          "frame_time_s must be finite and at least 0");
  require(frame.frame_time_s < 10.0f, "frame_time_s is 10 s or more: is it in milliseconds?");
  require(frame.coarse_size <= REPRISE_MAX_COARSE_SIZE,
          "coarse_size is above REPRISE_MAX_COARSE_SIZE");
  const auto coarse = static_cast<int32_t>(frame.coarse_size);
  for (const int32_t origin_px : frame.coarse_origin_px) {
    require(origin_px >= 0 && origin_px < std::max(coarse, 1),
            "coarse_origin_px must be in [0, coarse_size)");
  }
  require(frame.checkerboard <= 2, "checkerboard must be 0, 1 or 2");
  checkPlanes(frame, depth_kind);
  if (frame.camera != nullptr) checkCamera(*frame.camera);
}

}  // namespace reprise
