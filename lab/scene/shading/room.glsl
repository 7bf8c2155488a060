// SPDX-License-Identifier: MIT
// What a mirror sees of the scene `indoor`: its empty room, as a box whose walls, floor and ceiling
// have cheap versions of their patterns.
#ifndef REPRISE_LAB_ROOM_GLSL
#define REPRISE_LAB_ROOM_GLSL

#include "equations/hash.h"
#include "lab/scene/indoor/room_measures.h"
#include "lab/scene/shading/lighting.glsl"
#include "lab/scene/shading/surface_point.glsl"

const vec3 kRoomLow_m = vec3(-0.5 * kRoomWidth_m, 0.0, -0.5 * kRoomLength_m);
const vec3 kRoomHigh_m = vec3(0.5 * kRoomWidth_m, kRoomHeight_m, 0.5 * kRoomLength_m);
// How bright a white wall is on average: about what the room's lamps give, chosen by eye.
const vec3 kRoomGlow = vec3(0.62, 0.55, 0.47);

vec3 roomWall(vec2 at_m) {
  vec2 brick = vec2(0.235, 0.077);
  float row = floor(at_m.y / brick.y);
  float x = at_m.x / brick.x + fract(0.5 * row);
  vec2 within = abs(fract(vec2(x, at_m.y / brick.y)) - 0.5);
  if (within.x > 0.475 || within.y > 0.43) return vec3(0.45, 0.42, 0.38);
  float tint = unitFloat(hashPixel(uint(int(floor(x))), uint(int(row)), 11u));
  return mix(vec3(0.24, 0.07, 0.04), vec3(0.42, 0.20, 0.11), tint);
}

vec3 roomFloor(vec2 at_m) {
  ivec2 tile = ivec2(floor(at_m / 0.5));
  return ((tile.x + tile.y) & 1) != 0 ? vec3(0.06, 0.075, 0.07) : vec3(0.70, 0.68, 0.63);
}

vec3 roomSeen(vec3 from_world, vec3 way) {
  vec3 safe_way = mix(vec3(1.0e-6), way, greaterThan(abs(way), vec3(1.0e-6)));
  vec3 reach = max((kRoomLow_m - from_world) / safe_way, (kRoomHigh_m - from_world) / safe_way);
  float t = min(reach.x, min(reach.y, reach.z));
  vec3 at = from_world + t * way;
  if (t == reach.y) {
    if (way.y < 0.0) return kRoomGlow * roomFloor(at.xz);
    // Two lamps on a dark ceiling.
    float lamp = min(distance(at.xz, vec2(kLampAX_m, kLampAZ_m)),
                     distance(at.xz, vec2(kLampBX_m, kLampBZ_m)));
    return lamp < 0.28 ? vec3(5.0, 4.4, 3.4) : kRoomGlow * vec3(0.20, 0.13, 0.07);
  }
  return kRoomGlow * roomWall(t == reach.x ? at.zy : at.xy);
}

// Schlick's rise towards grazing is part of the answer; the rest is the material's share.
vec3 roomMirrored(SurfacePoint s, vec3 normal_world) {
  if ((shown_light_layers & kLightLayerMain) == 0u) return vec3(0.0);
  vec3 way = reflect(-s.to_eye_world, normal_world);
  float grazing = 1.0 - clamp(dot(normal_world, s.to_eye_world), 0.0, 1.0);
  float rise = grazing * grazing;
  return roomSeen(s.position_world, way) * (0.35 + 0.65 * rise * rise * grazing);
}

#endif
