// SPDX-License-Identifier: MIT
//
// Exact motion of the point that each pixel sampled: prev_px = px + motion, both free of jitter.
// Images of four channels get its view depth, now and then, too.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/workgroup.h"
#include "lab/render/scene_buffers.glsl"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

layout(binding = 4) uniform samplerBuffer previous_world_texels;
layout(binding = 5) writeonly uniform image2D motion_image;
layout(push_constant) uniform Push {
  MotionConstants push;
};

// Of what nothing covers: kBackgroundDepth of lab/frame_geometry.h.
const float kBackgroundDepth = 1.0e10;

// xy: px, z: view depth, which is clip.w. Both positions come from the same arithmetic, not from
// the pixel's own coordinates: what did not move has a motion of exactly 0.
vec3 projectedPx(vec3 position_world, uint frames_back) {
  vec4 clip = clipFromWorld(position_world, frames_back);
  precise vec2 px = pxFromClip(clip);
  return vec3(px, clip.w);
}

void main() {
  ivec2 px = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(px, ivec2(frame.extent_px)))) return;
  VisibleTriangle seen;
  vec3 now_px = vec3(0.0, 0.0, kBackgroundDepth);
  vec3 then_px = now_px;
  vec2 ndc = (vec2(px) + 0.5 - push.jitter_px) / frame.extent_px * 2.0 - 1.0;
  if (fetchTriangle(px, seen)) {
    uvec4 triangle = seen.triangle;
    vec3 p0 = positionU(triangle.x).xyz;
    vec3 p1 = positionU(triangle.y).xyz;
    vec3 p2 = positionU(triangle.z).xyz;
    vec3 b =
        barycentricsAt(clipFromWorld(p0, 0u), clipFromWorld(p1, 0u), clipFromWorld(p2, 0u), ndc).b;
    vec3 now_world = interpolate(b, p0, p1, p2);
    vec3 then_world = interpolate(b, texelFetch(previous_world_texels, int(triangle.x)).xyz,
                                  texelFetch(previous_world_texels, int(triangle.y)).xyz,
                                  texelFetch(previous_world_texels, int(triangle.z)).xyz);
    then_px = projectedPx(then_world, push.frames_back);
    now_px = projectedPx(now_world, 0u);
  }
  imageStore(motion_image, px, vec4(then_px.xy - now_px.xy, now_px.z, then_px.z));
}
