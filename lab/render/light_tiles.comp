// SPDX-License-Identifier: MIT
//
// Forward+ (Harada et al. 2012): which lamps may reach what a tile of the screen sees. A lamp's
// ball, a cone's smaller one, against the tile's four sides and against the nearest and farthest
// view depth in it.
#version 450
#extension GL_GOOGLE_include_directive : require

#include "lab/render/frame_data.h"

// A quarter of a tile's pixels: each invocation has four, and what is the same for all lamps, the
// tile's sides, is made a quarter as often.
layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 0, std140) uniform Frame {
  GpuFrame frame;
};
layout(binding = 1) uniform sampler2D depth_image;  // reversed, infinite
layout(binding = 2, std430) readonly buffer Lamps {
  GpuLamp lamps[];
};
layout(binding = 3, std430) writeonly buffer LampTiles {
  uint lamp_tiles[];
};
layout(push_constant) uniform Push {
  LightTilesConstants push;
};

layout(constant_id = 0) const uint kLampCount = 0u;

// How far from a pixel's own sample it may be shaded (px): a coarse pixel of four, or a jitter and
// a coarse pixel of two.
const float kShadingReach_px = 2.0;
// Rounding of depth, relative.
const float kDepthSlack = 1.0e-4;

// Bits of depths: not negative, so that they order as the numbers do.
shared uint nearest_bits;
shared uint farthest_bits;
shared uint masks[kLampWords];

// Depths of the invocation's 2 x 2 pixels and of those beside them: 4 x 4 but for the corners.
float depths[4][4];

void fetchDepths(ivec2 first_px, ivec2 last_px) {
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) {
      if (x % 3 == 0 && y % 3 == 0) continue;
      ivec2 px = clamp(first_px + ivec2(x, y) - 1, ivec2(0), last_px);
      depths[y][x] = texelFetch(depth_image, px, 0).x;
    }
  }
}

// Depth is inverse view depth times the near plane, linear over a plane's pixels: how much it
// changes over a pixel, of each axis on the side without a silhouette.
float slopeAt(int x, int y) {
  float own = depths[y][x];
  return min(abs(depths[y][x - 1] - own), abs(depths[y][x + 1] - own)) +
         min(abs(depths[y - 1][x] - own), abs(depths[y + 1][x] - own));
}

struct Ball {
  vec3 center_world;
  float radius_m;
};

// Around all that a lamp reaches.
Ball ballOf(GpuLamp lamp) {
  vec3 position_world = lamp.position_range.xyz;
  float range_m = lamp.position_range.w;
  float cosine = lamp.direction_outer.w;
  if (cosine <= 0.0) return Ball(position_world, range_m);
  float sine = sqrt(max(1.0 - cosine * cosine, 0.0));
  // Through the apex and the rim; where the rim is wider than that, about its circle.
  bool narrow = cosine > sine;
  float along = narrow ? 0.5 * range_m / cosine : cosine * range_m;
  return Ball(position_world + along * lamp.direction_outer.xyz, narrow ? along : sine * range_m);
}

// A side of the tile, clip coordinate `axis` times `side` below `bound` times w, as a plane whose
// distances are positive inside.
struct Side {
  vec4 plane;
  float scale;
};
Side sideOf(mat4 rows, int axis, float bound, float side) {
  vec4 plane = side * (bound * rows[3] - rows[axis]);
  return Side(plane, length(plane.xyz));
}

bool reaches(Ball ball, Side sides[4], vec4 depth_row, float nearest_m, float farthest_m) {
  vec4 center = vec4(ball.center_world, 1.0);
  float depth_m = dot(depth_row, center);
  bool in_depth = depth_m - ball.radius_m <= farthest_m && depth_m + ball.radius_m >= nearest_m;
  float inside = dot(sides[0].plane, center) / sides[0].scale;
  for (int i = 1; i < 4; ++i) inside = min(inside, dot(sides[i].plane, center) / sides[i].scale);
  return in_depth && inside >= -ball.radius_m;
}

void main() {
  uint thread = gl_LocalInvocationIndex;
  ivec2 first_px = ivec2(gl_WorkGroupID.xy * kLightTile_px + 2u * gl_LocalInvocationID.xy);
  ivec2 last_px = ivec2(frame.extent_px) - 1;
  if (thread == 0u) {
    nearest_bits = 0u;
    farthest_bits = 0xffffffffu;
  }
  if (thread < kLampWords) masks[thread] = 0u;
  barrier();
  uint nearest = 0u;
  uint farthest = 0xffffffffu;
  fetchDepths(first_px, last_px);
  for (int y = 1; y < 3; ++y) {
    for (int x = 1; x < 3; ++x) {
      float depth = depths[y][x];
      if (any(greaterThan(first_px + ivec2(x, y) - 1, last_px)) || !(depth > 0.0)) continue;
      float reach = kShadingReach_px * slopeAt(x, y) + kDepthSlack * depth;
      nearest = max(nearest, floatBitsToUint(depth + reach));
      farthest = min(farthest, floatBitsToUint(max(depth - reach, 0.0)));
    }
  }
  atomicMax(nearest_bits, nearest);
  atomicMin(farthest_bits, farthest);
  barrier();
  float nearest_m = push.near_plane / max(uintBitsToFloat(nearest_bits), 1.0e-30);
  float farthest_m = push.near_plane / max(uintBitsToFloat(farthest_bits), 1.0e-30);
  vec2 low_px = vec2(gl_WorkGroupID.xy * kLightTile_px) - push.jitter_px - kShadingReach_px;
  vec2 high_px = low_px + float(kLightTile_px) + 2.0 * kShadingReach_px;
  vec2 low_ndc = low_px / frame.extent_px * 2.0 - 1.0;
  vec2 high_ndc = high_px / frame.extent_px * 2.0 - 1.0;
  bool any_surface = nearest_bits != 0u;
  mat4 rows = transpose(frame.view_projection[0]);
  Side sides[4] = Side[4](sideOf(rows, 0, high_ndc.x, 1.0), sideOf(rows, 0, low_ndc.x, -1.0),
                          sideOf(rows, 1, high_ndc.y, 1.0), sideOf(rows, 1, low_ndc.y, -1.0));
  for (uint i = thread; i < kLampCount; i += gl_WorkGroupSize.x * gl_WorkGroupSize.y) {
    bool wanted = push.cull == 0u;
    if (!wanted && any_surface) {
      wanted = reaches(ballOf(lamps[i]), sides, rows[3], nearest_m, farthest_m);
    }
    if (wanted) atomicOr(masks[i / 32u], 1u << (i % 32u));
  }
  barrier();
  uint tile = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
  if (thread < kLampWords) lamp_tiles[kLampWords * tile + thread] = masks[thread];
}
