// SPDX-License-Identifier: MIT
#include "reprise/reprise.h"
// reprise.h first: frame_constants.h is shared with GLSL and includes no Vulkan header.
#include "core/frame_constants.h"
#include "core/technique.h"

namespace reprise {
namespace {

vec2 toVec2(VkExtent2D extent) {
  return vec2(static_cast<float>(extent.width), static_cast<float>(extent.height));
}

// d(view_depth)/d(depth) of (x d + y) / (z d + w) has the sign of x w - y z wherever it is defined.
float depthOrder(const vec4& k) {
  return k.x * k.w - k.y * k.z >= 0.0f ? 1.0f : -1.0f;
}

}  // namespace

FrameConstants frameConstants(const FrameState& state, VkExtent2D history_extent) {
  FrameConstants constants{};
  constants.view_depth_coefficients = state.view_depth_coefficients;
  constants.previous_depth_coefficients = state.previous_depth_coefficients;
  constants.motion_scale = vec2(state.frame.motion_scale[0], state.frame.motion_scale[1]);
  constants.motion_offset_px = state.motion_offset_px;
  constants.jitter_px = state.jitter_px;
  constants.previous_jitter_px = state.previous_jitter_px;
  constants.extent_px = toVec2(state.input_extent);
  constants.previous_extent_px = toVec2(state.previous_input_extent);
  const vec2 history_px = toVec2(history_extent);
  constants.history_texel_uv = vec2(1.0f / history_px.x, 1.0f / history_px.y);
  constants.exposure_ratio = state.exposure_ratio;
  constants.has_history = state.has_history ? 1.0f : 0.0f;
  constants.depth_order = depthOrder(state.view_depth_coefficients);
  constants.reactive_given = state.frame.reactive.view != VK_NULL_HANDLE ? 1.0f : 0.0f;
  constants.id_given = state.frame.id.view != VK_NULL_HANDLE ? 1.0f : 0.0f;
  constants.frame_number = static_cast<float>(state.record & 0xfffffu);
  return constants;
}

}  // namespace reprise
