// SPDX-License-Identifier: MIT
//
// What shade.comp and coarse.comp do, as a rasterizer does it: a fragment of one pixel, or of a
// coarse pixel where the device has such, shades the triangle that it is of.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_arithmetic : require

#include "equations/shading_offset.h"
#include "lab/render/shade_triangle.glsl"
#include "lab/render/coarse_pixel.glsl"

// Or hidden fragments would count: a shader that writes to a buffer is otherwise run for all.
layout(early_fragment_tests) in;

layout(push_constant) uniform Push {
  RasterConstants push;
};
layout(location = 0) flat in uint triangle;
layout(location = 0) out vec4 color;

// The fragment's pixels that show what visibility calls `key`.
uint showing(uvec2 key, ivec2 base_px) {
  uint shown_in = 0u;
  for (int i = 0; i < kPixels; ++i) {
    ivec2 px = pixelOf(base_px, i);
    if (!withinFrame(px)) continue;
    uvec2 visible =
        texelFetch(visibility_image, px + ivec2(push.shift_x_px, push.shift_y_px), 0).xy;
    if (visible == key) shown_in |= 1u << i;
  }
  return shown_in;
}

void main() {
  shown_light_layers = push.shade.light_layers;
  // gl_FragCoord is the middle of a fragment. Rounded down, so that a device that shades smaller
  // ones than it was asked for makes the same image.
  ivec2 base_px = ivec2(gl_FragCoord.xy) / kSize * kSize - ivec2(push.shift_x_px, push.shift_y_px);
  uint shown_in = showing(uvec2(push.draw.instance + 1u, triangle), base_px);
  // Of triangles of one depth visibility shows the first, and the depth test lets all through.
  if (shown_in == 0u) discard;
  if (!gl_HelperInvocation) atomicAdd(evaluations, 1u);

  ivec2 first_px = pixelOf(base_px, findLSB(shown_in));
  selectLightTile(tilePixelOf(base_px, shown_in));
  VisibleTriangle seen =
      VisibleTriangle(texelFetch(triangle_texels, int(triangle)), push.draw.instance);
  vec2 jitter_px = push.shade.unjitter == 0u ? push.shade.jitter_px : vec2(0.0);
  vec2 sample_px = vec2(first_px) + 0.5 - jitter_px;
  if (kSize > 1) {
    sample_px = coarsePosition(seen, base_px, shown_in, jitter_px, push.shade_covered != 0u);
  } else if (push.shade.offset_on != 0u) {
    sample_px += shadingOffset(uint(first_px.x), uint(first_px.y), push.shade.offset_seed,
                               push.shade.offset_sigma_px, push.shade.offset_quadrant);
  }
  color = vec4(shadeTriangle(seen, sample_px), 1.0);
}
