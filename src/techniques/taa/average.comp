// SPDX-License-Identifier: MIT
//
// The mean of the last raw frames, reprojected, without feedback (Valient 2014): nothing is
// resampled twice and nothing older than the window can ghost, at the price of few samples. Motion
// is chained from frame to frame (eq. 8).
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/frame_inputs.glsl"
#include "core/workgroup.h"
#include "techniques/taa/options.glsl"
#include "techniques/taa/taa_shared.h"
#include "techniques/taa/neighbourhood.glsl"
#include "techniques/taa/history.glsl"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

layout(binding = 0) uniform sampler2D color_image;
layout(binding = 1) uniform sampler2D depth_image;
layout(binding = 2) uniform sampler2D motion_image;
// Frame t - i: rgb the raw colour; x the motion to t - i - 1 as two halves in px, y the bits of
// view depth.
layout(binding = 3) uniform sampler2D color_1;
layout(binding = 4) uniform sampler2D color_2;
layout(binding = 5) uniform sampler2D color_3;
layout(binding = 6) uniform sampler2D color_4;
layout(binding = 7) uniform sampler2D color_5;
layout(binding = 8) uniform usampler2D surface_1;
layout(binding = 9) uniform usampler2D surface_2;
layout(binding = 10) uniform usampler2D surface_3;
layout(binding = 11) uniform usampler2D surface_4;
layout(binding = 12) uniform usampler2D surface_5;
layout(binding = 13) writeonly uniform image2D next_color_image;
layout(binding = 14) writeonly uniform uimage2D next_surface_image;
layout(binding = 15) writeonly uniform image2D resolved_image;  // for the sharpening pass
layout(binding = 16) writeonly uniform image2D output_image;
layout(binding = 17, std140) uniform Constants {
  TaaConstants k;
};

struct Walk {
  vec2 px;           // where this pixel's point was in the frame reached
  float view_depth;  // of the surface met there
  bool valid;        // false: left the frame, or another surface covered it
  vec3 sum;
  float count;
};

// One frame back. `held` is how many earlier frames there are.
Walk stepBack(Walk walk, sampler2D color, usampler2D surface, float age, vec3 current,
              vec3 samples[9]) {
  vec2 last_center_px = k.frame.extent_px - 0.5;
  bool inside = isOnScreen(walk.px, k.frame.extent_px);
  vec2 inside_px = clamp(walk.px, vec2(0.5), last_center_px);
  uvec2 packed = texelFetch(surface, ivec2(inside_px), 0).xy;
  float view_depth = uintBitsToFloat(packed.y);
  bool agree =
      kDepthTest == kDepthTestNone || walk.view_depth <= view_depth * (1.0 + k.depth_tolerance);
  walk.valid = walk.valid && inside && agree && age < k.average_frames;
  vec4 texel = filteredHistory(color, inside_px, k.frame.history_texel_uv, last_center_px,
                               k.history_sharpness);
  vec3 past = toWorking(sanitizedColor(texel.rgb * k.frame.exposure_ratio));
  past = rectified(past, current, samples, k.gamma, 1.0);
  if (walk.valid) {
    walk.sum += past;
    walk.count += 1.0;
  }
  walk.px += unpackHalf2x16(packed.x);
  walk.view_depth = view_depth;
  return walk;
}

void main() {
  ivec2 px = ivec2(gl_GlobalInvocationID.xy);
  ivec2 last_px = ivec2(k.frame.extent_px) - 1;
  if (any(greaterThan(px, last_px))) return;

  vec3 samples[9];
  for (int i = 0; i < 9; ++i) {
    samples[i] = toWorking(fetchColor(color_image, px + ivec2(i % 3 - 1, i / 3 - 1), last_px));
  }
  vec3 current = filteredSample(samples, k);
  float view_depth = viewDepth(k.frame, texelFetch(depth_image, px, 0).x);
  vec2 motion_px = motionPx(k.frame, texelFetch(motion_image, px, 0).xy);

  Walk walk = Walk(vec2(px) + 0.5 + motion_px, view_depth, k.frame.has_history > 0.5, current, 1.0);
  walk = stepBack(walk, color_1, surface_1, 1.0, current, samples);
  walk = stepBack(walk, color_2, surface_2, 2.0, current, samples);
  walk = stepBack(walk, color_3, surface_3, 3.0, current, samples);
  walk = stepBack(walk, color_4, surface_4, 4.0, current, samples);
  walk = stepBack(walk, color_5, surface_5, 5.0, current, samples);
  vec3 result = fromWorking(walk.sum / walk.count);

  imageStore(next_color_image, px, vec4(fetchColor(color_image, px, last_px), 1.0));
  // Halves hold motion to 1/1024 of itself; farther than the frame is off screen anyway.
  vec2 kept_motion_px = clamp(motion_px, vec2(-60000.0), vec2(60000.0));
  imageStore(next_surface_image, px,
             uvec4(packHalf2x16(kept_motion_px), floatBitsToUint(view_depth), 0u, 0u));
  if (kWriteOutput != 0u) {
    imageStore(output_image, px, vec4(result, 1.0));
  } else {
    imageStore(resolved_image, px, vec4(result, 1.0));
  }
}
