// SPDX-License-Identifier: MIT
//
// Exact motion of the point that each pixel sampled: prev_px = px + motion, both free of jitter.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "core/workgroup.h"
#include "lab/render/scene_buffers.glsl"

layout(local_size_x = REPRISE_WORKGROUP_SIZE, local_size_y = REPRISE_WORKGROUP_SIZE) in;

layout(binding = 5) writeonly uniform image2D motion_image;
layout(push_constant) uniform Push { MotionConstants push; };

// Both positions come from the same arithmetic, not from the pixel's own coordinates: what did not
// move has a motion of exactly 0.
vec2 projectedPx(vec3 position, uint instance, uint frames_back) {
  precise vec2 px = pxFromClip(clipOf(position, instance, frames_back));
  return px;
}

void main() {
  ivec2 px = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(px, ivec2(frame.extent_px)))) return;
  Triangle triangle;
  vec2 motion_px = vec2(0.0);
  vec2 ndc = (vec2(px) + 0.5 - push.jitter_px) / frame.extent_px * 2.0 - 1.0;
  if (fetchTriangle(px, triangle)) {
    vec3 p0 = vertices[triangle.vertices.x].position_u.xyz;
    vec3 p1 = vertices[triangle.vertices.y].position_u.xyz;
    vec3 p2 = vertices[triangle.vertices.z].position_u.xyz;
    Barycentrics at = barycentricsAt(clipOf(p0, triangle.instance, 0u),
                                     clipOf(p1, triangle.instance, 0u),
                                     clipOf(p2, triangle.instance, 0u), ndc);
    vec3 position = interpolate(at.b, p0, p1, p2);
    motion_px = projectedPx(position, triangle.instance, push.frames_back) -
                projectedPx(position, triangle.instance, 0u);
  }
  imageStore(motion_image, px, vec4(motion_px, 0.0, 0.0));
}
